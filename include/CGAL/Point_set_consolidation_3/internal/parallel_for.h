// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PARALLEL_FOR_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PARALLEL_FOR_H

#include <CGAL/Point_set_consolidation_3/internal/execution.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>
#endif

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// The one parallel loop, and long calls into CGAL.

/// Indices that a thread takes at a time, at least: a few, with which overhead is not measurable (64 neighbour sums are
/// about 0.1 ms), or one, where the body is as long itself.
constexpr std::size_t short_bodies = 64, long_bodies = 1;

#ifdef CGAL_LINKED_WITH_TBB
/// Calls `run(body, begin, end)` for ranges that cover [0, n), by several threads. The type of the body is hidden, so
/// that a program has one loop of TBB and not one for each body.
inline void parallel_ranges(std::size_t n, std::size_t grain,
                            void (*run)(const void* body, std::size_t begin, std::size_t end), const void* body)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                    [=](const tbb::blocked_range<std::size_t>& range) { run(body, range.begin(), range.end()); });
}
#endif

/// Calls `body(i)` for i in [0, n). `body` writes only to slots of its own i, so that the result is the
/// same for any number of threads.
template <typename Body>
void parallel_for(const Execution& execution, std::size_t n, const Body& body, std::size_t grain = short_bodies)
{
  const auto run = [](const void* hidden, std::size_t begin, std::size_t end) {
    const Body& body = *static_cast<const Body*>(hidden);
    for(std::size_t i = begin; i < end; ++i)
      body(i);
  };
#ifdef CGAL_LINKED_WITH_TBB
  if(execution.parallel) {
    parallel_ranges(n, grain, run, &body);
    return;
  }
#else
  (void)execution;
  (void)grain;
#endif
  run(&body, 0, n);
}

/// Calls `first` on this thread, since it may report progress, and `second` beside it if a thread is free, else after it
/// and only if `first` has not thrown. Both have ended when this returns or throws.
template <typename First, typename Second>
void run_both(const Execution& execution, const First& first, const Second& second)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(execution.parallel) {
    std::atomic<bool> has_failed{false};
    tbb::task_group group;
    group.run([&] {
      if(!has_failed)
        second();
    });
    std::exception_ptr error;
    try {
      first();
    }
    catch(...) {
      error = std::current_exception();
      has_failed = true;
    }
    try {
      group.wait();
    }
    catch(...) {
      if(!error)
        error = std::current_exception();
    }
    if(error)
      std::rethrow_exception(error);
    return;
  }
#else
  (void)execution;
#endif
  first();
  second();
}

/// Runs `work(observer)`, a long call into CGAL whose own callback may come from another thread
/// (CGAL's parallel functions poll from a helper thread). The user's callback stays on the calling
/// thread: when it is needed, the work moves to a helper thread and the caller waits and reports.
template <typename Work>
void run_observed(Stage& stage, const Execution& execution, const Work& work)
{
  if(!execution.progress.is_observed()) {
    work(std::function<bool(double)>());
    return;
  }
  if(!execution.parallel) {
    bool cancelled = false;
    std::exception_ptr error;
    work([&](double fraction) {
      if(cancelled)
        return false;
      try {
        stage.update(fraction);
      }
      catch(...) {
        cancelled = true;
        error = std::current_exception();
      }
      return !cancelled;
    });
    if(error)
      std::rethrow_exception(error);
    return;
  }

  std::atomic<double> fraction{0};
  std::atomic<bool> stop{false};
  std::mutex mutex;
  std::condition_variable wake;
  bool done = false;
  std::exception_ptr work_error, callback_error;
  std::thread worker([&] {
    try {
      work([&](double f) { fraction = f; return !stop.load(); });
    }
    catch(...) {
      work_error = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(mutex);
    done = true;
    wake.notify_one();
  });
  {
    std::unique_lock<std::mutex> lock(mutex);
    while(!wake.wait_for(lock, std::chrono::milliseconds(20), [&] { return done; })) {
      if(stop)
        continue;
      lock.unlock();
      try {
        stage.update(fraction);
      }
      catch(...) {
        callback_error = std::current_exception();
        stop = true;
      }
      lock.lock();
    }
  }
  worker.join();
  if(callback_error)
    std::rethrow_exception(callback_error);
  if(work_error)
    std::rethrow_exception(work_error);
}

/// Calls `work` with CGAL's tag for the way this runs.
template <typename Work>
void with_concurrency_tag(const Execution& execution, const Work& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(execution.parallel) {
    work(Parallel_tag());
    return;
  }
#else
  (void)execution;
#endif
  work(Sequential_tag());
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_PARALLEL_FOR_H
