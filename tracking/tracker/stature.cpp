#include "tracking/tracker/stature.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/math/quantile.hpp"

namespace abstand::tracking {
namespace {

// Soles and hair, invisible to a camera at chest height.
constexpr double kUnseen = 0.02;      // m
constexpr double kHeadError = 0.05;   // m, of a head that is not the highest of the person
constexpr double kFeet = 0.2;         // m above the floor
constexpr double kOutermost = 0.005;  // share of the pixels
// m; mean and standard deviation of the statures of women and men together (ANSUR II: 1.63 and 1.76 m), and
// the share of the cost for each stature that is one standard deviation off. A body that points at the camera
// hardly shows its length.
constexpr double kMeanStature = 1.70, kStatureDeviation = 0.10, kUnusualStature = 0.05;

std::string metres(double m) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f m", m);
  return text;
}

/// Of a person who `does` something and is therefore lower than the stature, which is about `used` (m).
Stature ofLower(double seen, double used, const char* does) {
  return {Stature::Source::kInterval,
          std::min(used, Stature::kTallest),
          {seen, Stature::kTallest},
          std::string("the person ") + does + " and is " + metres(seen) + " high in the images",
          seen};
}

/// Of a person whose hands are above the head in most images, of which more than half show all of it.
Stature ofLowerHead(std::span<const VerticalExtent> images) {
  std::vector<double> heads, tops;
  for (const VerticalExtent& e : images) {
    tops.push_back(e.top);
    if (std::isfinite(e.head)) heads.push_back(e.head);
  }
  const double seen = nearestQuantile(heads, 0.5) + kUnseen, top = nearestQuantile(tops, 0.5);
  Stature stature;
  stature.seen = seen;
  stature.reason = "a hand is above the head, which is at " + metres(seen);
  if (seen < Stature::kShortestUpright) {
    stature.used = Stature::kUsual;
    stature.interval[0] = std::max(Stature::kShortest, seen - kHeadError);
  } else {
    stature.used = std::min(seen, Stature::kTallestUpright);
    stature.interval = {stature.used - kHeadError,
                        std::clamp(top, stature.used + kHeadError, Stature::kTallest)};
  }
  return stature;
}

}  // namespace

VerticalExtent verticalExtent(std::span<const PersonImage> images) {
  std::vector<double> heights;
  bool all_cut_above = true, all_cut_below = true;
  for (const auto& [image, camera, is_person, number] : images) {
    bool cut_above = false, cut_below = false, sees = false;
    for (int v = 0; v < image->height; ++v) {
      for (int u = 0; u < image->width; ++u) {
        const float z = image->at(u, v);
        if (z <= 0.0f || is_person[static_cast<std::size_t>(v * image->width + u)] == 0) continue;
        heights.push_back((camera->X_WC * camera->at(u, v, static_cast<double>(z))).z());
        sees = true;
        cut_above |= v == 0;
        cut_below |= v == image->height - 1;
      }
    }
    all_cut_above &= !sees || cut_above;
    all_cut_below &= !sees || cut_below;
  }
  if (heights.empty()) return {};
  const double low = nearestQuantile(heights, kOutermost), top = nearestQuantile(heights, 1.0 - kOutermost);
  const bool to_floor = low < kFeet;
  // A person seen down to the feet stands on the floor, whose nearest pixels are classified as floor.
  return {top - (to_floor ? std::min(low, 0.0) : low), top, to_floor && !all_cut_above && !all_cut_below,
          all_cut_above, kNaN};
}

double Stature::deviation() const {
  if (known()) return 0.0;
  const double half = 0.5 * (interval[1] - interval[0]), off = 0.5 * (interval[1] + interval[0]) - used;
  return std::sqrt(half * half / 3.0 + off * off);
}

void Stature::narrow(const std::array<double, 2>& indicated) {
  interval = {std::min(used, std::max(interval[0], indicated[0] - kProportions)),
              std::max(used, std::min(interval[1], indicated[1] + kProportions))};
}

double Stature::unusual(double height) {
  const double deviations = (height - kMeanStature) / kStatureDeviation;
  return 1.0 + kUnusualStature * deviations * deviations;
}

Stature Stature::given(double height) { return {Source::kGiven, height, {height, height}, {}}; }

Stature Stature::ofChild(double seen) { return {Source::kMeasured, seen, {seen, seen}, {}, seen}; }

Stature Stature::ofSeated(double seen) {
  return ofLower(seen, std::max(seen / kSeatedShare, kUsual), "sits");
}

Stature Stature::ofKneeling(double seen) {
  return ofLower(seen, std::max(seen / kKneelingShare, kUsual), "kneels");
}

Stature Stature::ofLowered(double seen) { return ofLower(seen, seen + kLowered, "does not stand upright"); }

Stature Stature::ofRaisedArms(double seen) {
  return {Source::kInterval,
          std::max(seen - kAboveHead, kShortest),
          {kShortest, seen},
          "arms are raised above the head, up to " + metres(seen),
          seen};
}

Stature measureStature(std::span<const VerticalExtent> images) {
  std::vector<double> heights, tops;
  std::size_t whole = 0, headless = 0, lower = 0;
  for (const VerticalExtent& e : images) {
    lower += e.whole && std::isfinite(e.head);
    heights.push_back(e.height);
    tops.push_back(e.top);
    whole += e.whole;
    headless += e.headless;
  }
  Stature stature;
  stature.used = Stature::kUsual;
  if (heights.empty()) {
    stature.reason = "no image shows the person";
    return stature;
  }
  if (2 * lower > images.size()) return ofLowerHead(images);
  const auto is_upright = [](double h) {
    return h >= Stature::kShortestUpright && h <= Stature::kTallestUpright;
  };
  const double seen = nearestQuantile(heights, 0.5) + kUnseen, top = nearestQuantile(tops, 0.5) + kUnseen;
  if (2 * whole > images.size()) {
    stature.seen = seen;
    if (is_upright(seen)) {
      stature.used = seen;
      stature.source = Stature::Source::kMeasured;
      stature.interval = {seen, seen};
      return stature;
    }
    stature.reason = "the person is " + metres(seen) + " high in the images, which is " +
                     (seen < Stature::kShortestUpright ? "less" : "more") + " than a standing adult";
  } else {
    const bool has_head = 2 * headless <= images.size();
    if (is_upright(top)) stature.used = has_head ? top : std::max(top, Stature::kUsual);
    stature.reason = "most images do not show the person from head to feet";
  }
  // Raised arms increase the extent; nothing decreases it.
  if (seen < Stature::kTallest) stature.interval[0] = std::max(Stature::kShortest, seen - kUnseen);
  return stature;
}

}  // namespace abstand::tracking
