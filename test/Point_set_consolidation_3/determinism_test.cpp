// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every function: the same bits for `Sequential_tag`, again, and for `Parallel_tag` with 1, 2, 4 and 8
// threads. A call that is repeated leaves no memory behind.

#undef NDEBUG

#include "every_function/clouds.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cassert>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

using namespace every_function;

std::vector<double> result(const Function& function, const Cloud& cloud, bool parallel)
{
  Run run;
  run.parallel = parallel;
  Output output;
  function.call(cloud, run, output);
  std::vector<double> all = output.numbers;
  for(const Point& p : output.points)
    all.insert(all.end(), {p.x(), p.y(), p.z()});
  for(const Vector& n : output.normals)
    all.insert(all.end(), {n.x(), n.y(), n.z()});
  return all;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

/// Anything kept for each of the points takes more; what the library keeps back for itself, less.
constexpr std::size_t least_cache = 4096;

/// Bytes in use; 0 if the library cannot tell.
std::size_t bytes_in_use()
{
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 33)
  return ::mallinfo2().uordblks;
#else
  return 0;
#endif
}

}  // namespace

int main(int argc, char* argv[])
{
  // With noise; more points than a grain of the parallel loops.
  Cloud cloud = open_capsule(700, 12);
  Numbers numbers(13);
  for(Sample& s : cloud.samples)
    s.point = s.point + 0.03 * numbers.signed_unit() * s.normal;
  for(const Function& function : all_functions()) {
    if(argc > 1 && std::string(function.name).find(argv[1]) == std::string::npos)
      continue;
    std::cout << function.name << std::flush;
    const std::vector<double> reference = result(function, cloud, false);
    std::cout << ": " << reference.size() << " numbers" << std::endl;
    assert(same_bits(reference, result(function, cloud, false)));
    const std::size_t in_use = bytes_in_use();
    assert(same_bits(reference, result(function, cloud, false)));
    assert(bytes_in_use() < in_use + least_cache);
#ifdef CGAL_LINKED_WITH_TBB
    for(const std::size_t threads : {1, 2, 4, 8}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      assert(same_bits(reference, result(function, cloud, true)));
    }
#endif
  }
  return EXIT_SUCCESS;
}
