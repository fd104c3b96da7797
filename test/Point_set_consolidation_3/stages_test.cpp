// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The classes that run stage by stage: a stage that the callback stopped, or left by an exception, has written
// nothing; run again, it has the same bits as if it had never been stopped.

#undef NDEBUG

#include "every_function/clouds.h"

#include <CGAL/Deep_points_consolidation_3.h>
#include <CGAL/Laplacian_contraction_skeletonization_3.h>

#include <cassert>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <limits>
#include <vector>

namespace {

using every_function::Cloud;
using every_function::Kernel;
using every_function::Point;
using every_function::Vector;
namespace params = CGAL::Point_set_consolidation_3::parameters;

using Deep_points = CGAL::Deep_points_consolidation_3<Kernel>;
using Contraction = CGAL::Laplacian_contraction_skeletonization_3<Kernel>;
using Numbers = std::vector<double>;

void append(const Point& p, Numbers& numbers)
{
  for(int k = 0; k < 3; ++k)
    numbers.push_back(p[k]);
}

Numbers results(const Deep_points& c)
{
  Numbers numbers = {double(c.size()), c.spacing(), double(c.number_of_sinking_iterations()),
                     double(c.outliers().size()), double(c.stage_times().size())};
  std::vector<CGAL::Deep_point_3<Kernel> > deep;
  c.deep_points(std::back_inserter(deep));
  for(const auto& p : deep) {
    append(p.outer(), numbers);
    append(p.inner(), numbers);
    numbers.push_back(p.confidence());
  }
  std::vector<CGAL::Completed_point_3<Kernel> > completed;
  c.completed_points(std::back_inserter(completed));
  for(const auto& p : completed)
    append(p.outer(), numbers);
  return numbers;
}

Numbers results(const Contraction& c)
{
  Numbers numbers = {double(c.number_of_iterations())};
  std::vector<Point> contracted;
  c.contracted_points(std::back_inserter(contracted));
  for(const Point& p : contracted)
    append(p, numbers);
  CGAL::Curve_skeleton_3<Kernel> skeleton;
  c.skeleton(skeleton);
  for(std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    append(skeleton[v].point, numbers);
    numbers.push_back(skeleton[v].radius);
  }
  return numbers;
}

/// A callback that stops a call, or throws, once.
struct Stopper {
  struct Stop {};
  static constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
  std::size_t calls = 0, at = never;
  bool throws = false;

  bool operator()(double)
  {
    if(++calls != at)
      return true;
    if(throws)
      throw Stop();
    return false;
  }
};

template <typename Object>
struct Step {
  const char* name;
  bool (Object::*run)();
  bool is_undone;  ///< by a stop: the object is as before the step
};

/// `make(callback)` is the object; a new one for each stop.
template <typename Object, typename Make>
void stop_and_go(const std::vector<Step<Object> >& steps, const Make& make)
{
  for(std::size_t s = 0; s < steps.size(); ++s) {
    Stopper counter;
    Object whole = make(counter);
    for(std::size_t k = 0; k < s; ++k)
      assert((whole.*steps[k].run)());
    const Numbers before = results(whole);
    counter.calls = 0;
    assert((whole.*steps[s].run)());
    const std::size_t calls = counter.calls;
    const Numbers after = results(whole);
    std::cout << steps[s].name << ": " << calls << " calls" << std::endl;
    constexpr std::size_t places = 20;
    for(std::size_t k = 0; k < places && k < calls; ++k) {
      Stopper stopper;
      Object object = make(stopper);
      for(std::size_t i = 0; i < s; ++i)
        assert((object.*steps[i].run)());
      stopper.calls = 0;
      stopper.at = calls <= places ? k + 1 : 1 + k * (calls - 1) / (places - 1);
      stopper.throws = k % 4 == 1;
      bool was_stopped = false;
      try {
        was_stopped = !(object.*steps[s].run)();
      }
      catch(const Stopper::Stop&) {
        was_stopped = true;
      }
      assert(was_stopped);
      if(steps[s].is_undone)
        assert(results(object) == before);
      assert((object.*steps[s].run)());
      assert(results(object) == after);
    }
  }
}

std::vector<Point> points_of(const Cloud& cloud)
{
  std::vector<Point> points;
  for(const auto& sample : cloud.samples)
    points.push_back(sample.point);
  return points;
}

}  // namespace

int main()
{
  const std::vector<Point> points = points_of(every_function::open_capsule(400, 31));
  const auto deep_points = [&](Stopper& stopper) {
    return Deep_points(points, params::number_of_output_points(150).callback(
                                 [&stopper](double fraction) { return stopper(fraction); }));
  };
  const std::vector<Step<Deep_points> > to_the_surface = {
    {"consolidate_input", &Deep_points::consolidate_input, true},
    {"sink_inner_points", &Deep_points::sink_inner_points, true},
    {"form_meso_skeleton", &Deep_points::form_meso_skeleton, true},
    {"consolidate_outer_points", &Deep_points::consolidate_outer_points, true}};
  stop_and_go(to_the_surface, deep_points);
  const std::vector<Step<Deep_points> > to_the_completion = {
    to_the_surface[0], to_the_surface[1], {"complete_missing_parts", &Deep_points::complete_missing_parts, true}};
  stop_and_go(to_the_completion, deep_points);

  const auto contraction = [&](Stopper& stopper) {
    return Contraction(points, params::callback([&stopper](double fraction) { return stopper(fraction); }));
  };
  stop_and_go<Contraction>({{"contract_geometry", &Contraction::contract_geometry, false},
                            {"contract_until_convergence", &Contraction::contract_until_convergence, false},
                            {"build_graph", &Contraction::build_graph, false},
                            {"thin", &Contraction::thin, false},
                            {"recentre", &Contraction::recentre, false},
                            {"extend_tips", &Contraction::extend_tips, false}},
                           contraction);
  return EXIT_SUCCESS;
}
