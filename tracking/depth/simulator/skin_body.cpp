// Body with smooth skin around the joints of a recording, for the camera simulator.
#include "tracking/depth/simulator/skin_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/math/random.hpp"
#include "tracking/depth/simulator/skin_loft.hpp"

namespace abstand::tracking {
namespace {

using enum humanmodel::Joint;

constexpr double kUnevenness = 0.08;     // variation of thicknesses with a seed
constexpr double kSameSkinPlace = 0.01;  // m, joints nearer than this coincide

// Thicknesses as shares of stature: radii of mean adult girths (ANSUR II, Gordon et al. 2014, men and women
// together), as hand-drawn profiles. x: 0 at the proximal joint, 1 at the distal one.
constexpr std::array<CurvePoint, 4> kUpperArm{{{0.0, 0.030}, {0.3, 0.029}, {0.6, 0.027}, {1.0, 0.0225}}};
constexpr std::array<CurvePoint, 4> kForearm{{{0.0, 0.0225}, {0.22, 0.0255}, {0.6, 0.020}, {1.0, 0.0155}}};
constexpr std::array<CurvePoint, 4> kThigh{{{0.0, 0.052}, {0.25, 0.051}, {0.7, 0.040}, {1.0, 0.033}}};
constexpr std::array<CurvePoint, 5> kCalf{
    {{0.0, 0.033}, {0.1, 0.031}, {0.3, 0.0335}, {0.7, 0.023}, {1.0, 0.0205}}};
/// Offset of the calf's centre behind the bone.
constexpr std::array<CurvePoint, 4> kCalfBack{{{0.0, 0.0}, {0.3, 0.010}, {0.7, 0.004}, {1.0, 0.0}}};
// The trunk; x: 0 at the hips, 1 at the line of the shoulders. Half breadth where hips and shoulders do not
// determine it, half depth, and offset of the centre in front of the spine.
constexpr std::array<CurvePoint, 6> kTrunkBreadth{
    {{-0.25, 0.060}, {0.0, 0.098}, {0.45, 0.082}, {0.75, 0.092}, {0.95, 0.098}, {1.12, 0.040}}};
constexpr std::array<CurvePoint, 6> kTrunkDepth{
    {{-0.25, 0.040}, {0.0, 0.067}, {0.40, 0.060}, {0.72, 0.070}, {0.95, 0.052}, {1.12, 0.035}}};
constexpr std::array<CurvePoint, 4> kTrunkFront{{{-0.25, -0.004}, {0.1, -0.010}, {0.5, 0.006}, {1.12, 0.0}}};
constexpr double kTrunkSquareness = 2.5;   // a chest is rounder than a box and flatter than an ellipse
constexpr double kShoulderBreadth = 0.98;  // of the shoulder distance; the upper arms round it off
constexpr double kNeckRadius = 0.034;
constexpr double kHeadHeight = 0.066, kHeadBreadth = 0.045, kHeadDepth = 0.057;  // half of each
constexpr double kHair = 0.004;                                                  // above the vertex
constexpr double kChin = 0.18;  // downward narrowing of the head
constexpr double kNose = 0.014, kNoseBreadth = 0.010, kNoseHeight = 0.016;
constexpr double kHandBreadth = 0.024, kHandDepth = 0.010;  // half of each
constexpr double kShoeLength = 0.160, kHeel = 0.042;        // behind the ankle
constexpr double kToeCap = 0.018;                           // in front of the toe tip
constexpr double kSole = 0.045;                             // below the ankle
constexpr double kShoeBreadth = 0.028;                      // half

constexpr int kRings = 18;  // along a limb
constexpr int kDome = 5;    // rings of a rounded end

Vector3d squareTo(const Vector3d& axis, const Vector3d& v) {
  Vector3d w = v - v.dot(axis) * axis;
  if (w.norm() < 1e-3 * v.norm() || w.isZero(0.0)) w = axis.unitOrthogonal();
  return w.normalized();
}

bool hasAll(const humanmodel::SkeletonFrame& f, std::initializer_list<humanmodel::Joint> joints) {
  return std::all_of(joints.begin(), joints.end(), [&](humanmodel::Joint j) { return f.has(j); });
}

/// A round limb from `from` to `to` with rounded ends. `radius` and `back` (offset of the centre behind the
/// bone, against `front`) are functions of the share of the length.
template <class Radius, class Back>
geometry::TriangleMesh limb(const Vector3d& from, const Vector3d& to, const Vector3d& front,
                            const Radius& radius, const Back& back) {
  const double length = (to - from).norm();
  const Vector3d axis = (to - from) / length, v = squareTo(axis, front), u = v.cross(axis);
  std::vector<LoftSection> sections;
  const auto add = [&](double along, double r, double share) {
    sections.push_back({from + along * axis - back(share) * v, u, v, r, r});
  };
  for (int i = 1; i <= kDome; ++i) {
    const double a = 0.5 * kPi * i / (kDome + 1), r = radius(0.0);
    add(-r * std::cos(a), r * std::sin(a), 0.0);
  }
  for (int i = 0; i <= kRings; ++i)
    add(length * i / kRings, radius(double{1} * i / kRings), double{1} * i / kRings);
  for (int i = kDome; i >= 1; --i) {
    const double a = 0.5 * kPi * i / (kDome + 1), r = radius(1.0);
    add(length + r * std::cos(a), r * std::sin(a), 1.0);
  }
  return loft(sections);
}

double none(double) { return 0.0; }

/// Position at the share `x` (linear extrapolation below 0 and above 1) along a smooth curve through points.
class Spine {
 public:
  explicit Spine(std::vector<Vector3d> points) : points_(std::move(points)), at_{0.0} {
    for (std::size_t i = 1; i < points_.size(); ++i)
      at_.push_back(at_.back() + (points_[i] - points_[i - 1]).norm());
  }
  double length() const { return at_.back(); }
  Vector3d at(double share) const {
    const double s = share * length();
    if (s <= 0.0) return points_.front() + s * tangent(0);
    if (s >= length()) return points_.back() + (s - length()) * tangent(points_.size() - 1);
    std::size_t k = 0;
    while (s > at_[k + 1]) ++k;
    const double h = at_[k + 1] - at_[k], t = (s - at_[k]) / h, r = 1.0 - t;
    return (1.0 + 2.0 * t) * r * r * points_[k] + t * r * r * h * tangent(k) +
           (1.0 + 2.0 * r) * t * t * points_[k + 1] - r * t * t * h * tangent(k + 1);
  }

 private:
  Vector3d tangent(std::size_t i) const {
    const std::size_t a = i == 0 ? 0 : i - 1, b = std::min(i + 1, points_.size() - 1);
    return (points_[b] - points_[a]) / (at_[b] - at_[a]);
  }
  std::vector<Vector3d> points_;
  std::vector<double> at_;
};

}  // namespace

std::optional<double> statureOfLegs(std::span<const humanmodel::SkeletonFrame> frames) {
  constexpr double kLegShare = 0.245 + 0.246;
  std::vector<double> statures;
  for (const humanmodel::SkeletonFrame& f : frames)
    for (const auto& [hip, knee, ankle] :
         {std::array{kHipLeft, kKneeLeft, kAnkleLeft}, std::array{kHipRight, kKneeRight, kAnkleRight}})
      if (hasAll(f, {hip, knee, ankle}))
        statures.push_back(((f[hip] - f[knee]).norm() + (f[knee] - f[ankle]).norm()) / kLegShare);
  if (statures.empty()) return std::nullopt;
  const auto middle = statures.begin() + static_cast<std::ptrdiff_t>(statures.size() / 2);
  std::nth_element(statures.begin(), middle, statures.end());
  return *middle;
}

SkinBody::SkinBody(double stature, const SkinOptions& options)
    : stature_(stature), clothing_(options.clothing) {
  // The negated form also rejects NaN.
  if (!(stature >= 0.5 && stature <= 2.5))
    throw UsageError("a stature of " + formatDouble(stature) + " m, expected 0.5 to 2.5");
  if (!(options.girth >= 0.5 && options.girth <= 2.0))
    throw UsageError("a girth of " + formatDouble(options.girth) + " times the usual one, expected 0.5 to 2");
  if (!(options.clothing >= 0.0 && options.clothing <= 0.1))
    throw UsageError("clothing of " + formatDouble(options.clothing) + " m, expected 0 to 0.1");
  Random random(options.seed, 0);
  for (double* thickness :
       {&trunk_breadth_, &trunk_depth_, &upper_arm_, &forearm_, &thigh_, &calf_, &head_, &neck_, &foot_}) {
    const double own = options.seed == 0 ? 1.0 : 1.0 + random.between(-kUnevenness, kUnevenness);
    *thickness = stature * own * (thickness == &head_ || thickness == &foot_ ? 1.0 : options.girth);
  }
}

SkinBody::Axes SkinBody::axesOf(const humanmodel::SkeletonFrame& f, humanmodel::Joint left,
                                humanmodel::Joint right) {
  const Vector3d across = (f[left] - f[right]).normalized();
  const Vector3d up = f[kNeck] - f[kPelvis];
  const Vector3d front = across.cross(up);
  return {front.isZero(1e-9) ? Vector3d(across.unitOrthogonal()) : Vector3d(front.normalized()), across};
}

void SkinBody::addTrunk(const humanmodel::SkeletonFrame& f, Parts& parts) const {
  if (!hasAll(f, {kPelvis, kNeck, kHipLeft, kHipRight, kShoulderLeft, kShoulderRight})) return;
  const Axes hips = axesOf(f, kHipLeft, kHipRight), chest = axesOf(f, kShoulderLeft, kShoulderRight);
  const Vector3d p_hips = 0.5 * (f[kHipLeft] + f[kHipRight]);
  const Vector3d p_shoulders = 0.5 * (f[kShoulderLeft] + f[kShoulderRight]);
  const double trunk = (p_shoulders - p_hips).norm();
  std::vector<Vector3d> points{p_hips};
  for (const humanmodel::Joint j : {kSpine, kThorax}) {
    if (!f.has(j)) continue;
    // In some recordings the spine's joints are behind the shoulders or coincide.
    const double before = (f[j] - points.back()).norm(), left = (p_shoulders - f[j]).norm();
    if (before > kSameSkinPlace && left > 0.12 * trunk && left < (p_shoulders - points.back()).norm())
      points.push_back(f[j]);
  }
  if ((p_shoulders - points.back()).norm() < kSameSkinPlace) return;
  points.push_back(p_shoulders);
  const Spine spine(std::move(points));

  const double half_shoulders = 0.5 * kShoulderBreadth * (f[kShoulderLeft] - f[kShoulderRight]).norm();
  std::array<CurvePoint, kTrunkBreadth.size()> breadth = kTrunkBreadth;
  for (CurvePoint& p : breadth) p.y *= trunk_breadth_;
  breadth[4].y = half_shoulders;
  std::vector<LoftSection> sections;
  const auto add = [&](double share, double shrink) {
    const double step = 0.02;
    const Vector3d up = (spine.at(share + step) - spine.at(share - step)).normalized();
    const double turn = std::clamp(share, 0.0, 1.0);
    const Vector3d left = squareTo(up, (1.0 - turn) * hips.left + turn * chest.left);
    const Vector3d front = left.cross(up);
    sections.push_back({spine.at(share) + smoothCurve(kTrunkFront, share) * stature_ * front, front, left,
                        shrink * (smoothCurve(kTrunkDepth, share) * trunk_depth_ + clothing_),
                        shrink * (smoothCurve(breadth, share) + clothing_), kTrunkSquareness});
  };
  constexpr int kTrunkRings = 36;
  const double lowest = kTrunkBreadth.front().x, highest = kTrunkBreadth.back().x;
  for (int i = 1; i <= kDome; ++i)
    add(lowest - 0.06 * std::cos(0.5 * kPi * i / kDome), std::sin(0.5 * kPi * i / kDome));
  for (int i = 1; i <= kTrunkRings; ++i) add(lowest + (highest - lowest) * i / kTrunkRings, 1.0);
  parts.push_back({"torso", loft(sections)});
}

void SkinBody::addHead(const humanmodel::SkeletonFrame& f, Parts& parts) const {
  if (!hasAll(f, {kNeck, kHeadTop, kShoulderLeft, kShoulderRight, kPelvis})) return;
  const Vector3d up = f[kHeadTop] - f[kNeck];
  if (up.norm() < kSameSkinPlace) return;
  const Vector3d axis = up.normalized();
  const Vector3d front = squareTo(axis, axesOf(f, kShoulderLeft, kShoulderRight).front);
  const Vector3d left = axis.cross(front);
  const double half = kHeadHeight * head_;
  const Vector3d centre = f[kHeadTop] + (kHair * head_ - half) * axis;
  std::vector<LoftSection> sections;
  constexpr int kHeadRings = 22;
  for (int i = 1; i < kHeadRings; ++i) {
    const double polar = kPi * i / kHeadRings, height = -std::cos(polar);
    const double narrow = std::sin(polar) * (1.0 + kChin * std::min(height, 0.0));
    sections.push_back({centre + height * half * axis, front, left, kHeadDepth * head_ * narrow,
                        kHeadBreadth * head_ * narrow});
  }
  geometry::TriangleMesh mesh = loft(sections);
  for (Vector3d& p : mesh.vertices) {
    const Vector3d from = p - centre;
    const double sideways = from.dot(left) / (kNoseBreadth * head_);
    const double below = (from.dot(axis) + 0.15 * half) / (kNoseHeight * head_);
    if (from.dot(front) > 0.0) p += kNose * head_ * std::exp(-sideways * sideways - below * below) * front;
  }
  parts.push_back({"head", std::move(mesh)});
  const Vector3d base = f[kNeck] - 0.3 * half * axis;
  if ((centre - base).norm() > kSameSkinPlace)
    parts.push_back({"neck", limb(
                                 base, centre, front, [&](double) { return kNeckRadius * neck_; }, none)});
}

void SkinBody::addArm(const humanmodel::SkeletonFrame& f, bool is_left, Parts& parts) const {
  const humanmodel::Joint shoulder = is_left ? kShoulderLeft : kShoulderRight,
                          elbow = is_left ? kElbowLeft : kElbowRight;
  const humanmodel::Joint wrist = is_left ? kWristLeft : kWristRight, hand = is_left ? kHandLeft : kHandRight;
  const auto apart = [&](humanmodel::Joint a, humanmodel::Joint b) {
    return hasAll(f, {a, b}) && (f[a] - f[b]).norm() > kSameSkinPlace;
  };
  const Vector3d front = hasAll(f, {kShoulderLeft, kShoulderRight, kNeck, kPelvis})
                             ? axesOf(f, kShoulderLeft, kShoulderRight).front
                             : Vector3d(Vector3d::UnitX());
  if (apart(shoulder, elbow))
    parts.push_back(
        {is_left ? "biceps_left" : "biceps_right",
         limb(
             f[shoulder], f[elbow], front,
             [&](double x) { return smoothCurve(kUpperArm, x) * upper_arm_ + clothing_; }, none)});
  if (apart(elbow, wrist))
    parts.push_back({is_left ? "forearm_left" : "forearm_right",
                     limb(
                         f[elbow], f[wrist], front,
                         [&](double x) { return smoothCurve(kForearm, x) * forearm_ + clothing_; }, none)});
  if (apart(wrist, hand)) {
    // The palm of a standing person faces the thigh; the thumb points forward.
    const Vector3d bone = f[hand] - f[wrist], axis = bone.normalized();
    const Vector3d v = squareTo(axis, front), u = v.cross(axis);
    std::vector<LoftSection> sections;
    constexpr int kHandRings = 14;
    for (int i = 1; i < kHandRings; ++i) {
      const double along = -std::cos(kPi * i / kHandRings);
      const double round = std::pow(std::sin(kPi * i / kHandRings), 0.6);
      // From slightly before the wrist to slightly beyond the end.
      const Vector3d centre = f[wrist] + (0.5 + 0.56 * along) * bone;
      sections.push_back({centre, u, v, kHandDepth * forearm_ * round, kHandBreadth * forearm_ * round, 2.4});
    }
    parts.push_back({is_left ? "hand_left" : "hand_right", loft(sections)});
  }
}

void SkinBody::addLeg(const humanmodel::SkeletonFrame& f, bool is_left, Parts& parts) const {
  const humanmodel::Joint hip = is_left ? kHipLeft : kHipRight, knee = is_left ? kKneeLeft : kKneeRight;
  const humanmodel::Joint ankle = is_left ? kAnkleLeft : kAnkleRight, toe = is_left ? kToeLeft : kToeRight;
  const auto apart = [&](humanmodel::Joint a, humanmodel::Joint b) {
    return hasAll(f, {a, b}) && (f[a] - f[b]).norm() > kSameSkinPlace;
  };
  Vector3d front = hasAll(f, {kHipLeft, kHipRight, kNeck, kPelvis}) ? axesOf(f, kHipLeft, kHipRight).front
                                                                    : Vector3d(Vector3d::UnitX());
  if (apart(ankle, toe)) front = f[toe] - f[ankle];
  if (apart(hip, knee))
    parts.push_back({is_left ? "thigh_left" : "thigh_right",
                     limb(
                         f[hip], f[knee], front,
                         [&](double x) { return smoothCurve(kThigh, x) * thigh_ + clothing_; }, none)});
  if (apart(knee, ankle))
    parts.push_back(
        {is_left ? "calf_left" : "calf_right",
         limb(
             f[knee], f[ankle], front, [&](double x) { return smoothCurve(kCalf, x) * calf_ + clothing_; },
             [&](double x) { return smoothCurve(kCalfBack, x) * calf_; })});
  if (apart(ankle, toe) && apart(knee, ankle)) {
    // The sole contains the toes, and is below the ankle.
    const Vector3d shin = (f[knee] - f[ankle]).normalized();
    Vector3d forward = f[toe] - f[ankle];
    const double sole = kSole * stature_;
    const double reach = forward.norm();
    const double drop = std::asin(std::min(0.6, 0.7 * sole / reach));
    const Vector3d across = squareTo(forward.normalized(), forward.normalized().cross(shin));
    forward = Eigen::AngleAxisd(drop, across) * forward.normalized();
    const Vector3d up = across.cross(forward);
    const double tip =
        std::max((f[toe] - f[ankle]).dot(forward) + kToeCap * stature_, (kShoeLength - kHeel) * stature_);
    const double heel = -kHeel * stature_;
    // Half height above the sole, from heel to tip.
    constexpr std::array<CurvePoint, 4> kShoeHeight{
        {{0.0, 0.022}, {0.35, 0.026}, {0.7, 0.014}, {1.0, 0.010}}};
    std::vector<LoftSection> sections;
    constexpr int kShoeRings = 20;
    for (int i = 1; i < kShoeRings; ++i) {
      const double x = 0.5 - 0.5 * std::cos(kPi * i / kShoeRings);
      const double round = std::pow(std::sin(kPi * i / kShoeRings), 0.5);
      const double half = smoothCurve(kShoeHeight, x) * stature_ * round;
      const Vector3d centre = f[ankle] + (heel + x * (tip - heel)) * forward + (half - sole) * up;
      sections.push_back({centre, -across, up, kShoeBreadth * foot_ * round * (0.85 + 0.15 * x), half, 2.6});
    }
    parts.push_back({is_left ? "foot_left" : "foot_right", loft(sections)});
  }
}

std::vector<SkinPart> SkinBody::wrap(const humanmodel::SkeletonFrame& frame) const {
  Parts parts;
  addTrunk(frame, parts);
  addHead(frame, parts);
  for (const bool is_left : {true, false}) {
    addArm(frame, is_left, parts);
    addLeg(frame, is_left, parts);
  }
  return parts;
}

}  // namespace abstand::tracking
