// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_SUPPORT_SMALL_HANDLES_H
#define CONSOLIDATION_SUPPORT_SMALL_HANDLES_H

#include "types.h"

#include <cstddef>

namespace support {

/// Removes the handles of a closed, oriented manifold mesh that a loop of at most `longest_loop` opens, and returns
/// their number: the mesh is cut along the loop, and both sides get a cap. A loop around a bridge parts the bridge, one
/// through a tunnel fills the tunnel; no component falls apart. Loops along edges are looked for by shortest systems of
/// loops (Erickson and Whittlesey, SODA 2005), which hold the shortest loop through their root that opens a handle.
/// O(n log n) for each system; there are some dozens for each handle.
std::size_t remove_small_handles(Triangle_mesh& mesh, double longest_loop);

/// Bridges and tunnels up to three times the noise wide cannot be told from noise. 0: none, the mesh stays as it is.
std::size_t remove_handles_of_noise(Triangle_mesh& mesh, double noise);

}  // namespace support

#endif  // CONSOLIDATION_SUPPORT_SMALL_HANDLES_H
