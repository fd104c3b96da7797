// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every function, sequential and parallel: progress is monotone, comes from the calling thread and ends at
// 1; a stop at 20 points of progress, an exception of the callback and one of a property map leave the
// output as it was.

#undef NDEBUG

#include "every_function/clouds.h"

#include <cassert>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>

namespace {

using namespace every_function;
using Clock = std::chrono::steady_clock;

struct Stop {};

// Sets of this size take up to a second or two; a stopped call returns well before.
constexpr double seconds_until_return = 10;

bool takes_no_callback(const Function& function)
{
  const std::string name = function.name;
  return name == "Algebraic_point_set_surface_3" || name == "complete_point_set_along_skeleton";
}

/// The number of calls of the callback.
std::size_t observe(const Function& function, const Cloud& cloud, bool parallel)
{
  const std::thread::id caller = std::this_thread::get_id();
  double last = 0;
  std::size_t calls = 0;
  Run run;
  run.parallel = parallel;
  run.callback = [&](double fraction) {
    assert(std::this_thread::get_id() == caller);
    assert(fraction >= last && fraction <= 1);
    last = fraction;
    ++calls;
    return true;
  };
  Output output;
  function.call(cloud, run, output);
  // the stages before the last one end below 1
  const std::string name = function.name;
  const bool is_a_part = name == "Deep_points_consolidation_3" || name == "meso_skeleton_to_graph";
  assert(calls > 0 && (last == 1 || is_a_part));
  return calls;
}

/// Stops, or throws, at the call of this number.
void interrupt(const Function& function, const Cloud& cloud, bool parallel, std::size_t at, bool throws)
{
  std::size_t calls = 0;
  Clock::time_point moment = Clock::now();
  Run run;
  run.parallel = parallel;
  run.callback = [&](double) {
    if(++calls < at)
      return true;
    assert(calls == at);  // never asked again
    moment = Clock::now();
    if(throws)
      throw Stop();
    return false;
  };
  Output output;
  bool was_thrown = false;
  try {
    function.call(cloud, run, output);
  }
  catch(const Stop&) {
    was_thrown = true;
  }
  if(calls < at)
    return;  // a parallel call polls by the clock and may ask fewer times
  assert(was_thrown == throws);
  assert(output.is_untouched);
  assert(std::chrono::duration<double>(Clock::now() - moment).count() < seconds_until_return);
}

/// Every access to a map may fail; those of the results are left out.
void fail_in_maps(const Function& function, const Cloud& cloud, bool parallel)
{
  const long reads = long(cloud.samples.size());
  for(const long access : {1L, reads / 2, reads, reads + 1, 2 * reads}) {
    Run run;
    run.parallel = parallel;
    run.accesses_left = access;
    Output output;
    bool was_thrown = false;
    try {
      function.call(cloud, run, output);
    }
    catch(const Map_failure&) {
      was_thrown = true;
    }
    assert(was_thrown == (run.accesses_left == 0));
    assert(was_thrown || access > reads);  // each position is read at least once
    assert(!was_thrown || output.is_untouched);
  }
}

}  // namespace

int main(int argc, char* argv[])
{
  const Cloud cloud = open_capsule(300, 11);
  for(const Function& function : all_functions()) {
    if(argc > 1 && std::string(function.name).find(argv[1]) == std::string::npos)
      continue;
    for(const bool parallel : {false, true}) {
      std::cout << function.name << (parallel ? ", parallel" : ", sequential") << std::flush;
      fail_in_maps(function, cloud, parallel);
      if(takes_no_callback(function)) {
        std::cout << std::endl;
        continue;
      }
      const std::size_t calls = observe(function, cloud, parallel);
      std::cout << ": " << calls << " calls" << std::endl;
      constexpr std::size_t places = 20;
      for(std::size_t k = 0; k < places && k < calls; ++k) {
        const std::size_t at = calls <= places ? k + 1 : 1 + k * (calls - 1) / (places - 1);
        interrupt(function, cloud, parallel, at, false);
        if(k % 5 == 0)
          interrupt(function, cloud, parallel, at, true);
      }
    }
  }
  return EXIT_SUCCESS;
}
