// Surfaces that are connected to a hand, and how far they reach.
#include "tracking/tracker/held_things.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

constexpr float kNotOnBody = 0.06f;  // m, DepthFit::scores() of a point that is not on the body
// m: what two cameras see of a trunk in motion does not fit one body as well, and was 0.07 to 0.09 m from it.
// A thing has points farther away than that.
constexpr float kNotOnBodyOfSeveral = 0.09f;
constexpr double kAtHand = 0.15;                         // m; nearest unexplained point of a held thing
constexpr std::size_t kFewestOfThing = 10;               // points; fewer are noise at an outline
constexpr double kOnFloor = 0.15;                        // m; soles are cut off with the floor up to there
constexpr double kHandMoved = 0.15, kThingMoved = 0.10;  // m
constexpr double kHandSeen = 0.3;                        // share of its samples
constexpr double kOutline = 0.03;  // m, one cell; cells that show little of a thing are left out

/// m; neighbours on one surface are at most this far apart: two cells, and the steps of a Kinect's depth.
double linkAt(double depth) { return 0.06 + 0.004 * depth * depth; }

/// m, to a capsule about the long axis (z) of a hand's ellipsoid.
double distanceToHand(const FitSurface& hand, const Transform& X_WS, const Vector3d& p_W) {
  Vector3d p = X_WS.inverse() * p_W - hand.centre.cast<double>();
  const Vector3d semi = hand.semi.cast<double>();
  const double radius = std::min(semi.x(), semi.y()), half = std::max(0.0, semi.z() - radius);
  p.z() -= std::clamp(p.z(), -half, half);
  return p.norm() - radius;
}

}  // namespace

int HeldThings::Hand::shown() const {
  int count = 0;
  for (int i = 1; i <= kWindow; ++i)
    count += extents[static_cast<std::size_t>((next + kMemory - i) % kMemory)] > 0.0f;
  return count;
}

HeldThings::HeldThings(const Extents& at_start) : extent_{at_start} {
  for (std::size_t k = 0; k < hands_.size(); ++k) {
    hands_[k].extents.fill(static_cast<float>(at_start[k]));
    hands_[k].holds = at_start[k] > 0.0;
  }
}

/// Sets joined_ to the points of apart_ that are connected to the hand.
void HeldThings::connect(const BodyObservation& seen, const DepthFit& fit, const RigPlacement& X_WS,
                         RigSegment hand) {
  const SeenPoints& points = seen.points();
  joined_.clear();
  const FitSurface& shape = fit.surfaces()[index(hand)];
  std::size_t left = apart_.size();
  const auto join = [&](std::size_t k) {
    joined_.push_back(apart_[k]);
    std::swap(apart_[k], apart_[--left]);
  };
  for (std::size_t k = 0; k < left;) {
    if (distanceToHand(shape, X_WS[index(hand)], points.point(apart_[k])) < kAtHand)
      join(k);
    else
      ++k;
  }
  for (std::size_t done = 0; done < joined_.size(); ++done) {
    const Vector3d p = points.point(joined_[done]);
    const double link = linkAt((p - seen.eyeOf(joined_[done])).norm());
    for (std::size_t k = 0; k < left;) {
      if ((points.point(apart_[k]) - p).squaredNorm() < link * link)
        join(k);
      else
        ++k;
    }
  }
}

/// Of joined_; `middle` (world) and `thickness` (m, smallest diameter) of the hand.
HeldThings::Surface HeldThings::measure(const BodyObservation& seen, const Vector3d& middle,
                                        double thickness) const {
  const SeenPoints& points = seen.points();
  Surface surface;
  const float far = seen.views().size() > 1 ? kNotOnBodyOfSeveral : kNotOnBody;
  for (const std::size_t i : joined_) surface.points += score_[i] > far;
  if (joined_.empty()) return surface;
  const auto rayOf = [&](std::size_t i) { return Vector3d((points.point(i) - seen.eyeOf(i)).normalized()); };
  Vector3d ray = Vector3d::Zero();
  for (const std::size_t i : joined_) {
    surface.middle += points.point(i);
    surface.lowest = std::min(surface.lowest, static_cast<double>(points.z[i]));
    ray += rayOf(i);
  }
  surface.middle /= static_cast<double>(joined_.size());
  ray.normalize();
  // Uniform across its extents: each is the root of 12 times the variance.
  const Vector3d u = ray.unitOrthogonal(), v = ray.cross(u);
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const std::size_t i : joined_) {
    const Vector3d off = points.point(i) - surface.middle;
    const Eigen::Vector2d across(u.dot(off), v.dot(off));
    scatter += across * across.transpose();
  }
  scatter /= static_cast<double>(joined_.size());
  const double mean = 0.5 * scatter.trace();
  const double smallest = mean - std::sqrt(std::max(0.0, mean * mean - scatter.determinant()));
  const double deep = std::sqrt(12.0 * std::max(0.0, smallest)) + kOutline;
  double farthest = 0.0;
  for (const std::size_t i : joined_) {
    const Vector3d off = points.point(i) - middle;
    farthest = std::max({farthest, off.norm(), (off + deep * rayOf(i)).norm()});
  }
  surface.extent = farthest - 0.5 * thickness + kOutline;
  return surface;
}

bool HeldThings::isHeld(const Surface& surface, const Vector3d& p_hand, Hand& hand) {
  if (surface.points < kFewestOfThing || surface.extent < kFist) {
    hand.hand_from.setConstant(kNaN);
    hand.moved = false;
    return false;
  }
  if (hand.hand_from.hasNaN()) {
    hand.hand_from = p_hand;
    hand.thing_from = surface.middle;
  }
  hand.moved = hand.moved || ((p_hand - hand.hand_from).norm() > kHandMoved &&
                              (surface.middle - hand.thing_from).norm() > kThingMoved);
  return hand.moved || surface.lowest > kOnFloor;
}

void HeldThings::see(const BodyObservation& seen, const DepthFit& fit, const RigPlacement& X_WS,
                     const std::array<double, kRigSegments>& visible) {
  const SeenPoints& points = seen.points();
  score_.resize(SeenPoints::kMax);
  apart_.reserve(SeenPoints::kMax);
  joined_.reserve(SeenPoints::kMax);
  fit.scores(points, X_WS, DepthFit::kAll, score_.data());
  ++images_;
  for (std::size_t k = 0; k < hands_.size(); ++k) {
    const RigSegment segment = k == 0 ? RigSegment::kHandLeft : RigSegment::kHandRight;
    apart_.clear();
    for (std::size_t i = 0; i < points.count; ++i)
      if (score_[i] > kNotOnBody) apart_.push_back(i);
    connect(seen, fit, X_WS, segment);
    const FitSurface& shape = fit.surfaces()[index(segment)];
    const Vector3d middle = X_WS[index(segment)] * shape.centre.cast<double>();
    const Surface surface = measure(seen, middle, 2.0 * static_cast<double>(shape.semi.minCoeff()));
    Hand& hand = hands_[k];
    const bool is_held = isHeld(surface, middle, hand);
    if (!is_held && visible[index(segment)] < kHandSeen) continue;
    hand.extents[static_cast<std::size_t>(hand.next)] = is_held ? static_cast<float>(surface.extent) : 0.0f;
    hand.next = (hand.next + 1) % kMemory;
    hand.without = hand.shown() >= kKept ? 0 : hand.without + 1;
    const int enough = hands_[1 - k].holds ? kKept : kNoticed;
    hand.holds = hand.holds ? hand.without < kMemory : hand.shown() >= enough;
    extent_[k] =
        hand.holds ? static_cast<double>(*std::max_element(hand.extents.begin(), hand.extents.end())) : 0.0;
    if (images_ <= kFirst) at_start_[k] = std::max(at_start_[k], extent_[k]);
  }
}

}  // namespace abstand::tracking
