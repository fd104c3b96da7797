// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_WORKING_BOXES_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_WORKING_BOXES_H

#include <CGAL/Point_set_consolidation_3/internal/connected_components.h>
#include <CGAL/Point_set_consolidation_3/internal/free_space.h>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Where the missing parts are looked for.

/// Boxes that overlap become one, until none do.
inline std::vector<Bounding_box> united(std::vector<Bounding_box> boxes)
{
  for(std::size_t a = 0; a < boxes.size(); ++a)
    for(std::size_t b = a + 1; b < boxes.size(); ++b)
      if(boxes[a].overlaps(boxes[b])) {
        boxes[a].lower = boxes[a].lower.cwiseMin(boxes[b].lower);
        boxes[a].upper = boxes[a].upper.cwiseMax(boxes[b].upper);
        boxes.erase(boxes.begin() + std::ptrdiff_t(b));
        a = 0;  // the larger box may now reach any that were apart before
        b = 0;
      }
  return boxes;
}

/// A box for each part of the scan, so that memory does not grow with the void between them; larger than
/// its points by `margin`. With one view nothing bounds the object from behind: there the box is deeper by
/// `one_view_depth` of its longest side.
inline std::vector<Bounding_box> working_boxes(const Points& points, const Free_space& free_space,
                                               double margin, double one_view_depth)
{
  constexpr double link = 20;  // spacings: parts farther apart do not complete each other
  std::vector<Bounding_box> boxes;
  for(const std::vector<Index>& part : connected_components(points, link)) {
    Bounding_box box = bounding_box(selected(points, part));
    if(free_space.number_of_views() == 1) {
      const Vec3 away =
        -one_view_depth * box.sides().maxCoeff() * free_space.projection(0).axis();
      box.lower += away.cwiseMin(0.);
      box.upper += away.cwiseMax(0.);
    }
    boxes.push_back(box.grown(margin));
  }
  return united(std::move(boxes));
}

/// The boxes, large enough for the balls that touch the surface at `points` too.
inline std::vector<Bounding_box> holding_balls(std::vector<Bounding_box> boxes, const Points& points,
                                               const Points& centres,
                                               const std::vector<double>& radius, double margin)
{
  for(Bounding_box& box : boxes) {
    const Bounding_box before = box;
    for(std::size_t i = 0; i < points.size(); ++i)
      if(before.contains(points[i])) {
        const Vec3 reach = Vec3::Constant(radius[i] + margin);
        box.lower = box.lower.cwiseMin(centres[i] - reach);
        box.upper = box.upper.cwiseMax(centres[i] + reach);
      }
  }
  return united(std::move(boxes));
}

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_WORKING_BOXES_H
