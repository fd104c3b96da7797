// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Takes the place of the header of TBB in builds with thread sanitizer, which cannot see how the library of TBB
// synchronises its threads: the loops of the package and of CGAL run on std::thread. That a thread takes
// the next indices orders nothing, so that races between indices are seen.

#ifndef POINT_SET_CONSOLIDATION_3_THREAD_SANITIZER_PARALLEL_FOR_H
#define POINT_SET_CONSOLIDATION_3_THREAD_SANITIZER_PARALLEL_FOR_H

#include <tbb/blocked_range.h>

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb {

template <typename Value, typename Body>
void parallel_for(const blocked_range<Value>& range, const Body& body)
{
  std::atomic<Value> next{range.begin()};
  std::mutex mutex;
  std::exception_ptr error;
  const auto work = [&] {
    const Value grain = static_cast<Value>(range.grainsize());
    try {
      for(;;) {
        const Value begin = next.fetch_add(grain, std::memory_order_relaxed);
        if(!(begin < range.end()))
          return;
        body(blocked_range<Value>(begin, begin + grain < range.end() ? begin + grain : range.end()));
      }
    }
    catch(...) {
      const std::lock_guard<std::mutex> lock(mutex);
      error = std::current_exception();
    }
  };
  constexpr int helpers = 3;
  std::vector<std::thread> threads;
  for(int k = 0; k < helpers; ++k)
    threads.emplace_back(work);
  work();
  for(std::thread& thread : threads)
    thread.join();
  if(error)
    std::rethrow_exception(error);
}

}  // namespace tbb

#endif  // POINT_SET_CONSOLIDATION_3_THREAD_SANITIZER_PARALLEL_FOR_H
