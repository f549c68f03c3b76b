#include "ui/model/closing_speed.hpp"

namespace abstand::ui {

namespace {

constexpr double kSamePoint = 1e-6;  // m: nearest points this close give no direction

/// Unit vector from the nearest point of a to that of b; zero where it is not known.
Vector3d directionOf(const view::SceneSnapshot& snapshot, const query::PairResult& result,
                     std::pair<int, int> pair) {
  Vector3d between = result.witness_b - result.witness_a;
  if (result.distance < 0.0) between = -between;
  if (!between.allFinite() || between.norm() < kSamePoint)
    between = snapshot.objects[static_cast<std::size_t>(pair.second)].p_WCom -
              snapshot.objects[static_cast<std::size_t>(pair.first)].p_WCom;
  return between.norm() < kSamePoint || !between.allFinite() ? Vector3d::Zero() : between.normalized();
}

Vector3d velocityAt(const view::ObjectSnapshot& object, const Vector3d& p_W) {
  if (!p_W.allFinite()) return object.velocity.linear;
  return object.velocity.linear + object.velocity.angular.cross(p_W - object.p_WCom);
}

}  // namespace

ClosingSpeeds closingSpeeds(const view::SceneSnapshot& snapshot, const query::PairResult& result,
                            std::pair<int, int> objects) {
  const view::ObjectSnapshot& one = snapshot.objects[static_cast<std::size_t>(objects.first)];
  const view::ObjectSnapshot& other = snapshot.objects[static_cast<std::size_t>(objects.second)];
  const Vector3d n = directionOf(snapshot, result, objects);
  return {velocityAt(one, result.witness_a).dot(n), -velocityAt(other, result.witness_b).dot(n)};
}

}  // namespace abstand::ui
