// Two-bone inverse kinematics, and the search over positions.
#include "tracking/tracker/limb_search.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

constexpr double kBetter = 0.97;       // a position must cost less than this share of the old one's
constexpr float kUnexplained = 0.05f;  // m
constexpr int kUnexplainedTries = 10;
constexpr double kUnderSkin = 0.03;  // m, depth of a joint behind the visible surface
// m^2 for each rad^2: penalty of large rotations.
constexpr double kTurnCost = 2e-6;
constexpr double kLimitCost = 2e-3;
constexpr std::size_t kPoints = 400;
constexpr float kOpen = 0.02f;  // m, misfit of a point to all other segments that only the limb can explain
constexpr double kRoundedDown = 1.0 - 1e-9;  // sums in another order differ by less

std::uint32_t maskOf(const Limb& limb) {
  return DepthFit::bit(limb.upper) | DepthFit::bit(limb.lower) | DepthFit::bit(limb.end);
}

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}
Vector3d normal(std::mt19937_64& random, double sigma) {
  Vector3d v;
  for (int k = 0; k < 3; ++k) {
    double sum = -6.0;  // sum of twelve uniform numbers: nearly normal, the same on every machine
    for (int i = 0; i < 12; ++i) sum += uniform(random, 0.0, 1.0);
    v[k] = sigma * sum;
  }
  return v;
}

}  // namespace

void reachFor(const BodyRig& rig, const Limb& limb, const RigPlacement& X_WS, const Vector3d& goal,
              double swivel, RigPose& pose) {
  const std::size_t upper = index(limb.upper), lower = index(limb.lower);
  const RigPart& part = rig.parts[upper];
  const Transform& X_WP = X_WS[index(part.parent)];
  const Vector3d shoulder = X_WP * part.p_parent;
  const double a = rig[limb.lower].p_parent.norm(), b = rig[limb.end].p_parent.norm();
  const double reach = std::clamp((goal - shoulder).norm(), std::abs(a - b) + 0.02, a + b - 1e-3);
  const Vector3d line = (goal - shoulder).norm() > 1e-6 ? Vector3d((goal - shoulder).normalized())
                                                        : Vector3d(-X_WP.linear().col(2));
  // Angle at the shoulder, law of cosines.
  const double cosine = std::clamp((a * a + reach * reach - b * b) / (2.0 * a * reach), -1.0, 1.0);
  const Vector3d out = limb.isArm() ? Vector3d(-X_WP.linear().col(2)) : Vector3d(X_WP.linear().col(0));
  Vector3d side = out - out.dot(line) * line;
  if (side.norm() < 1e-3) side = line.unitOrthogonal();
  side = Eigen::AngleAxisd(swivel, line) * side.normalized();
  const Vector3d elbow =
      shoulder + a * (cosine * line + std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) * side);
  const Vector3d u = (elbow - shoulder).normalized();
  const Vector3d f = (shoulder + reach * line - elbow).normalized();
  Vector3d x = limb.bend * (f - f.dot(u) * u);
  if (x.norm() < 1e-6) x = -limb.bend * (side - side.dot(u) * u);
  if (x.norm() < 1e-6) x = u.unitOrthogonal();
  Matrix3d R_WS;
  R_WS.col(2) = -u;
  R_WS.col(0) = x.normalized();
  R_WS.col(1) = R_WS.col(2).cross(R_WS.col(0));
  pose.R_PS[upper] = Quaterniond(Matrix3d(X_WP.linear().transpose() * R_WS)).normalized();
  pose.angle[lower][0] = std::clamp(std::acos(std::clamp(f.dot(u), -1.0, 1.0)), rig.parts[lower].lower[0],
                                    rig.parts[lower].upper[0]);
}

/// Sum of the robust squares of the misfits (m^2) to the limb or the others.
double LimbSearch::squares(const OtherwiseExplained& of, std::uint32_t segments) {
  const std::size_t count = of.points.count;
  std::copy_n(of.others.begin(), count, scores_.begin());
  fit_->lowerToScores(of.points, X_WS_, segments, scores_.data());
  return DepthFit::robustSum(scores_.data(), count);
}

/// If the cost exceeds `limit` (m^2), the result may be any number between both.
double LimbSearch::costOf(const BodyObservation& seen, const Limb& limb, const RigPose& pose,
                          const RigPose& start, double limit) {
  const BodyRig& rig = fit_->rig();
  for (const RigSegment s : {limb.upper, limb.lower, limb.end}) placeSegment(rig, pose, s, X_WS_);
  const RigPart& part = rig[limb.upper];
  const Vector3d points = pose.R_PS[index(limb.upper)] * part.along;
  const double beyond = std::max(0.0, std::acos(std::clamp(points.dot(part.middle), -1.0, 1.0)) - part.cone);
  const double turned = pose.R_PS[index(limb.upper)].angularDistance(start.R_PS[index(limb.upper)]);
  const double bent = pose.angle[index(limb.lower)][0] - start.angle[index(limb.lower)][0];
  const double of_turn = kTurnCost * (turned * turned + bent * bent), of_limit = kLimitCost * beyond * beyond;
  const auto count = static_cast<double>(all_.points.count);
  const std::uint32_t segments = maskOf(limb);
  if (count > 0.0 && limit < kInfinity) {
    const double at_least = kRoundedDown * squares(open_, segments) / count + of_turn + of_limit;
    if (at_least > limit) return at_least;
  }
  const double mean = count > 0.0 ? squares(all_, segments) / count : 0.0;
  return mean + fit_->placeCost(seen, X_WS_, segments) + of_turn + of_limit;
}

/// Selects points, and scores them to the other segments at X_WS_.
void LimbSearch::prepare(const BodyObservation& seen, const Limb& limb) {
  const SeenPoints& points = seen.points();
  const std::size_t stride = std::max<std::size_t>(1, points.count / kPoints);
  all_.points.count = open_.points.count = 0;
  for (std::size_t i = 0; i < points.count; i += stride) all_.points.append(points, i);
  fit_->scores(all_.points, X_WS_, DepthFit::kAll & ~maskOf(limb), all_.others.data());
  fit_->lowerToChair(all_.points, X_WS_, all_.others.data());
  for (std::size_t i = 0; i < all_.points.count; ++i) {
    if (all_.others[i] < kOpen) continue;
    open_.others[open_.points.count] = all_.others[i];
    open_.points.append(all_.points, i);
  }
}

/// Records the place whose cost was computed last.
void LimbSearch::keep(std::size_t k, double cost) {
  if (tried_[k] == kMaxTries) return;
  tries_[k][tried_[k]++] = {cost, X_WS_[index(kLimbs[k].lower)].translation(),
                            X_WS_[index(kLimbs[k].end)].translation()};
}

double LimbSearch::cost(const BodyObservation& seen, std::size_t k, const RigPose& pose) {
  const Limb& limb = kLimbs[k];
  place(fit_->rig(), pose, X_WS_);
  prepare(seen, limb);
  return costOf(seen, limb, pose, pose);
}

bool LimbSearch::search(const BodyObservation& seen, std::size_t k, const Scope& scope,
                        std::mt19937_64& random, RigPose& pose) {
  const Limb& limb = kLimbs[k];
  const RigPose start = pose;
  place(fit_->rig(), start, X_WS_);
  const RigPlacement X_WS = X_WS_;
  prepare(seen, limb);
  const Vector3d wrist = X_WS[index(limb.end)].translation();
  const SeenPoints& points = all_.points;

  const double before = costOf(seen, limb, start, start);
  if (scope.recorded) {
    tried_[k] = 0;
    keep(k, before);
  }
  double smallest_cost = before * kBetter;
  bool found = false;
  const auto attempt = [&](const Vector3d& goal, double swivel) {
    RigPose other = start;
    reachFor(fit_->rig(), limb, X_WS, goal, swivel, other);
    const double cost = costOf(seen, limb, other, start, scope.kept * smallest_cost);
    if (scope.recorded) keep(k, cost);
    if (cost >= smallest_cost) return;
    smallest_cost = cost;
    pose = other;
    found = true;
  };
  for (int i = 0; i < scope.tries; ++i) {
    const double swivel = uniform(random, -1.5, 1.5);  // compilers differ in the order of arguments
    attempt(wrist + normal(random, scope.spread), swivel);
  }
  for (int draw = 0, picked = 0; draw < 40 && picked < kUnexplainedTries && points.count > 0; ++draw) {
    const std::size_t i = random() % points.count;
    if (all_.others[i] < kUnexplained) continue;
    ++picked;
    const Vector3d p = points.point(i);
    attempt(p + kUnderSkin * (p - seen.views()[points.view[i]].eye()).normalized(),
            uniform(random, -1.5, 1.5));
  }
  const BodyRig& rig = fit_->rig();
  const Vector3d joint = X_WS[index(rig[limb.upper].parent)] * rig[limb.upper].p_parent;
  const double length = lengthOf(rig, limb);
  attempt(joint - length * Vector3d::UnitZ(), 0.0);
  if (limb.isArm())
    for (const BodyView& view : seen.views())
      attempt(joint + length * (joint - view.eye()).normalized(), 0.0);
  return found;
}

}  // namespace abstand::tracking
