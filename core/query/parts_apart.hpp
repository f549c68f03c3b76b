// A certified lower bound of the distance of two bodies that are not convex, from the hulls of their parts.
// Internal to the engine.
#pragma once

#include <cstdint>

#include "core/query/pair_query.hpp"

namespace abstand::query {

/// A point of a part that reaches farthest along g.
structure::ExtremePoint partExtreme(const structure::HapticStructure& body, std::size_t part,
                                    const Vector3d& g) noexcept;

/// The parts of two bodies that may be nearer than `by` (m); the others' spheres are apart. Looked up once
/// for a pose, then asked along several directions. No allocation, no throw.
class FacingParts {
 public:
  struct Parts {
    std::size_t of_points, of_field;
  };

  /// P and F as in a query; all must outlive this object. `closely`: reaches of bodies that are one part are
  /// looked up without the loss of their tables. `lines`: what is remembered of earlier poses of the two.
  FacingParts(const structure::HapticStructure& P, const structure::HapticStructure& F, const Transform& X_FP,
              double by, bool closely, PartAxes& lines) noexcept;

  /// True when neither body lies inside the other, and no points of theirs are nearer than `by`: all facing
  /// parts lie on both sides of a slab of this width, across n or another one for two of them. n: unit, from
  /// F to P, in F's axes. Else `between` is a pair of parts for which none was found.
  bool apart(const Vector3d& n, Parts& between) noexcept;

 private:
  double slab(const Vector3d& n, std::size_t i, std::size_t j) const noexcept;
  bool partsApart(const Parts& parts) noexcept;

  const structure::HapticStructure& P_;
  const structure::HapticStructure& F_;
  const Transform& X_FP_;
  double by_;
  bool closely_;
  PartAxes& lines_;
  bool may_contain_;  ///< one of the bodies, or a piece of it, may lie inside the other
  std::uint64_t facing_{0};
};

}  // namespace abstand::query
