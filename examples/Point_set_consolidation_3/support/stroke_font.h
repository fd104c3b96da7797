// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_STROKE_FONT_H
#define CONSOLIDATION_SUPPORT_STROKE_FONT_H

#include <array>
#include <string>
#include <vector>

namespace support {

/// A polyline in the plane, y upwards.
using Stroke = std::vector<std::array<double, 2>>;

/// The pen strokes of a line of text that starts at the origin of its baseline, for capital letters
/// of height 1. Printable ASCII; other characters become '?'.
std::vector<Stroke> text_strokes(const std::string& text);

/// Width of the same line.
double text_width(const std::string& text);

/// Half the width of the pen that suits the letters.
constexpr double pen_radius = 0.062;

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_STROKE_FONT_H
