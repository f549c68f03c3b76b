// Live depth images of a camera.
#include "tracking/depth/live/live_depth.hpp"

#include "core/base/error.hpp"
#include "tracking/depth/formats/depth_sources.hpp"
#include "tracking/depth/formats/freenect_depth.hpp"

namespace abstand::tracking {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::string_view kPrefix = "live:";
constexpr double kSilence = 5.0;  // s; a Kinect sends 30 images a second, the first within two seconds
constexpr int kMaxMillimetres = 10000;

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace

bool isLiveSource(const std::string& name) { return name.starts_with(kPrefix); }

LiveDepth::LiveDepth(const std::string& name, const DepthStreamOptions& options)
    : images_(Image{0, {{0.0, DepthImage(kKinectWidth, kKinectHeight)}, {}}}) {
  kinectOf(name);
  if (options.rate > 0.0) throw UsageError("--rate: found with a live camera, expected a recording");
  DepthSource source;
  source.facts.format = kKinectSource;
  source.facts.rate = kAssumedDepthRate;
  source.facts.rate_reason = "the arrival times of the images";
  // There is no camera file beside a live camera.
  const auto given = options.camera.empty() ? std::nullopt : givenCamera(options, {});
  chooseCamera(source, given, kKinectWidth, kKinectHeight, name);
  straight_.emplace(source.camera, options.mirror);
  noteStraightening(source.facts, source.camera, options.mirror);
  driver_ =
      std::make_unique<FreenectCamera>(name, [this](const std::uint16_t* numbers) { storeImage(numbers); });
  facts_ = source.facts;
  facts_.notes.emplace_back(driver_->isRaw()
                                ? "11-bit disparities, converted to depth by the formula in README.md"
                                : "millimetres by the camera's own calibration");
  for (int i = 0; i < static_cast<int>(depth_of_.size()); ++i) {
    const float mm = i <= kMaxMillimetres ? static_cast<float>(i) * 0.001f : 0.0f;
    depth_of_[static_cast<std::size_t>(i)] = driver_->isRaw() ? freenectDepth(i) : mm;
  }
  last_ = Clock::now();
  thread_ = std::thread([this] { watch(); });
}

LiveDepth::~LiveDepth() {
  stop_.store(true, std::memory_order_relaxed);
  thread_.join();
}

/// Called on the driver's thread. No allocation, no lock, no throw.
void LiveDepth::storeImage(const std::uint16_t* numbers) {
  last_ = Clock::now();
  if (came_ == 0) first_ = last_;
  Image& image = images_.back();
  image.number = ++came_;
  image.live.came = last_;
  image.live.frame.t = seconds(last_ - first_);
  std::vector<float>& z = image.live.frame.image.z;
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = depth_of_[numbers[i]];
  images_.publish();
  news_.release();
}

void LiveDepth::watch() {
  while (!stop_.load(std::memory_order_relaxed)) {
    if (!driver_->serve()) {
      const std::string error = driver_->lastError();
      return end("found the camera disconnected after " + std::to_string(came_) + " images" +
                 (error.empty() ? "" : " (" + error + ")") + ", expected it to stay plugged in");
    }
    if (seconds(Clock::now() - last_) > kSilence)
      return end("found no image for 5 s, after " + std::to_string(came_) +
                 " images, expected 30 per second");
  }
}

void LiveDepth::end(const std::string& why) {
  why_ = why;
  has_ended_.store(true, std::memory_order_release);
  news_.release();
}

LiveDepth::Outcome LiveDepth::next(LiveFrame& frame, double wait) {
  const auto end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wait));
  // The signal of an image may arrive after the image was read; then there is no new one.
  while (news_.try_acquire_until(end)) {
    while (news_.try_acquire()) {
    }
    // Read before the image, so that the last one is still delivered.
    const bool has_ended = has_ended_.load(std::memory_order_acquire);
    const Image& image = images_.latest();
    if (image.number > taken_) {
      dropped_ += image.number - taken_ - 1;
      taken_ = image.number;
      frame = image.live;
      straight_->straighten(frame.frame.image);
      if (has_ended) news_.release();
      return Outcome::kFrame;
    }
    if (has_ended) {
      news_.release();
      return Outcome::kEnded;
    }
  }
  return Outcome::kNothingYet;
}

std::string LiveDepth::ended() const { return has_ended_.load(std::memory_order_acquire) ? why_ : ""; }

}  // namespace abstand::tracking
