// A search along one size after the other.
#include "tracking/tracker/body_calibration.hpp"

#include <array>
#include <cmath>
#include <functional>

#include "core/base/error.hpp"

namespace abstand {
namespace {

constexpr double kApart = 0.2;  // s
constexpr double kExplained = 0.8;
constexpr int kSteps = 5;  // of the fit of an image to a changed body
constexpr int kSweeps = 3;
constexpr std::array kChanges{0.06, 0.03, 0.015};  // of a size, by sweep
// Of the cost, for each size that is 10 % off the usual one; keeps sizes that no image shows where they are.
constexpr double kUnusual = 0.01;
// What a human model takes at all, and what people are.
constexpr double kLeastHeight = 1.2, kMostHeight = 2.1, kMostFactor = 1.25;

enum class Size { kLength, kGirth };

/// One size that the search changes: a kind of part, left and right alike.
struct Knob {
  PartKind kind;
  Size size;
};
constexpr std::array<Knob, 10> kKnobs{{{PartKind::kTorso, Size::kLength},
                                       {PartKind::kThigh, Size::kLength},
                                       {PartKind::kCalf, Size::kLength},
                                       {PartKind::kBiceps, Size::kLength},
                                       {PartKind::kForearm, Size::kLength},
                                       {PartKind::kTorso, Size::kGirth},
                                       {PartKind::kThigh, Size::kGirth},
                                       {PartKind::kCalf, Size::kGirth},
                                       {PartKind::kBiceps, Size::kGirth},
                                       {PartKind::kForearm, Size::kGirth}}};

struct Sizes {
  double height;
  std::array<double, kKnobs.size()> factor;
};

HumanOptions optionsOf(const HumanOptions& start, const Sizes& sizes) {
  HumanOptions options = start;
  options.height = sizes.height;
  options.overrides.clear();
  const HumanModel usual = makeHuman(options);
  options.overrides = start.overrides;
  for (std::size_t k = 0; k < kKnobs.size(); ++k) {
    if (sizes.factor[k] == 1.0) continue;
    for (std::size_t i = 0; i < kBodyPartCount; ++i) {
      const auto part = static_cast<BodyPart>(i);
      if (kindOf(part) != kKnobs[k].kind || start.overrides.count(part) > 0) continue;
      PartOverride& own = options.overrides[part];
      if (kKnobs[k].size == Size::kLength)
        own.length = sizes.factor[k] * usual.part(part).length;
      else
        own.contour = sizes.factor[k] * usual.part(part).contour;
    }
  }
  return options;
}

}  // namespace

void BodyCalibration::add(double t, const BodyTracker& tracker) {
  const TrackedBody& body = tracker.body();
  if (complete() || !body.found || body.misfit.explained < kExplained) return;
  if (!images_.empty() && t - images_.back().t < kApart) return;
  images_.push_back({t, tracker.seen(), body.pose});
}

double BodyCalibration::costOf(const HumanOptions& options, std::vector<RigPose>& poses) const {
  const BodyRig rig = makeRig(makeHuman(options));
  DepthFit fit(rig);
  DepthFit::Weights weights;
  weights.prior.setConstant(1.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < images_.size(); ++i) {
    fit.refine(images_[i].seen, poses[i], weights, kSteps, poses[i]);
    RigPlacement X_WS;
    place(rig, poses[i], X_WS);
    sum += fit.misfit(images_[i].seen, X_WS).cost;
  }
  return sum / static_cast<double>(images_.size());
}

HumanOptions BodyCalibration::fit(const HumanOptions& start, bool keep_height) const {
  if (images_.empty()) return start;
  std::vector<RigPose> poses;
  for (const Image& image : images_) poses.push_back(image.pose);
  Sizes best{start.height, {}};
  best.factor.fill(1.0);
  double least = costOf(start, poses);
  const auto attempt = [&](const Sizes& sizes) {
    double unusual = 0.0;
    for (const double f : sizes.factor) unusual += std::pow((f - 1.0) / 0.1, 2);
    try {
      std::vector<RigPose> moved = poses;
      const double cost = costOf(optionsOf(start, sizes), moved) * (1.0 + kUnusual * unusual);
      if (cost >= least) return false;
      least = cost;
      poses = std::move(moved);
      best = sizes;
      return true;
    } catch (const UsageError&) {
      return false;  // no body has such sizes
    }
  };
  // As far as it gets better, first up, then down.
  const auto walk = [&](const std::function<bool(Sizes&, double)>& change, double by) {
    for (const double factor : {1.0 + by, 1.0 / (1.0 + by)}) {
      bool better = false;
      for (;;) {
        Sizes sizes = best;
        if (!change(sizes, factor) || !attempt(sizes)) break;
        better = true;
      }
      if (better) return;
    }
  };
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const double by = kChanges[static_cast<std::size_t>(sweep)];
    if (!keep_height)
      walk(
          [](Sizes& s, double factor) {
            s.height *= factor;
            return s.height > kLeastHeight && s.height < kMostHeight;
          },
          0.5 * by);
    for (std::size_t k = 0; k < kKnobs.size(); ++k)
      walk(
          [k](Sizes& s, double factor) {
            s.factor[k] *= factor;
            return s.factor[k] < kMostFactor && s.factor[k] > 1.0 / kMostFactor;
          },
          by);
  }
  return optionsOf(start, best);
}

}  // namespace abstand
