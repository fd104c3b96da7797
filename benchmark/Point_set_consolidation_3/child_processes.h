// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_CHILD_PROCESSES_H
#define CONSOLIDATION_BENCHMARK_CHILD_PROCESSES_H

#include <cstddef>
#include <functional>
#include <string>

namespace benchmark {

/// Runs `task` in a child process, so that a crash, an endless loop or a leak of one method costs one row of a
/// table and not the table. What the task computes must go through files. Returns what went wrong, or "".
std::string run_in_child(const std::function<void()>& task, unsigned int timeout_seconds);

/// Runs tasks 0 ... count-1, each in a child process, at most `jobs` at a time, in this order.
void run_in_children(std::size_t count, std::size_t jobs,
                     const std::function<void(std::size_t)>& task);

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_CHILD_PROCESSES_H
