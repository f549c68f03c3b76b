// Still pixels, and a search without them.
#include "tracking/tracker/touching_things.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/simd.hpp"
#include "tracking/depth/people/learned_background.hpp"
#include "tracking/tracker/bone.hpp"

namespace abstand::tracking {
namespace {

constexpr float kDepthWeight = 0.1f;             // of the newest depth
constexpr std::int32_t kForgetAfter = 3;         // images with another depth
constexpr std::size_t kFewestThingPixels = 150;  // of things; at 320 x 240, a front leg of a chair has less
constexpr double kUprightHead = 0.85;  // share of the stature: lower heads do not belong to people who stand
constexpr double kTrunkLow = 0.6, kTrunkHigh = 0.8;  // shares of the stature
constexpr double kBesideTrunk = 0.25;  // m from its middle; hips and feet of who stands are nearer
// m from the axes of limbs and of the trunk: twice the radius of a thigh, and of the trunk with clothes.
constexpr double kBesideLimb = 0.15, kBesideBack = 0.25;
constexpr double kHighestAnkle = 0.30;   // m
constexpr double kExplainedBody = 0.90;  // share of the points that are left
// Of the cost with the things: of 1.2e-3 to 1.9e-3 m^2, 2e-4 to 6e-4 were left.
constexpr double kBetterWithout = 0.5;

/// World.
Vector3d pointAt(const PersonImage& image, std::size_t i) {
  const DepthCamera& camera = *image.camera;
  const auto width = static_cast<std::size_t>(camera.width);
  return camera.X_WC *
         camera.at(static_cast<double>(i % width), static_cast<double>(i / width), image.image->z[i]);
}

/// Whether a pixel has this mean depth (m).
bool isAt(float mean, float z) { return std::abs(z - mean) < 0.5f * depthNoise(z); }

/// Adds an image to TouchingThings::View, several pixels at a time.
[[gnu::always_inline]] inline void noteEach(std::span<const float> depths, float* mean, std::int32_t* images,
                                            std::int32_t* away) {
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const float z = depths[i], last = mean[i];
    const std::int32_t had = images[i], was_away = away[i];
    const bool is_at = isAt(last, z), is_measured = z != 0.0f;
    const std::int32_t next_away = is_at ? 0 : was_away + 1;
    const bool is_new = next_away >= kForgetAfter;
    const std::int32_t more = had + (had < TouchingThings::kStillImages ? 1 : 0);
    const float followed = last + kDepthWeight * (z - last);
    mean[i] = !is_measured ? last : is_new ? z : is_at ? followed : last;
    images[i] = !is_measured ? had : is_new ? 1 : is_at ? more : had;
    away[i] = !is_measured ? was_away : is_new ? 0 : next_away;
  }
}

void noteDepths(std::span<const float> depths, float* mean, std::int32_t* images, std::int32_t* away) {
  noteEach(depths, mean, images, away);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void noteWithAvx2(std::span<const float> depths, float* mean, std::int32_t* images,
                                          std::int32_t* away) {
  noteEach(depths, mean, images, away);
}
#else
constexpr auto noteWithAvx2 = noteDepths;
#endif

bool isMeasured(const PersonImage& image, std::size_t i) {
  return image.is_person[i] != 0 && image.image->z[i] > 0.0f;
}

/// Middle of the trunk in plan view (m, world) of a person of this stature (m); nullopt unless upright.
std::optional<Eigen::Vector2d> trunkOf(std::span<const PersonImage> images, double height) {
  double top = 0.0, count = 0.0;
  Eigen::Vector2d sum{0.0, 0.0};
  for (const PersonImage& image : images)
    for (std::size_t i = 0; i < image.image->z.size(); ++i) {
      if (!isMeasured(image, i)) continue;
      const Vector3d p = pointAt(image, i);
      top = std::max(top, p.z());
      if (p.z() < kTrunkLow * height || p.z() > kTrunkHigh * height) continue;
      const Eigen::Vector2d away = (p - image.camera->X_WC.translation()).head<2>();
      sum += p.head<2>() + BodyTracker::kHalfBody * away.normalized();
      count += 1.0;
    }
  if (top < kUprightHead * height || count == 0.0) return std::nullopt;
  return sum / count;
}

/// Axes of the trunk, the arms, and the legs that stand: a hidden one may be anywhere, as in the thing.
class Axes {
 public:
  explicit Axes(const humanmodel::SkeletonFrame& frame) : trunk_{frame[kPelvis], frame[kNeck]} {
    addLimb(frame, {kShoulderLeft, kElbowLeft, kWristLeft, kHandLeft});
    addLimb(frame, {kShoulderRight, kElbowRight, kWristRight, kHandRight});
    if (frame[kAnkleLeft].z() < kHighestAnkle) addLimb(frame, {kHipLeft, kKneeLeft, kAnkleLeft, kToeLeft});
    if (frame[kAnkleRight].z() < kHighestAnkle)
      addLimb(frame, {kHipRight, kKneeRight, kAnkleRight, kToeRight});
  }
  bool areApart(const Vector3d& p) const {
    return trunk_.distanceTo(p) > kBesideBack &&
           std::all_of(limbs_.begin(), limbs_.end(),
                       [&](const Bone& b) { return b.distanceTo(p) > kBesideLimb; });
  }

 private:
  using enum humanmodel::Joint;
  void addLimb(const humanmodel::SkeletonFrame& frame, const std::array<humanmodel::Joint, 4>& joints) {
    for (std::size_t k = 1; k < joints.size(); ++k)
      limbs_.push_back({frame[joints[k - 1]], frame[joints[k]]});
  }
  Bone trunk_;
  std::vector<Bone> limbs_;
};

}  // namespace

TouchingThings::View& TouchingThings::viewOf(const PersonImage& image) {
  const auto known =
      std::find_if(views_.begin(), views_.end(), [&](const View& v) { return v.number == image.number; });
  View& view = known != views_.end() ? *known : views_.emplace_back();
  view.number = image.number;
  const std::size_t count = image.image->z.size();
  view.z.resize(count);
  view.images.resize(count);
  view.away.resize(count);
  return view;
}

void TouchingThings::see(std::span<const PersonImage> images) {
  for (const PersonImage& image : images) {
    View& view = viewOf(image);
    (usesAvx2() ? noteWithAvx2 : noteDepths)(image.image->z, view.z.data(), view.images.data(),
                                             view.away.data());
  }
}

bool TouchingThings::isStill(const View& view, std::size_t i, const PersonImage& image) {
  const float z = image.image->z[i];
  const auto is_still = [&](std::size_t k) { return view.images[k] >= kStillImages && isAt(view.z[k], z); };
  const auto width = static_cast<std::size_t>(image.image->width);
  if (is_still(i)) return true;
  // Edges flicker: beside a thing is more of it.
  if (i < width || i + width >= view.z.size()) return false;
  return is_still(i - 1) || is_still(i + 1) || is_still(i - width) || is_still(i + width);
}

/// Sets rest_: the images without still pixels below a height (m) for which `is_thing` holds. Returns their
/// number.
std::size_t TouchingThings::setAside(std::span<const PersonImage> images, double below,
                                     const std::function<bool(const Vector3d&)>& is_thing) {
  std::size_t count = 0;
  rest_.clear();
  for (const PersonImage& image : images) {
    View& view = viewOf(image);
    view.is_person.assign(image.is_person.begin(), image.is_person.end());
    for (std::size_t i = 0; i < view.z.size(); ++i) {
      if (!isMeasured(image, i) || !isStill(view, i, image)) continue;
      const Vector3d p = pointAt(image, i);
      if (p.z() >= below || !is_thing(p)) continue;
      view.is_person[i] = 0;
      ++count;
    }
    rest_.push_back(image);
    rest_.back().is_person = view.is_person;
  }
  return count;
}

bool TouchingThings::search(double t, std::span<const PersonImage> images, double cost, BodyFollower& trial) {
  is_searched_ = false;
  const double height = trial.rig->height, below = kHighest * height;
  const std::optional<Eigen::Vector2d> trunk = trunkOf(images, height);
  if (!trunk) return false;
  const auto is_beside = [&](const Vector3d& p) { return (p.head<2>() - *trunk).norm() > kBesideTrunk; };
  if (setAside(images, below, is_beside) < kFewestThingPixels) return false;
  is_searched_ = true;
  if (!trial.track(t, rest_).found) return false;
  const Axes axes(trial.tracker->body().frame);
  if (setAside(images, below, [&](const Vector3d& p) { return axes.areApart(p); }) < kFewestThingPixels)
    return false;
  const TrackedBody& body = trial.track(t, rest_);
  return body.found && body.misfit.explained > kExplainedBody && body.misfit.cost < kBetterWithout * cost;
}

}  // namespace abstand::tracking
