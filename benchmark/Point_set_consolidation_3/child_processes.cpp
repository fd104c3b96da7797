// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "child_processes.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>

namespace benchmark {

namespace {

/// Exit status of a child whose task threw; the message went to stderr.
constexpr int task_failed = 17;

pid_t start(const std::function<void()>& task, unsigned int timeout_seconds)
{
  std::cout.flush();
  const pid_t child = fork();
  if(child < 0)
    throw std::runtime_error("cannot start a process");
  if(child > 0)
    return child;
  // SIGALRM ends the process
  if(timeout_seconds > 0)
    alarm(timeout_seconds);
  int status = EXIT_SUCCESS;
  try {
    task();
  } catch(const std::exception& error) {
    std::cerr << error.what() << "\n";
    status = task_failed;
  }
  std::cout.flush();
  _exit(status);  // the parent's open files and static objects are not the child's to close
}

std::string describe(int status)
{
  if(WIFEXITED(status)) {
    if(WEXITSTATUS(status) == EXIT_SUCCESS)
      return "";
    return WEXITSTATUS(status) == task_failed ? "failed" : "ended early";
  }
  const int signal = WTERMSIG(status);
  return signal == SIGALRM ? "took too long" : "crashed (signal " + std::to_string(signal) + ")";
}

}  // namespace

std::string run_in_child(const std::function<void()>& task, unsigned int timeout_seconds)
{
  const pid_t child = start(task, timeout_seconds);
  int status = 0;
  if(waitpid(child, &status, 0) < 0)
    throw std::runtime_error("cannot wait for a process");
  return describe(status);
}

void run_in_children(std::size_t count, std::size_t jobs,
                     const std::function<void(std::size_t)>& task)
{
  std::size_t running = 0;
  for(std::size_t i = 0; i < count || running > 0;) {
    if(i < count && running < jobs) {
      start([&] { task(i); }, 0);
      ++running;
      ++i;
    } else {
      int status = 0;
      if(wait(&status) > 0)
        --running;
    }
  }
}

}  // namespace benchmark
