#include "tracking/tracker/hidden_space.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/math/random.hpp"

namespace abstand::tracking {
namespace {

constexpr double kInFront = 0.05;   // m, before what is measured
constexpr double kThinnest = 0.02;  // m, RMS of the samples along an axis, for its direction
constexpr std::array kPowers{0.25, 0.5, 0.75, 1.0};
constexpr int kTries = 8;  // directions for a link of a sample until one is within the joint limits
// Largest angle between a forearm or a calf and its parent, and of a hand to its forearm; range of the angle
// of a foot to its calf. As the rig's limits.
const double kMinFlexed = std::cos(unit::deg(155)), kMinHand = std::cos(unit::deg(75)),
             kMaxFoot = std::cos(unit::deg(35));

/// Whether link `link` of a limb may point along `d` when its parent points along `parent`; world.
bool isAllowed(const BodyRig& rig, const Limb& limb, int link, const Vector3d& d, const Transform& X_WP,
               const Vector3d& parent) {
  if (link == 0) {
    const RigPart& part = rig[limb.upper];
    return d.dot(X_WP.linear() * part.middle) >= std::cos(part.cone);
  }
  if (link == 1) return d.dot(parent) >= kMinFlexed;
  return limb.isArm() ? d.dot(parent) >= kMinHand : std::abs(d.dot(parent)) <= kMaxFoot;
}

}  // namespace

HiddenSpace::HiddenSpace(const BodyRig& rig) : rig_{&rig} {
  shape_.fill(Matrix3d::Zero());
  for (std::size_t link = 0; link < direction_.size(); ++link) {
    Random random(1, link);
    for (Vector3d& d : direction_[link]) d = random.direction();
  }
}

bool HiddenSpace::isFree(const BodyObservation& seen, const Vector3d& p_W) {
  if (p_W.z() < -kTolerance) return false;
  for (const BodyView& view : seen.views()) {
    const Vector3d p_C = view.X_CW() * p_W;
    const BodyView::Probe probe = view.at(p_C);
    const bool is_behind = probe.z > 0.0 && probe.z < p_C.z();
    if (probe.state == CellState::kEmpty && !is_behind && probe.to_person.norm() > kTolerance) return false;
    if (probe.state == CellState::kPerson && probe.z > p_C.z() + kInFront) return false;
  }
  return true;
}

void HiddenSpace::update(const BodyObservation& seen, const RigPlacement& X_WS, SeenSegments visible) {
  extent_.fill(kInfinity);
  shape_.fill(Matrix3d::Zero());
  for (const Limb& limb : kLimbs) sample(seen, X_WS, visible, limb);
}

void HiddenSpace::sample(const BodyObservation& seen, const RigPlacement& X_WS, SeenSegments visible,
                         const Limb& limb) {
  const BodyRig& rig = *rig_;
  const std::array<RigSegment, 3> segments{limb.upper, limb.lower, limb.end};
  int first = 0;
  while (first < 3 && isSeen(visible, segments[static_cast<std::size_t>(first)])) ++first;
  if (first == 3) return;
  const RigPart& begin = rig[segments[static_cast<std::size_t>(first)]];
  if (!isSeen(visible, begin.parent)) return;
  const Transform& X_WP = X_WS[index(begin.parent)];
  // What each link carries at its end.
  std::array<std::size_t, 3> joints{};
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    for (std::size_t k = 0; k < 3; ++k)
      if (rig.carrier[j] == segments[k]) joints[k] = j;
  const std::size_t links = 3;
  std::size_t count = 0;
  for (int i = 0; i < kSamples; ++i) {
    Vector3d p = X_WP * begin.p_parent;
    Vector3d parent = first == 0 ? Vector3d::Zero() : Vector3d(p - X_WP.translation()).normalized();
    bool is_possible = true;
    std::array<Vector3d, 3> end{};
    for (std::size_t k = static_cast<std::size_t>(first); k < links && is_possible; ++k) {
      int tried = 0;
      Vector3d d;
      do {
        d = direction_[k][static_cast<std::size_t>((i + tried * (11 + 2 * static_cast<int>(k))) % kSamples)];
      } while (!isAllowed(rig, limb, static_cast<int>(k), d, X_WP, parent) && ++tried < kTries);
      const Vector3d next = p + rig.p_joint[joints[k]].norm() * d;
      is_possible = tried < kTries && isFree(seen, next) && isFree(seen, 0.5 * (p + next));
      end[k] = p = next;
      parent = d;
    }
    if (!is_possible) continue;
    for (std::size_t k = static_cast<std::size_t>(first); k < links; ++k)
      offset_[k][count] = end[k] - X_WS[index(segments[k])] * rig.p_joint[joints[k]];
    ++count;
  }
  if (count < kFewest) return;
  for (std::size_t k = static_cast<std::size_t>(first); k < links; ++k) {
    if (isSeen(visible, segments[k])) continue;
    for (std::size_t i = 0; i < count; ++i) distance_[i] = offset_[k][i].norm();
    extent_[joints[k]] = shareOf(count);
    shape_[joints[k]] = shapeOf(k, count, extent_[joints[k]]);
  }
}

/// Quantile kShare of the first `count` distances, which are reordered.
double HiddenSpace::shareOf(std::size_t count) {
  const auto place = static_cast<std::ptrdiff_t>(kShare * static_cast<double>(count - 1));
  std::nth_element(distance_.begin(), distance_.begin() + place,
                   distance_.begin() + static_cast<std::ptrdiff_t>(count));
  return distance_[static_cast<std::size_t>(place)];
}

Matrix3d HiddenSpace::shapeOf(std::size_t link, std::size_t count, double extent) const {
  const auto& all = offset_[link];
  Matrix3d moment = Matrix3d::Zero();
  for (std::size_t i = 0; i < count; ++i) moment += all[i] * all[i].transpose();
  moment /= static_cast<double>(count);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(moment);
  const Vector3d root = axes.eigenvalues().cwiseMax(kThinnest * kThinnest).cwiseSqrt();
  Vector3d best = Vector3d::Constant(extent);
  for (const double power : kPowers) {
    const Vector3d half = root.array().pow(power);
    double farthest = 0.0;
    for (std::size_t i = 0; i < count; ++i)
      farthest = std::max(farthest, (axes.eigenvectors().transpose() * all[i]).cwiseQuotient(half).norm());
    const Vector3d semi = (farthest * half).cwiseMax(kThin);
    if (semi.sum() < best.sum()) best = semi;
  }
  return axes.eigenvectors() * best.cwiseAbs2().asDiagonal() * axes.eigenvectors().transpose();
}

}  // namespace abstand::tracking
