// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_OFF_FILE_H
#define CONSOLIDATION_SUPPORT_OFF_FILE_H

#include "types.h"

#include <cstddef>
#include <string>
#include <vector>

namespace support {

/// An OFF file as it is. Faces may have any number of vertices; indices are checked.
struct Off_file {
  std::vector<Vec3> vertices;
  std::vector<Vec3> normals;  ///< empty or one per vertex, zero where the file has none
  std::vector<std::vector<std::size_t>> faces;
};

/// \throws File_error
Off_file read_off(const std::string& file);

/// Whether these look like colours in the place of normals: whole numbers from 0 to 255, some of
/// them above 1.
bool are_colours(const std::vector<Vec3>& normals);

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_OFF_FILE_H
