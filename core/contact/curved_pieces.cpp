#include "core/contact/curved_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::contact {
namespace {

bool isOutOfReach(const CurvedPerson& person, const PatchTriangle& t) {
  const Vector3d centre = (t[0] + t[1] + t[2]) / 3.0;
  double extent2 = 0.0, top = -kInfinity;
  for (const Vector3d& c : t) {
    extent2 = std::max(extent2, (c - centre).head<2>().squaredNorm());
    top = std::max(top, c.z());
  }
  const double rho = std::max(0.0, centre.head<2>().norm() - std::sqrt(extent2));
  return top - rho * rho / (2.0 * person.radius) < person.lowest;
}

/// The edge with the largest projected length, and its squared length.
std::pair<int, double> longestEdge(const PatchTriangle& t) {
  std::pair<int, double> longest{0, 0.0};
  for (int i = 0; i < 3; ++i) {
    const double length2 = (corner(t, i + 1) - corner(t, i)).head<2>().squaredNorm();
    if (length2 > longest.second) longest = {i, length2};
  }
  return longest;
}

}  // namespace

bool divideForCurve(const CurvedPerson& person, std::vector<PatchTriangle>& open,
                    std::vector<PatchTriangle>& pieces) {
  if (std::isinf(person.radius)) return true;
  const double most2 = kPieceShare * person.radius * person.indentation;
  open.swap(pieces);
  pieces.clear();
  while (!open.empty()) {
    const PatchTriangle piece = open.back();
    open.pop_back();
    if (isOutOfReach(person, piece)) continue;
    const auto [longest, length2] = longestEdge(piece);
    if (length2 <= most2) {
      pieces.push_back(piece);
      if (pieces.size() > kMaxPieces) return false;
      continue;
    }
    const Vector3d &a = corner(piece, longest), &b = corner(piece, longest + 1),
                   &c = corner(piece, longest + 2);
    const Vector3d middle = 0.5 * (a + b);
    open.push_back({a, middle, c});
    open.push_back({middle, b, c});
  }
  return true;
}

}  // namespace abstand::contact
