// Certified lower bound of the distance of two non-convex bodies, from the hulls of their parts. Internal to
// the engine.
#pragma once

#include <cstdint>

#include "core/query/pair_query.hpp"

namespace abstand::query {

/// The point of a part with the largest g . p.
structure::ExtremePoint partExtreme(const structure::HapticStructure& body, std::size_t part,
                                    const Vector3d& g) noexcept;

/// The pairs of parts that may be nearer than `by` (m), selected by their bounding spheres. Built once for a
/// pose, then tested along several directions. No allocation, no throw.
class FacingParts {
 public:
  struct Parts {
    std::size_t of_points, of_field;
  };

  /// P and F as in a query; all must outlive this object. `closely`: uses exact support functions for bodies
  /// of one part. `axes`: separating axes kept from earlier poses.
  FacingParts(const structure::HapticStructure& P, const structure::HapticStructure& F, const Transform& X_FP,
              double by, bool closely, PartAxes& axes) noexcept;

  /// True if the bodies are provably at least `by` apart: neither is inside the other, and every pair of
  /// facing parts is separated by a slab of this width, across n or another axis of their own. n: unit, from
  /// F to P, in F's axes. If false, `between` is a pair of parts that was not separated.
  bool apart(const Vector3d& n, Parts& between) noexcept;

 private:
  double slab(const Vector3d& n, std::size_t i, std::size_t j) const noexcept;
  bool partsApart(const Parts& parts) noexcept;

  const structure::HapticStructure& P_;
  const structure::HapticStructure& F_;
  const Transform& X_FP_;
  double by_;
  bool closely_;
  PartAxes& axes_;
  bool may_contain_;  ///< one of the bodies, or a component of it, may lie inside the other
  std::uint64_t facing_{0};
};

}  // namespace abstand::query
