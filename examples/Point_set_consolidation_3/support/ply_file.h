// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_PLY_FILE_H
#define CONSOLIDATION_SUPPORT_PLY_FILE_H

#include "types.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace support {

enum class Ply_type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// A column of an element. The values are doubles, which hold every PLY type exactly.
struct Ply_property {
  std::string name;
  Ply_type type = Ply_type::float64;
  std::vector<double> values = {};

  /// For a list property, where in `values` the list of each item ends; else empty.
  std::vector<std::size_t> list_ends = {};
  bool is_list = false;
  Ply_type size_type = Ply_type::uint8;
};

struct Ply_element {
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;

  /// The property with one number per item; null if there is none.
  const Ply_property* find_number(const std::string& property) const;
  /// The property with a list per item; null if there is none.
  const Ply_property* find_list(const std::string& property) const;
};

/// A PLY file as it is: a table for each element.
struct Ply_file {
  std::vector<Ply_element> elements;

  const Ply_element* find(const std::string& element) const;  ///< null if there is none
};

/// Text and binary files of either byte order.
/// \throws File_error if the file is not what its header says. The sizes in the header are
///         compared with that of the file before memory is taken.
Ply_file read_ply(const std::string& file);

/// Binary, lowest byte first; see `write_file()`.
void write_ply(const std::string& file, const Ply_file& ply);

/// The names of three properties that make a vector.
using Vector_names = std::array<const char*, 3>;
constexpr Vector_names position_names{"x", "y", "z"};

bool has_vectors(const Ply_element& element, const Vector_names& names);
std::vector<Vec3> read_vectors(const Ply_element& element, const Vector_names& names);
void append_vectors(Ply_element& element, const Vector_names& names, Ply_type type,
                    const std::vector<Vec3>& vectors);

/// The element that holds positions. \throws File_error if there is none.
const Ply_element& vertex_element(const std::string& file, const Ply_file& ply);

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_PLY_FILE_H
