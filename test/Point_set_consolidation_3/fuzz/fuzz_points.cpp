// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every public function on small arbitrary point sets. Byte 0: the function; byte 1: whether there are
// normals; then a byte for each coordinate: multiples of 1/16, and some rare values.

#include "../every_function/every_function.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

namespace {

void require(bool holds)
{
  if(!holds)
    std::abort();
}

double coordinate(std::uint8_t byte)
{
  static const double rare[] = {std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity(), 1e30, -1e30, 1e-30, 1e160, 1e7, 1e-300};
  return byte < 8 ? rare[byte] : (double(byte) - 131) / 16;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace every_function;
  static const std::vector<Function> functions = all_functions();
  constexpr std::size_t most_points = 64;
  if(size < 2)
    return 0;
  const Function& function = functions[data[0] % functions.size()];
  Cloud cloud;
  cloud.has_normals = data[1] % 2 == 1;
  const std::size_t stride = cloud.has_normals ? 6 : 3;
  bool is_finite = true;  // what the function reads
  for(std::size_t k = 2; k + stride <= size && cloud.samples.size() < most_points; k += stride) {
    double x[6] = {0, 0, 0, 0, 0, 1};
    for(std::size_t i = 0; i < stride; ++i) {
      x[i] = coordinate(data[k + i]);
      if(i < 3 || function.normals != Normals::UNUSED)
        is_finite = is_finite && std::isfinite(x[i]);
    }
    cloud.samples.push_back({Point(x[0], x[1], x[2]), Vector(x[3], x[4], x[5]), 0});
  }
  Output output;
  try {
    function.call(cloud, Run(), output);
  }
  catch(const std::invalid_argument& error) {
    require(output.is_untouched && *error.what() != 0);
    return 0;
  }
  catch(const std::runtime_error& error) {
    require(std::string(error.what()).find("no surface") != std::string::npos);
    return 0;
  }
  require(is_finite);  // or it should have been rejected
  for(const Point& p : output.points)
    require(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()));
  for(const Vector& n : output.normals)
    require(std::abs(n.squared_length() - 1) < 1e-6);
  for(const double x : output.numbers)
    require(std::isfinite(x));
  return 0;
}
