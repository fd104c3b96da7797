// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Odd and bad point sets, for every function: either a named error, or finite points that stay near the
// input and unit normals; never a hang or a silent empty result, and memory that is bounded by the number of points,
// not by the size of their box.
// Arguments: [PART OF A FUNCTION'S NAME [PART OF A POINT SET'S NAME]]

#include "every_function/clouds.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

#include <sys/resource.h>
#include <unistd.h>

// Sanitizers reserve terabytes of addresses.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MEMORY_IS_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define MEMORY_IS_SANITIZED
#endif
#endif

namespace {

using namespace every_function;

// Far more than any of these small sets needs, also with sanitizers.
constexpr unsigned int seconds_until_it_hangs = 120;

/// Beyond this many bytes allocations fail: the largest grids take half a gigabyte.
void limit_memory()
{
#ifndef MEMORY_IS_SANITIZED
  constexpr rlim_t most = 2000000000;
  const rlimit limit = {most, most};
  if(::setrlimit(RLIMIT_AS, &limit) != 0)
    std::abort();
#endif
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

bool is_finite(const Point& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

/// What is wrong with the output; empty if nothing is.
std::string fault(const Function& function, const Cloud& cloud, const Output& output)
{
  if(!function.may_write_nothing && output.points.empty())
    return "nothing was written";
  Point lower = cloud.samples.front().point, upper = lower;
  for(const Sample& s : cloud.samples) {
    lower = Point((std::min)(lower.x(), s.point.x()), (std::min)(lower.y(), s.point.y()),
                  (std::min)(lower.z(), s.point.z()));
    upper = Point((std::max)(upper.x(), s.point.x()), (std::max)(upper.y(), s.point.y()),
                  (std::max)(upper.z(), s.point.z()));
  }
  double side = 0;
  for(int k = 0; k < 3; ++k)
    side = (std::max)(side, upper[k] - lower[k]);
  for(const Point& p : output.points) {
    if(!is_finite(p))
      return "a point is not finite";
    for(int k = 0; k < 3; ++k)
      if(p[k] < lower[k] - 2 * side || p[k] > upper[k] + 2 * side)
        return "a point is far outside of the box of the input: " + std::to_string(p[k]);
  }
  for(const Vector& n : output.normals)
    if(!(std::abs(std::sqrt(n.squared_length()) - 1) < 1e-6))
      return "a normal is not a unit vector: " + std::to_string(n.squared_length());
  for(const double x : output.numbers)
    if(!std::isfinite(x))
      return "a number is not finite";
  return std::string();
}

/// What is wrong with an error of this kind and message.
std::string fault(const Function& function, const std::invalid_argument& error, const Output& output)
{
  const std::string message = error.what();
  const std::string class_of_function =
    contains(function.name, "laplacian") ? "Laplacian_contraction" : "Deep_points_consolidation_3";
  if(!contains(message, std::string(function.name).substr(0, 12)) && !contains(message, class_of_function))
    return "the message does not name the function";
  if(contains(message, "\n"))
    return "the message is more than one line";
  return output.is_untouched ? std::string() : "it threw and yet wrote something";
}

bool is_well_treated(const Function& function, const Cloud& cloud, int index)
{
  const bool bad_point = contains(cloud.name, "point 17");
  const bool bad_normal = contains(cloud.name, "normal 17") && function.normals != Normals::UNUSED;
  std::cout << function.name << " " << index << " | " << cloud.name << ": " << std::flush;
  alarm(seconds_until_it_hangs);
  const auto start = std::chrono::steady_clock::now();
  Output output;
  std::string what_is_wrong;
  bool is_rejected = false;
  try {
    function.call(cloud, Run(), output);
    if(bad_point || bad_normal)
      what_is_wrong = "a number that is not finite was accepted";
    else if(function.normals == Normals::NEEDED && !cloud.has_normals && !cloud.samples.empty())
      what_is_wrong = "missing normals were accepted";
    else if(!cloud.samples.empty())
      what_is_wrong = fault(function, cloud, output);
  }
  catch(const std::invalid_argument& error) {
    is_rejected = true;
    std::cout << error.what() << " ";
    what_is_wrong = fault(function, error, output);
    if((bad_point || bad_normal) && !contains(error.what(), "17"))
      what_is_wrong = "the message does not name the index";
    if(bad_point && !contains(error.what(), "point_map"))
      what_is_wrong = "the message does not name point_map";
    if(bad_normal && !contains(error.what(), "normal_map"))
      what_is_wrong = "the message does not name normal_map";
  }
  catch(const std::runtime_error& error) {  // surfaces: none at this resolution
    is_rejected = true;
    std::cout << error.what() << " ";
    if(!contains(function.name, "reconstruction") || !contains(error.what(), "no surface"))
      what_is_wrong = "a runtime error";
  }
  catch(const std::exception& error) {
    what_is_wrong = std::string("an undocumented exception: ") + error.what();
  }
  alarm(0);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  // The plain capsule, and the same elsewhere or in another unit, have a result everywhere; turned inside out it
  // bounds no solid, and reconstruction may say so.
  if(is_rejected && what_is_wrong.empty() && cloud.has_normals &&
     (cloud.name == "open capsule" || cloud.name == "georeferenced" || cloud.name == "unit of 1e-20" ||
      cloud.name == "unit of 1e20" || (cloud.name == "normals flipped" && !contains(function.name, "reconstruction")) ||
      cloud.name == "normals long"))
    what_is_wrong = "this input has a result";
  std::cout << (is_rejected ? "" : std::to_string(output.points.size()) + " points ")
            << (what_is_wrong.empty() ? "" : "FAULT: ") << what_is_wrong << std::endl;
  if(elapsed.count() > 5)
    std::cout << "  SLOW: " << elapsed.count() << " s" << std::endl;
  return what_is_wrong.empty();
}

}  // namespace

int main(int argc, char* argv[])
{
  limit_memory();
  std::size_t faults = 0;
  int index = 0;
  for(const Function& function : all_functions()) {
    ++index;
    if(argc > 1 && !contains(function.name, argv[1]))
      continue;
    for(const Cloud& cloud : odd_clouds())
      if(argc < 3 || contains(cloud.name, argv[2]))
        if(!is_well_treated(function, cloud, index))
          ++faults;
  }
  std::cout << faults << " faults" << std::endl;
  return faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
