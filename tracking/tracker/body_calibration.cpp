// Coordinate search over body sizes.
#include "tracking/tracker/body_calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.hpp"
#include "tracking/tracker/stature.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace {

constexpr double kApart = 0.2;  // s
constexpr double kExplained = 0.8;
constexpr int kSteps = 5;                          // solver steps for an image and a changed body
constexpr std::array kChanges{0.06, 0.03, 0.015};  // relative change of a size, by sweep
// Share of the cost for each size that is 10 % off the usual one; regularises sizes that no image shows.
constexpr double kUnusual = 0.01;
constexpr double kStatureStep = 0.05;    // m
constexpr int kStatureSteps = 15;        // solver steps for an image and a changed stature
constexpr double kPlausibleCost = 1.15;  // times the smallest
constexpr double kAlikeCost = 1.05;      // likewise, of statures that explain the images alike
constexpr double kMaxFactor = 1.25;      // and its inverse: limits of human proportions

enum class Size { kLength, kGirth };

/// One size of the search: a kind of part, left and right equal.
struct Knob {
  humanmodel::PartKind kind;
  Size size;
};
constexpr std::array<Knob, 10> kKnobs{{{humanmodel::PartKind::kTorso, Size::kLength},
                                       {humanmodel::PartKind::kThigh, Size::kLength},
                                       {humanmodel::PartKind::kCalf, Size::kLength},
                                       {humanmodel::PartKind::kBiceps, Size::kLength},
                                       {humanmodel::PartKind::kForearm, Size::kLength},
                                       {humanmodel::PartKind::kTorso, Size::kGirth},
                                       {humanmodel::PartKind::kThigh, Size::kGirth},
                                       {humanmodel::PartKind::kCalf, Size::kGirth},
                                       {humanmodel::PartKind::kBiceps, Size::kGirth},
                                       {humanmodel::PartKind::kForearm, Size::kGirth}}};

/// Factor of each size relative to the usual one for the stature.
using Sizes = std::array<double, kKnobs.size()>;

humanmodel::HumanOptions optionsOf(const humanmodel::HumanOptions& start, const Sizes& sizes) {
  humanmodel::HumanOptions options = start;
  options.overrides.clear();
  const humanmodel::HumanModel usual = humanmodel::makeHuman(options);
  options.overrides = start.overrides;
  for (std::size_t k = 0; k < kKnobs.size(); ++k) {
    if (sizes[k] == 1.0) continue;
    for (std::size_t i = 0; i < humanmodel::kBodyPartCount; ++i) {
      const auto part = static_cast<humanmodel::BodyPart>(i);
      if (humanmodel::kindOf(part) != kKnobs[k].kind || start.overrides.count(part) > 0) continue;
      humanmodel::PartOverride& own = options.overrides[part];
      if (kKnobs[k].size == Size::kLength)
        own.length = sizes[k] * usual.part(part).length;
      else
        own.contour = sizes[k] * usual.part(part).contour;
    }
  }
  return options;
}

}  // namespace

void BodyCalibration::add(double t, const BodyTracker& tracker) {
  const TrackedBody& body = tracker.body();
  if (complete() || !body.found || body.misfit.explained < kExplained) return;
  if (!images_.empty() && t - images_.back().t < kApart) return;
  images_.push_back({t, tracker.seen(), body.pose, tracker.lying().lies});
}

std::optional<bool> BodyCalibration::lyingOnFront() const {
  std::size_t lying = 0, on_front = 0;
  for (const Image& image : images_) {
    const Vector3d front = image.pose.X_WP.linear().col(0);
    if (!image.lies || !facesUpOrDown(front)) continue;
    ++lying;
    on_front += front.z() < 0.0;
  }
  if (2 * lying <= images_.size()) return std::nullopt;
  return 2 * on_front > lying;
}

std::vector<RigPose> BodyCalibration::poses() const {
  std::vector<RigPose> poses;
  for (const Image& image : images_) poses.push_back(image.pose);
  return poses;
}

std::vector<RigPose> BodyCalibration::turnedPoses(const humanmodel::HumanOptions& body) const {
  const BodyRig rig = makeRig(humanmodel::makeHuman(body));
  std::vector<RigPose> turned = poses();
  for (RigPose& pose : turned) pose = flippedFacing(rig, pose);
  return turned;
}

double BodyCalibration::whenTurned(const humanmodel::HumanOptions& body) const {
  if (images_.empty()) return kNaN;
  std::vector<RigPose> as_tracked = poses(), turned = turnedPoses(body);
  return costOf(body, kTurnSteps, turned) / costOf(body, kTurnSteps, as_tracked);
}

void BodyCalibration::flipFacing(const humanmodel::HumanOptions& body) {
  std::vector<RigPose> turned = turnedPoses(body);
  costOf(body, kTurnSteps, turned);
  for (std::size_t i = 0; i < images_.size(); ++i) images_[i].pose = turned[i];
}

double BodyCalibration::costOf(const humanmodel::HumanOptions& options, int steps,
                               std::vector<RigPose>& poses) const {
  const BodyRig rig = makeRig(humanmodel::makeHuman(options));
  DepthFit fit(rig);
  DepthFit::Weights weights;
  weights.prior.setConstant(1.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < images_.size(); ++i) {
    fit.keepAboveFloor(images_[i].lies);
    fit.refine(images_[i].seen, poses[i], weights, steps, poses[i]);
    RigPlacement X_WS;
    place(rig, poses[i], X_WS);
    sum += fit.misfit(images_[i].seen, X_WS).cost;
  }
  return sum / static_cast<double>(images_.size());
}

std::optional<BodyCalibration::PlausibleStatures> BodyCalibration::plausibleStatures(
    const humanmodel::HumanOptions& start, const std::array<double, 2>& limits) const {
  if (images_.empty() || !start.height) return std::nullopt;
  /// `likely`: times the factor of an unusual stature.
  struct Cost {
    double height, plain, likely;
  };
  std::vector<Cost> costs;
  const auto note = [&](double height, std::vector<RigPose>& poses) {
    humanmodel::HumanOptions body = start;
    body.height = height;
    const double cost = costOf(body, kStatureSteps, poses);
    costs.push_back({height, cost, cost * Stature::unusual(height)});
  };
  // From the stature of the poses outwards, so that each fit starts from one of nearly the same size.
  const auto is_within = [&](double height) { return height >= limits[0] && height <= limits[1]; };
  if (!is_within(*start.height)) return std::nullopt;
  std::vector<RigPose> at_start = poses();
  note(*start.height, at_start);
  for (const double step : {kStatureStep, -kStatureStep}) {
    std::vector<RigPose> poses = at_start;
    for (double height = *start.height + step; is_within(height); height += step) note(height, poses);
  }
  const auto by_plain = [](const Cost& a, const Cost& b) { return a.plain < b.plain; };
  const auto by_likely = [](const Cost& a, const Cost& b) { return a.likely < b.likely; };
  const Cost best = *std::min_element(costs.begin(), costs.end(), by_plain),
             likeliest = *std::min_element(costs.begin(), costs.end(), by_likely);
  const bool is_clear = best.height < likeliest.height && likeliest.plain > kPlausibleCost * best.plain;
  std::array<double, 2> range{kInfinity, -kInfinity};
  for (const Cost& cost : costs) {
    const bool is_plausible = cost.likely <= kPlausibleCost * likeliest.likely ||
                              (is_clear && cost.plain <= kAlikeCost * best.plain);
    if (is_plausible) range = {std::min(range[0], cost.height), std::max(range[1], cost.height)};
  }
  return PlausibleStatures{range, best.height, is_clear};
}

void BodyCalibration::changeStature(const humanmodel::HumanOptions& start, double height) {
  if (!start.height) return;
  std::vector<RigPose> poses = this->poses();
  humanmodel::HumanOptions body = start;
  const double way = height - *start.height;
  const int steps = static_cast<int>(std::ceil(std::abs(way) / kStatureStep));
  for (int k = 1; k <= steps; ++k) {
    body.height = *start.height + way * k / steps;
    costOf(body, kStatureSteps, poses);
  }
  for (std::size_t i = 0; i < images_.size(); ++i) images_[i].pose = poses[i];
}

humanmodel::HumanOptions BodyCalibration::fit(const humanmodel::HumanOptions& start) const {
  if (images_.empty()) return start;
  std::vector<RigPose> poses = this->poses();
  Sizes best;
  best.fill(1.0);
  double smallest_cost = costOf(start, kSteps, poses);
  const auto attempt = [&](const Sizes& sizes) {
    double unusual = 0.0;
    for (const double f : sizes) unusual += std::pow((f - 1.0) / 0.1, 2);
    try {
      std::vector<RigPose> moved = poses;
      const double cost = costOf(optionsOf(start, sizes), kSteps, moved) * (1.0 + kUnusual * unusual);
      if (cost >= smallest_cost) return false;
      smallest_cost = cost;
      poses = std::move(moved);
      best = sizes;
      return true;
    } catch (const UsageError&) {
      return false;  // no valid body has such sizes
    }
  };
  // Moves one size as long as the cost decreases, first up, then down.
  // The floor stretches the feet of who lies on the front, and straight limbs do not show their joints.
  const bool keeps_lengths = lyingOnFront().value_or(false);
  const auto walk = [&](std::size_t k, double by) {
    if (keeps_lengths && kKnobs[k].size == Size::kLength) return;
    for (const double factor : {1.0 + by, 1.0 / (1.0 + by)}) {
      bool better = false;
      for (;;) {
        Sizes sizes = best;
        sizes[k] *= factor;
        if (!(sizes[k] < kMaxFactor && sizes[k] > 1.0 / kMaxFactor) || !attempt(sizes)) break;
        better = true;
      }
      if (better) return;
    }
  };
  for (const double by : kChanges)
    for (std::size_t k = 0; k < kKnobs.size(); ++k) walk(k, by);
  return optionsOf(start, best);
}

}  // namespace abstand::tracking
