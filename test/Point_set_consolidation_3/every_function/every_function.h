// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every public function behind one signature, so that a test can ask the same of all of them.

#ifndef POINT_SET_CONSOLIDATION_3_TEST_EVERY_FUNCTION_H
#define POINT_SET_CONSOLIDATION_3_TEST_EVERY_FUNCTION_H

#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/property_map.hpp>

#include <functional>
#include <string>
#include <vector>

namespace every_function {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

/// What the functions' ranges hold.
struct Sample {
  Point point;
  Vector normal;
  int segment = 0;
};

struct Cloud {
  std::string name;
  std::vector<Sample> samples;
  bool has_normals = false;
};

/// Thrown by the property maps of a run whose `accesses_left` reach 0.
struct Map_failure {};

/// How a function is called.
struct Run {
  bool parallel = false;
  std::function<bool(double)> callback;
  mutable long accesses_left = -1;  ///< negative: the maps never fail

  void count_access() const
  {
    if(accesses_left > 0 && --accesses_left == 0)
      throw Map_failure();
  }
};

/// What a function wrote; filled in as well if it throws.
struct Output {
  std::vector<Point> points;
  std::vector<Vector> normals;  ///< unit vectors
  std::vector<double> numbers;  ///< radii, labels, counts ...
  bool is_untouched = true;     ///< the caller's objects are as they were
};

enum class Normals { UNUSED, OPTIONAL, NEEDED };

struct Function {
  const char* name;
  Normals normals;
  bool may_write_nothing;  ///< where there is nothing to add or to remove
  void (*call)(const Cloud&, const Run&, Output&);
};

const std::vector<Function>& consolidations();
const std::vector<Function>& operators();
const std::vector<Function>& feature_operators();
const std::vector<Function>& skeletons();
const std::vector<Function>& surfaces();

inline std::vector<Function> all_functions()
{
  std::vector<Function> all;
  for(const auto* part : {&consolidations(), &operators(), &feature_operators(), &skeletons(), &surfaces()})
    all.insert(all.end(), part->begin(), part->end());
  return all;
}

// ---- for the definitions --------------------------------------------------------------------

/// A member of the samples; each access is counted.
template <typename T, T Sample::*member>
struct Sample_map {
  typedef Sample key_type;
  typedef T value_type;
  typedef T reference;
  typedef boost::read_write_property_map_tag category;
  const Run* run;

  friend T get(const Sample_map& map, const Sample& sample)
  {
    map.run->count_access();
    return sample.*member;
  }
  friend void put(const Sample_map& map, Sample& sample, const T& value)
  {
    map.run->count_access();
    sample.*member = value;
  }
};
typedef Sample_map<Point, &Sample::point> Point_map;
typedef Sample_map<Vector, &Sample::normal> Normal_map;

struct Segment_map {
  typedef Sample key_type;
  typedef int value_type;
  typedef int reference;
  typedef boost::read_write_property_map_tag category;

  friend int get(const Segment_map&, const Sample& sample) { return sample.segment; }
  friend void put(const Segment_map&, Sample& sample, int segment) { sample.segment = segment; }
};

}  // namespace every_function

#endif  // POINT_SET_CONSOLIDATION_3_TEST_EVERY_FUNCTION_H
