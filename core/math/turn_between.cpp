#include "core/math/turn_between.hpp"

#include <algorithm>
#include <cmath>

namespace abstand {
namespace {

constexpr double kHalfTurn = 1e-12;  // 1 + cosine; below it, the cross product is too small to be the axis

}  // namespace

Quaterniond turnBetween(const Vector3d& from, const Vector3d& to) {
  const Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = std::max(-1.0, a.dot(b));
  Quaterniond q;
  if (cosine < -1.0 + kHalfTurn) {
    const double w2 = 0.5 * (1.0 + cosine);
    q.w() = std::sqrt(w2);
    q.vec() = std::sqrt(1.0 - w2) * a.unitOrthogonal();
    return q;
  }
  const double s = std::sqrt((1.0 + cosine) * 2.0);
  q.w() = 0.5 * s;
  q.vec() = a.cross(b) * (1.0 / s);
  return q;
}

}  // namespace abstand
