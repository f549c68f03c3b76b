// Connected part of a surface above a height.
#pragma once

#include "core/contact/contact_surface.hpp"

namespace abstand::contact {

struct ConnectedTriangles {
  std::vector<std::uint32_t> triangles;  ///< indices into the mesh
  std::uint32_t foremost{0};             ///< the highest vertex
};

/// Triangles reached from the vertex `start` over vertices at or above `level` (m). `points`: the mesh's
/// vertices with their height as z. Two vertices are connected if a triangle has both; a triangle is included
/// if one of its vertices is reached.
ConnectedTriangles connectedAbove(const ContactSurface& surface, std::span<const Vector3d> points,
                                  std::uint32_t start, double level);

}  // namespace abstand::contact
