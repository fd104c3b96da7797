// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every function, sequential and parallel: progress is monotone, comes from the calling thread and ends at
// 1; a stop at 20 points of progress, an exception of the callback and one of a property map leave the
// output as it was, and the callback is not called again. Printed are the longest time between two calls of the
// callback, that of the whole call, and the longest from a stop to the return.

#undef NDEBUG

#include "every_function/clouds.h"

#include <algorithm>
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

double seconds_since(Clock::time_point moment)
{
  return std::chrono::duration<double>(Clock::now() - moment).count();
}

struct Observation {
  std::size_t calls = 0;
  double longest_wait = 0, whole = 0;  ///< seconds
};

Observation observe(const Function& function, const Cloud& cloud, bool parallel)
{
  const std::thread::id caller = std::this_thread::get_id();
  double last = 0;
  Observation observation;
  const Clock::time_point start = Clock::now();
  Clock::time_point last_call = start;
  Run run;
  run.parallel = parallel;
  run.callback = [&](double fraction) {
    observation.longest_wait = (std::max)(observation.longest_wait, seconds_since(last_call));
    last_call = Clock::now();
    assert(std::this_thread::get_id() == caller);
    assert(fraction >= last && fraction <= 1);
    last = fraction;
    ++observation.calls;
    return true;
  };
  Output output;
  function.call(cloud, run, output);
  observation.longest_wait = (std::max)(observation.longest_wait, seconds_since(last_call));
  observation.whole = seconds_since(start);
  // the stages before the last one end below 1
  const std::string name = function.name;
  const bool is_a_part = name == "Deep_points_consolidation_3" || name == "meso_skeleton_to_graph";
  assert(observation.calls > 0 && (last == 1 || is_a_part));
  return observation;
}

/// Stops, or throws, at the call of this number. Returns the seconds until the function returned.
double interrupt(const Function& function, const Cloud& cloud, bool parallel, std::size_t at, bool throws)
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
  const double seconds = seconds_since(moment);
  if(calls < at)
    return 0;  // a parallel call polls by the clock and may ask fewer times
  assert(was_thrown == throws);
  assert(output.is_untouched);
  assert(seconds < seconds_until_return);
  return seconds;
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
      const Observation observation = observe(function, cloud, parallel);
      const std::size_t calls = observation.calls;
      std::cout << ": " << calls << " calls, at most " << observation.longest_wait << " s apart, of "
                << observation.whole << " s" << std::flush;
      double longest_return = 0;
      constexpr std::size_t places = 20;
      for(std::size_t k = 0; k < places && k < calls; ++k) {
        const std::size_t at = calls <= places ? k + 1 : 1 + k * (calls - 1) / (places - 1);
        longest_return = (std::max)(longest_return, interrupt(function, cloud, parallel, at, false));
        if(k % 5 == 0)
          longest_return = (std::max)(longest_return, interrupt(function, cloud, parallel, at, true));
      }
      std::cout << ", returned within " << longest_return << " s" << std::endl;
    }
  }
  return EXIT_SUCCESS;
}
