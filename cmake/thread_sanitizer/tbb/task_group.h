// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Takes the place of the header of TBB in builds with thread sanitizer, as parallel_for.h does: each task runs on a
// std::thread of its own.

#ifndef POINT_SET_CONSOLIDATION_3_THREAD_SANITIZER_TASK_GROUP_H
#define POINT_SET_CONSOLIDATION_3_THREAD_SANITIZER_TASK_GROUP_H

#include <exception>
#include <future>
#include <utility>
#include <vector>

namespace tbb {

class task_group {
public:
  template <typename Task>
  void run(Task&& task)
  {
    m_tasks.push_back(std::async(std::launch::async, std::forward<Task>(task)));
  }

  void wait()
  {
    std::exception_ptr error;
    for(std::future<void>& task : m_tasks)
      try {
        task.get();
      }
      catch(...) {
        error = std::current_exception();
      }
    m_tasks.clear();
    if(error)
      std::rethrow_exception(error);
  }

private:
  std::vector<std::future<void>> m_tasks;
};

}  // namespace tbb

#endif  // POINT_SET_CONSOLIDATION_3_THREAD_SANITIZER_TASK_GROUP_H
