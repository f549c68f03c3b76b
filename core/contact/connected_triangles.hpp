// Connected part of a surface above a height.
#pragma once

#include "core/contact/placed_vertices.hpp"

namespace abstand::contact {

struct ConnectedTriangles {
  std::vector<std::uint32_t> triangles;  ///< indices into the mesh
  std::uint32_t foremost{0};             ///< the highest vertex

  /// Memory of the search, kept for the next one.
  std::vector<std::uint32_t> open;
  std::vector<std::uint32_t> seen, taken;  ///< of each vertex, of each triangle: number of the last search
  std::uint32_t search{0};
};

/// The triangles that are reached from the vertex `start` over vertices at or above `level` (m). `points` are
/// the mesh's vertices with their height as z. Two vertices are connected where a triangle has both; a
/// triangle belongs to any of its own.
void connectedAbove(const ContactSurface& surface, PlacedVertices& points, std::uint32_t start, double level,
                    ConnectedTriangles& found);

}  // namespace abstand::contact
