// Measure, fit, follow.
#include "tracking/tracker/tracked_person.hpp"

#include <algorithm>
#include <chrono>

#include "tracking/derived_joints.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand {
namespace {

constexpr std::size_t kMeasured = 15;  // images
// The soles and the hair that a camera at the height of the chest does not see.
constexpr double kUnseen = 0.02;                   // m
constexpr double kFeet = 0.2;                      // m over the floor
constexpr double kShortest = 1.3, kTallest = 2.1;  // m

}  // namespace

double uprightExtent(const DepthImage& image, const DepthCamera& camera,
                     std::span<const std::uint8_t> is_person) {
  std::vector<double> heights;
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      const float z = image.at(u, v);
      if (z <= 0.0f || is_person[static_cast<std::size_t>(v * image.width + u)] == 0) continue;
      heights.push_back((camera.X_WC * camera.at(u, v, static_cast<double>(z))).z());
    }
  }
  if (heights.empty()) return 0.0;
  const double low = quantile(heights, 0.005);
  // Who is seen down to the feet stands on the floor, whose nearest pixels count as floor.
  return quantile(heights, 0.995) - (low < kFeet ? std::min(low, 0.0) : low);
}

TrackedPerson::TrackedPerson(const Options& options) : options_{options} {
  facing_.away = options.away.value_or(false);
  if (!options.height) return;
  HumanOptions body;
  body.height = *options.height;
  use(body);
  fitted_ = !options.fit_body;
}

TrackedPerson::TrackedPerson(const Options& options, const HumanOptions& body, const Facing& facing)
    : options_{options}, facing_{facing} {
  use(body);
  fitted_ = true;
}

void TrackedPerson::use(const HumanOptions& body) {
  body_ = body;
  auto rig = std::make_unique<BodyRig>(makeRig(makeHuman(body)));
  tracker_ = std::make_unique<BodyTracker>(*rig, options_.seed);
  if (facing_.away) tracker_->expectAway();
  rig_ = std::move(rig);
}

const TrackedBody* TrackedPerson::see(double t, const DepthImage& image, const DepthCamera& camera,
                                      std::span<const std::uint8_t> is_person) {
  if (!tracker_) {
    const double extent = uprightExtent(image, camera, is_person);
    if (extent > 0.0) extents_.push_back(extent);
    if (extents_.size() < kMeasured) return nullptr;
    settle();
  }
  const TrackedBody* body = &tracker_->track(t, image, camera, is_person);
  if (fitted_) return body;
  if (!fitting_.valid()) {
    calibration_.add(t, *tracker_);
    if (!calibration_.complete()) return body;
    if (options_.fit_aside)
      fitting_ = std::async(std::launch::async, fit, std::move(calibration_), *body_, facing_,
                            options_.away.has_value());
  }
  if (fitting_.valid() && fitting_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return body;
  settle();
  return &tracker_->track(t, image, camera, is_person);
}

void TrackedPerson::settle() {
  if (!tracker_) {
    if (extents_.empty()) return;
    HumanOptions body;
    body.height = std::clamp(quantile(extents_, 0.5) + kUnseen, kShortest, kTallest);
    use(body);
    fitted_ = !options_.fit_body;
  } else if (!fitted_) {
    take(fitting_.valid() ? fitting_.get()
                          : fit(std::move(calibration_), *body_, facing_, options_.away.has_value()));
  }
}

TrackedPerson::Fit TrackedPerson::fit(BodyCalibration images, const HumanOptions& body, Facing facing,
                                      bool given) {
  if (!given) facing.ratio = images.whenTurned(body);
  if (facing.ratio < Facing::kBackBelow) {
    facing.away = true;
    images.turnRound(body);
  }
  return {images.fit(body), facing};
}

void TrackedPerson::take(const Fit& fit) {
  const bool turn = fit.facing.away != facing_.away;
  facing_ = fit.facing;
  const TrackedBody last = tracker_->body();
  use(fit.body);
  if (last.found) tracker_->resume(turn ? turnedRound(*rig_, last.pose) : last.pose);
  fitted_ = true;
}

}  // namespace abstand
