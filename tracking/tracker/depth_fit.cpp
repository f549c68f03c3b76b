// Association of points, rows of the solver, cost of a pose.
#include "tracking/tracker/depth_fit.hpp"

#include <algorithm>
#include <cmath>

#include "tracking/tracker/leg_contact.hpp"
#include "tracking/tracker/surface_scores.hpp"

namespace abstand::tracking {
namespace {

constexpr float kNormalWeight = 0.03f;  // m for a normal at 90 degrees
// m: larger distances are outliers of the cost. Wider than a wrist, narrower than a torso.
constexpr float kCostReach = 0.08f;
constexpr double kExplainedFit = 0.05;  // m
constexpr double kRows = 1000.0;        // total weight of all points
constexpr double kSampleWeight = 0.6;   // a sample in free space has the weight of this many points
constexpr double kBefore = 0.04;        // m, allowed distance of a sample in front of the measured surface
constexpr double kMaxViolation = 0.3;   // m
constexpr double kJointLimitWeight = 20.0;  // 1/rad^2; 0.1 rad beyond a limit costs as much as 200 points 3
                                            // cm off
constexpr double kPlantedWeight = 3.0;      // a hidden foot on the floor has the weight of this many points
constexpr double kLegsWeight = 6.0;         // legs in each other have the weight of this many points
constexpr double kStepDamping = 1e-3;
constexpr double kMaxStepTurn = 0.35;  // rad, m, for each step
constexpr double kSeenWithin = 0.08;   // m
// Share of its own radius by which a limb's axis sample must stay outside of the trunk; the rest is soft
// tissue.
constexpr double kKeepOut = 0.5;

constexpr std::uint32_t kArms =
    DepthFit::bit(RigSegment::kUpperArmLeft) | DepthFit::bit(RigSegment::kUpperArmRight) |
    DepthFit::bit(RigSegment::kForearmLeft) | DepthFit::bit(RigSegment::kForearmRight) |
    DepthFit::bit(RigSegment::kHandLeft) | DepthFit::bit(RigSegment::kHandRight);

constexpr std::uint32_t kLegs = DepthFit::bit(RigSegment::kThighLeft) |
                                DepthFit::bit(RigSegment::kThighRight) |
                                DepthFit::bit(RigSegment::kCalfLeft) | DepthFit::bit(RigSegment::kCalfRight);

/// What a segment is scored with.
ScoredPoints scoredFor(std::size_t segment, const SeenPoints& points) {
  return {points, kNormalWeight, (kArms >> segment & 1u) != 0 ? points.no_arm.data() : nullptr};
}

RigPlacement inverseOf(const RigPlacement& X_WS) {
  RigPlacement X_SW;
  for (std::size_t s = 0; s < kRigSegments; ++s) X_SW[s] = X_WS[s].inverse();
  return X_SW;
}

/// m^2
float robustSquare(float score) {
  constexpr float kC2 = kCostReach * kCostReach;
  const float s2 = score * score;
  return kC2 * s2 / (kC2 + s2);
}

/// Bit mask of the segments that a segment's samples must stay out of.
std::uint32_t foes(RigSegment s) {
  using enum RigSegment;
  constexpr std::uint32_t kTrunk = DepthFit::bit(kPelvis) | DepthFit::bit(kChest) | DepthFit::bit(kHead);
  switch (s) {
    case kForearmLeft:
    case kForearmRight:
    case kHandLeft:
    case kHandRight:
      return kTrunk;
    case kCalfLeft:
    case kFootLeft:
      return DepthFit::bit(kCalfRight) | DepthFit::bit(kThighRight);
    case kCalfRight:
    case kFootRight:
      return DepthFit::bit(kCalfLeft) | DepthFit::bit(kThighLeft);
    default:
      return 0;
  }
}

/// Bit mask of the segments that a segment can be confused with.
std::uint32_t alike(RigSegment s) {
  using enum RigSegment;
  switch (s) {
    case kForearmLeft:
    case kForearmRight:
    case kHandLeft:
    case kHandRight:
      return foes(s) | DepthFit::bit(kThighLeft) | DepthFit::bit(kThighRight);
    case kThighLeft:
    case kThighRight:
      return 0;
    default:
      return foes(s);
  }
}

/// 0 if a camera sees the front or the back of the pelvis, within 45 degrees; 1 if all see it exactly from
/// the side.
double acrossViews(const BodyObservation& seen, const Transform& X_WP) {
  const Eigen::Vector2d front = X_WP.linear().col(0).head<2>();
  double square_sine = 1.0;
  for (const BodyView& view : seen.views()) {
    const Eigen::Vector2d ray = (X_WP.translation() - view.eye()).head<2>();
    const double along = front.dot(ray), both = front.squaredNorm() * ray.squaredNorm();
    if (both > 1e-6) square_sine = std::min(square_sine, 1.0 - along * along / both);
  }
  return std::max(0.0, 2.0 * square_sine - 1.0);
}

/// 1 if the thigh hangs down, 0 if it is raised by 60 degrees or more: the calf then shows its twist.
double hanging(const RigPart& thigh, const Transform& X_WS) {
  return std::max(0.0, -2.0 * (X_WS.linear() * thigh.along).z() - 1.0);
}

}  // namespace

DepthFit::DepthFit(const BodyRig& rig) : rig_{&rig}, surfaces_{fitSurfaces(rig)}, solver_{rig} {
  for (std::size_t i = 0; i < kRigSegments; ++i) {
    const RigSegment s = segmentAt(i);
    const Vector3d c = surfaces_[i].centre.cast<double>(), r = surfaces_[i].semi.cast<double>();
    const double radius = std::min(r.x(), r.y());
    if (i < 2) {
      for (const double side : {-0.7, 0.0, 0.7})
        for (const double up : {-0.4, 0.0, 0.4})
          samples_.push_back({s, c + Vector3d{0.0, side * r.y(), up * r.z()}, r.x()});
    } else if (s == RigSegment::kFootLeft || s == RigSegment::kFootRight) {
      for (const double along : {-0.6, 0.0, 0.6})
        samples_.push_back({s, c + Vector3d{along * r.x(), 0.0, 0.0}, r.z()});
    } else {
      for (const double along : {-0.75, -0.4, 0.0, 0.4, 0.75})
        samples_.push_back({s, c + Vector3d{0.0, 0.0, along * r.z()}, radius});
    }
  }
}

DepthFit::Violation DepthFit::violation(const BodyView& view, const Sample& sample, const Vector3d& p_W) {
  Violation v{Vector3d::Zero(), 0.0};
  const Vector3d p_C = view.X_CW() * p_W;
  const BodyView::Probe probe = view.at(p_C);
  if (probe.state == CellState::kEmpty) {
    if (probe.z > 0.0 && probe.z < p_C.z()) return v;  // behind the measured surface: occluded, not refuted
    const double out = probe.to_person.norm();
    if (out <= 0.0) return v;
    v.n = -(view.X_CW().linear().transpose() * probe.to_person) / out;
    v.depth = std::min(out, kMaxViolation);
  } else if (probe.state == CellState::kPerson && probe.z > 0.0) {
    const double before = probe.z - p_C.z() - kBefore + 0.5 * sample.radius;
    if (before <= 0.0) return v;
    v.n = -(p_W - view.eye()).normalized();
    v.depth = std::min(before, kMaxViolation);
  }
  return v;
}

DepthFit::Violation DepthFit::violation(const BodyObservation& seen, const Sample& sample,
                                        const Vector3d& p_W) {
  Violation deepest{Vector3d::Zero(), 0.0};
  for (const BodyView& view : seen.views())
    if (const Violation v = violation(view, sample, p_W); v.depth > deepest.depth) deepest = v;
  return deepest;
}

DepthFit::Violation DepthFit::overlap(const Sample& sample, const Vector3d& p_W, std::size_t other,
                                      const Transform& X_WS) const {
  const FitSurface& surface = surfaces_[other];
  Vector3d g;
  const double level = surface.level(X_WS.inverse() * p_W - surface.centre.cast<double>(), g);
  const double slope = g.norm();
  Violation v{Vector3d::Zero(), 0.0};
  if (slope < 1e-6) return v;
  const double out = (level - 1.0) / slope - kKeepOut * sample.radius;
  if (out >= 0.0) return v;
  v.n = -(X_WS.linear() * g) / slope;
  v.depth = std::min(-out, kMaxViolation);
  return v;
}

DepthFit::Violation DepthFit::sunk(const Sample& sample, const Vector3d& p_W) const {
  const double below = kKeepOut * sample.radius - p_W.z();
  if (!above_floor_ || below <= 0.0) return {Vector3d::Zero(), 0.0};
  return {-Vector3d::UnitZ(), std::min(below, kMaxViolation)};
}

void DepthFit::assign(const SeenPoints& points, const RigPlacement& X_WS) {
  std::fill_n(best_.begin(), points.count, std::numeric_limits<float>::max());
  for (std::size_t s = 0; s < kRigSegments; ++s)
    assignOf(surfaces_[s], X_WS[s], scoredFor(s, points), static_cast<std::int32_t>(s), best_.data(),
             segment_.data());
  lowerToChair(points, X_WS, best_.data(), segment_.data());
}

void DepthFit::lowerToChair(const SeenPoints& points, const RigPlacement& X_WS, float* best,
                            std::int32_t* segment) const {
  const auto chair = allows_chair_ ? ChairSpace::of(*rig_, X_WS) : std::nullopt;
  if (!chair) return;
  for (std::size_t i = 0; i < points.count; ++i) {
    if (best[i] <= kChairMisfit || !chair->holds(points.point(i))) continue;
    best[i] = kChairMisfit;
    if (segment != nullptr) segment[i] = kChair;
  }
}

void DepthFit::scores(const SeenPoints& points, const RigPlacement& X_WS, std::uint32_t segments,
                      float* best) const {
  std::fill_n(best, points.count, std::numeric_limits<float>::max());
  lowerToScores(points, X_WS, segments, best);
}

void DepthFit::lowerToScores(const SeenPoints& points, const RigPlacement& X_WS, std::uint32_t segments,
                             float* best) const {
  for (std::size_t s = 0; s < kRigSegments; ++s)
    if ((segments >> s & 1u) != 0) scoreOf(surfaces_[s], X_WS[s], scoredFor(s, points), best);
}

double DepthFit::robustSum(const float* score, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += robustSquare(score[i]);
  return sum;
}

double DepthFit::robustMean(const float* score, std::size_t count) {
  return count > 0 ? robustSum(score, count) / static_cast<double>(count) : 0.0;
}

double DepthFit::placeCost(const BodyObservation& seen, const RigPlacement& X_WS,
                           std::uint32_t segments) const {
  constexpr double kC2 = kCostReach * kCostReach;
  const auto robust = [](double v) { return kC2 * v * v / (kC2 + v * v); };
  double sum = 0.0;
  for (const Sample& sample : samples_) {
    if ((segments & bit(sample.segment)) == 0) continue;
    const Vector3d p_W = X_WS[index(sample.segment)] * sample.p_S;
    sum += robust(violation(seen, sample, p_W).depth) + robust(sunk(sample, p_W).depth);
    const std::uint32_t others = foes(sample.segment);
    for (std::size_t k = 0; k < kRigSegments; ++k) {
      if ((others >> k & 1u) == 0) continue;
      sum += robust(overlap(sample, p_W, k, X_WS[k]).depth);
    }
  }
  double of_legs = 0.0;
  if (legs_apart_ && (segments & kLegs) != 0)
    for (const LegContact& contact : legContacts(X_WS)) of_legs += robust(contact.depth);
  return (sum * kSampleWeight + of_legs * kLegsWeight) / kRows;
}

DepthMisfit DepthFit::misfit(const BodyObservation& seen, const RigPlacement& X_WS) {
  const SeenPoints& points = seen.points();
  DepthMisfit m;
  if (points.count == 0) return m;
  assign(points, X_WS);
  m.cost = robustMean(best_.data(), points.count) + placeCost(seen, X_WS, kAll);
  const RigPlacement X_SW = inverseOf(X_WS);
  double sum = 0.0;
  std::size_t explained = 0, of_chair = 0;
  for (std::size_t i = 0; i < points.count; ++i) {
    if (segment_[i] == kChair) {
      ++of_chair;
      continue;
    }
    const auto s = static_cast<std::size_t>(segment_[i]);
    const Vector3d p = points.point(i), ray = (p - seen.eyeOf(i)).normalized();
    const double d = seenDistance(surfaces_[s], X_WS[s], X_SW[s], p, ray).d;
    if (std::abs(d) > kExplainedFit) continue;
    ++explained;
    sum += d * d;
  }
  if (of_chair < points.count)
    m.explained = static_cast<double>(explained) / static_cast<double>(points.count - of_chair);
  if (explained > 0) m.residual = std::sqrt(sum / static_cast<double>(explained));
  return m;
}

void DepthFit::refine(const BodyObservation& seen, const RigPose& expected, const Weights& weights, int steps,
                      RigPose& pose) {
  const SeenPoints& points = seen.points();
  if (points.count == 0) return;
  const double share = kRows / static_cast<double>(points.count);
  const double c2 = weights.reach * weights.reach;
  for (std::size_t i = 0; i < points.count; ++i) ray_[i] = (points.point(i) - seen.eyeOf(i)).normalized();
  for (int k = 0; k < steps; ++k) {
    solver_.begin(pose);
    const RigPlacement& X_WS = solver_.placement();
    const RigPlacement X_SW = inverseOf(X_WS);
    assign(points, X_WS);
    for (std::size_t i = 0; i < points.count; ++i) {
      if (segment_[i] == kChair) continue;
      const auto s = static_cast<std::size_t>(segment_[i]);
      const Vector3d p = points.point(i);
      const SurfaceDistance hit = seenDistance(surfaces_[s], X_WS[s], X_SW[s], p, ray_[i]);
      const double robust = c2 / (c2 + hit.d * hit.d);
      // The body's surface moves towards the point: moving a point of the segment by v along n reduces the
      // distance by n.v.
      solver_.addPlane(segmentAt(s), p, -hit.n, hit.d, share * robust * robust);
    }
    for (const Sample& sample : samples_) {
      const Vector3d p_W = X_WS[index(sample.segment)] * sample.p_S;
      const Violation v = violation(seen, sample, p_W);
      if (v.depth > 0.0) solver_.addPlane(sample.segment, p_W, v.n, v.depth, kSampleWeight);
      const Violation below = sunk(sample, p_W);
      if (below.depth > 0.0) solver_.addPlane(sample.segment, p_W, below.n, below.depth, kSampleWeight);
      const std::uint32_t others = foes(sample.segment);
      for (std::size_t o = 0; o < kRigSegments; ++o) {
        if ((others >> o & 1u) == 0) continue;
        const Violation in = overlap(sample, p_W, o, X_WS[o]);
        if (in.depth > 0.0) solver_.addPlane(sample.segment, p_W, in.n, in.depth, kSampleWeight);
      }
    }
    for (const LegContact& contact : legContacts(X_WS)) {
      if (!legs_apart_ || contact.depth <= 0.0) continue;
      solver_.addPlane(contact.left, contact.p_left, -contact.n, 0.5 * contact.depth, kLegsWeight);
      solver_.addPlane(contact.right, contact.p_right, contact.n, 0.5 * contact.depth, kLegsWeight);
    }
    for (const RigSegment foot : {RigSegment::kFootLeft, RigSegment::kFootRight}) {
      if ((weights.planted & bit(foot)) == 0) continue;
      const FitSurface& shape = surfaces_[index(foot)];
      const Vector3d p_W = X_WS[index(foot)].translation();
      const auto ankle = static_cast<double>(shape.semi.z() - shape.centre.z());
      solver_.addPlane(foot, p_W, Vector3d::UnitZ(), p_W.z() - ankle, kPlantedWeight);
    }
    solver_.addPrior(expected, weights.prior);
    solver_.addLimits(kJointLimitWeight);
    if (weights.untwist > 0.0) addUntwist(seen, weights.untwist);
    solver_.step(kStepDamping, kMaxStepTurn);
    pose = solver_.pose();
  }
}

/// Seen from the side, the shape of the trunk hardly shows its direction. Thighs are rarely twisted, so the
/// feet turn the pelvis.
void DepthFit::addUntwist(const BodyObservation& seen, double weight) {
  const RigPlacement& X_WS = solver_.placement();
  const double across = acrossViews(seen, X_WS[0]);
  for (const RigSegment thigh : {RigSegment::kThighLeft, RigSegment::kThighRight})
    solver_.addUntwist(thigh, weight * across * hanging((*rig_)[thigh], X_WS[index(thigh)]));
}

void DepthFit::support(const BodyObservation& seen, const RigPlacement& X_WS,
                       std::array<double, kRigSegments>& points) const {
  constexpr float kUnexplained = kCostReach * kCostReach;
  const SeenPoints& all = seen.points();
  std::array<std::uint8_t, SeenPoints::kMax> segment{};
  std::array<float, SeenPoints::kMax> second;
  std::fill_n(best_.begin(), all.count, std::numeric_limits<float>::max());
  std::fill_n(second.begin(), all.count, std::numeric_limits<float>::max());
  for (std::size_t s = 0; s < kRigSegments; ++s) {
    scores(all, X_WS, 1u << s, score_.data());
    for (std::size_t i = 0; i < all.count; ++i) {
      second[i] = std::min(second[i], std::max(best_[i], score_[i]));
      if (score_[i] < best_[i]) segment[i] = static_cast<std::uint8_t>(s);
      best_[i] = std::min(best_[i], score_[i]);
    }
  }
  points.fill(0.0);
  for (std::size_t i = 0; i < all.count; ++i)
    points[segment[i]] += (robustSquare(second[i]) - robustSquare(best_[i])) / kUnexplained;
}

void DepthFit::gaps(const RigPlacement& X_WS, std::array<double, kRigSegments>& gap) const {
  gap.fill(kInfinity);
  for (const Sample& sample : samples_) {
    const std::size_t s = index(sample.segment);
    const std::uint32_t others = alike(sample.segment);
    for (std::size_t k = 0; k < kRigSegments; ++k) {
      if ((others >> k & 1u) == 0) continue;
      Vector3d g;
      const Vector3d p = X_WS[k].inverse() * (X_WS[s] * sample.p_S) - surfaces_[k].centre.cast<double>();
      const double level = surfaces_[k].level(p, g), slope = g.norm();
      if (slope > 1e-6) gap[s] = std::min(gap[s], (level - 1.0) / slope - sample.radius);
    }
  }
}

void DepthFit::visibility(const BodyObservation& seen, const RigPlacement& X_WS,
                          std::array<double, kRigSegments>& share) const {
  std::array<int, kRigSegments> all{}, visible{};
  for (const Sample& sample : samples_) {
    const std::size_t s = index(sample.segment);
    const Vector3d p_W = X_WS[s] * sample.p_S;
    ++all[s];
    visible[s] += std::any_of(seen.views().begin(), seen.views().end(), [&](const BodyView& view) {
      const Vector3d p_C = view.X_CW() * p_W;
      const BodyView::Probe probe = view.at(p_C);
      return probe.state == CellState::kPerson && std::abs(probe.z - (p_C.z() - sample.radius)) < kSeenWithin;
    });
  }
  for (std::size_t s = 0; s < kRigSegments; ++s)
    share[s] = static_cast<double>(visible[s]) / std::max(all[s], 1);
}

}  // namespace abstand::tracking
