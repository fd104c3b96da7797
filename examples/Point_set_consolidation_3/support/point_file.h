// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_POINT_FILE_H
#define CONSOLIDATION_SUPPORT_POINT_FILE_H

#include "types.h"

#include <string>

/// Files of points, meshes and graphs. Everything that is wrong with a file is a `File_error`
/// whose one-line message begins with the file's name; nothing else is thrown or printed.
/// Files are written completely or not at all.

namespace support {

/// Reads a scan; the extension says what the file is:
///
/// - .xyz .pwn: `x y z` or `x y z nx ny nz` on each line, after an optional line with the number of
///   points; `#` begins a comment. What looks like colours in the place of normals (whole numbers
///   from 0 to 255, some above 1) is ignored.
/// - .off .noff: the vertices of an OFF file, with normals if there are any. Headers without all
///   three counts, and NOFF files that hold positions only, are accepted.
/// - .ply: `x y z`, optionally `nx ny nz`, `vx vy vz` (direction towards the scanner, normalised
///   here), `view` and `confidence` of the element `vertex`.
/// - .las: the positions of a LAS file (1.0 to 1.4, not compressed).
///
/// Normals and directions that are not finite become zero vectors, which mean "unknown"; if all are
/// zero there are none.
/// \throws File_error if the file cannot be read, holds no points or something else than its
///         header or its extension says, or has coordinates that are not finite.
Point_cloud read_point_cloud(const std::string& file);

/// Writes a .ply (binary; positions as double, the attributes that there are as float or int),
/// .xyz, .pwn, .off or .noff file; the latter four keep positions and normals only.
void write_point_cloud(const std::string& file, const Point_cloud& cloud);

/// Reads the triangles of an .off, .ply, .obj or .stl file; larger faces are cut into triangles.
/// \throws File_error also if there are no faces, or faces with vertices that do not exist.
Triangle_mesh read_mesh(const std::string& file);

/// Writes an .off, .ply (binary), .obj or .stl (binary) file.
void write_mesh(const std::string& file, const Triangle_mesh& mesh);

/// PLY: vertices `x y z` and `radius` if there is one, edges `vertex1 vertex2`.
Segment_graph read_segment_graph(const std::string& file);
void write_segment_graph(const std::string& file, const Segment_graph& graph);

/// To be called before hours of work rather than after them: throws `File_error` if the extension
/// is not one that `write_point_cloud()` / `write_mesh()` writes, or the folder does not exist. An empty
/// name is an output that is not wanted.
void check_point_output(const std::string& file);
void check_mesh_output(const std::string& file);

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_POINT_FILE_H
