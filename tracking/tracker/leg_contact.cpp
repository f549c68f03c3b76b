// Nearest points of two line segments (Ericson, Real-Time Collision Detection, 2005, section 5.1.9).
#include "tracking/tracker/leg_contact.hpp"

#include <algorithm>

namespace abstand::tracking {
namespace {

constexpr double kParallel = 1e-9;     // squared sine, below which any point of one axis will do
constexpr double kNoDirection = 1e-6;  // m; axes that are nearer have no direction from one to the other

/// Of the bones from `left` to `left_end`, and from `right` to `right_end`.
LegContact contactOf(RigSegment left, RigSegment left_end, RigSegment right, RigSegment right_end,
                     const RigPlacement& X_WS) {
  const auto at = [&](RigSegment s) { return Vector3d(X_WS[index(s)].translation()); };
  const Vector3d a = at(left), u = at(left_end) - a, b = at(right), v = at(right_end) - b, w = a - b;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), uw = u.dot(w), vw = v.dot(w);
  const double determinant = uu * vv - uv * uv;
  const auto share = [](double of, double whole) {
    return whole > 0.0 ? std::clamp(of / whole, 0.0, 1.0) : 0.0;
  };
  const double start = determinant > kParallel * uu * vv ? share(uv * vw - vv * uw, determinant) : 0.0;
  const double t = share(vw + start * uv, vv), s = share(t * uv - uw, uu);
  LegContact contact{left, right, a + s * u, b + t * v};
  const Vector3d apart = contact.p_left - contact.p_right;
  const double distance = apart.norm();
  if (distance < kNoDirection || distance >= kLegsApart) return contact;
  contact.n = apart / distance;
  contact.depth = kLegsApart - distance;
  return contact;
}

}  // namespace

std::array<LegContact, 2> legContacts(const RigPlacement& X_WS) {
  using enum RigSegment;
  return {contactOf(kThighLeft, kCalfLeft, kThighRight, kCalfRight, X_WS),
          contactOf(kCalfLeft, kFootLeft, kCalfRight, kFootRight, X_WS)};
}

}  // namespace abstand::tracking
