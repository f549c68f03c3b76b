// Small meshes that are difficult for a sampling engine.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/structure/haptic_structure.hpp"
#include "core/verify/brute_force.hpp"

namespace abstand::verify {

inline constexpr std::array kFields{structure::FieldKind::kLayered, structure::FieldKind::kFloat,
                                    structure::FieldKind::kMixed};

/// A face, an edge or a corner of a mesh: a point of the surface and the outward direction there.
struct Feature {
  Vector3d point;
  Vector3d out;    ///< unit; mean of the adjacent triangles' normals
  Vector3d along;  ///< unit, perpendicular to `out`: along the edge, or arbitrary
};

/// One body for the engine and for the brute force. Body frame, metres.
struct AdversarialBody {
  std::string name;
  geometry::TriangleMesh mesh;
  structure::HapticOptions options;  ///< except the field
  bool closed{true};
  TriangleSoup soup{geometry::TriangleMesh{}};
  std::array<std::shared_ptr<const structure::HapticStructure>, kFields.size()>
      structures;      ///< in the order of kFields
  double radius{0.0};  ///< about `centre`
  Vector3d centre{Vector3d::Zero()};

  Feature face(std::size_t triangle, double u, double v) const;       ///< u, v in [0, 1): position in the
                                                                      ///< face
  Feature edge(std::size_t triangle, int corner, double part) const;  ///< from `corner` to the next
  Feature corner(std::size_t triangle, int corner) const;
};

/// Cubes, plates of 0.2 mm, spikes, stars, needles, combs, rings, nested shells, two components, an open
/// sheet, and bodies of 1 mm and of 5 m. Built on `threads` threads (0: all).
std::vector<AdversarialBody> adversarialBodies(int threads);

}  // namespace abstand::verify
