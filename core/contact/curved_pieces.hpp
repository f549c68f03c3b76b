// Subdivides triangles for a curved person.
#pragma once

#include <array>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::contact {

/// Corners (m): u and v perpendicular to the approach, relative to the contact point, and height along it.
using PatchTriangle = std::array<Vector3d, 3>;

inline const Vector3d& corner(const PatchTriangle& t, int i) { return t[static_cast<std::size_t>(i % 3)]; }

/// Limit of the deviation from the curve as a share of the indentation: a triangle with edges up to l
/// deviates from a parabola of radius R by at most l^2 / (6 R), and l^2 <= kPieceShare R x.
inline constexpr double kPieceShare = 0.1, kPieceError = kPieceShare / 6.0;

/// Limit of pieces; usual patches have some hundred. More are needed only for indentations of micrometres,
/// whose contact area is then taken as unknown.
inline constexpr std::size_t kMaxPieces = 20'000;

/// A person rounded as height = rho^2 / (2 radius), m.
struct CurvedPerson {
  double radius, indentation;
  double lowest;  ///< pieces entirely below this, relative to the curve, are dropped
};

/// Divides the triangles; those of a flat person (infinite radius) stay as they are. False, with `pieces` in
/// no particular state, where it takes more than kMaxPieces. `open` is memory for those that are not divided
/// yet.
bool divideForCurve(const CurvedPerson& person, std::vector<PatchTriangle>& open,
                    std::vector<PatchTriangle>& pieces);

}  // namespace abstand::contact
