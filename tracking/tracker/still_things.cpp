// Memory of each pixel, and the motion of the knees.
#include "tracking/tracker/still_things.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

constexpr std::uint8_t kPastImages = 5;  // until a thing is forgotten that is no longer there
constexpr float kMeanWeight = 0.1f;      // of the newest depth
constexpr double kMaxStillStep = 0.10;   // m between two images; knees that move farther were misplaced
constexpr int kPointPixels = 1;          // pixels to each side for which a point stands

/// m; variation of a Kinect's depth (steps of 2.9 mm z^2). Half of what the detection of people allows for
/// background, so that a hand on a thing is not taken for it.
float noiseAt(float z) { return 0.02f + 0.003f * z * z; }

}  // namespace

StillThings::View& StillThings::viewOf(const PersonImage& image) {
  const auto known =
      std::find_if(views_.begin(), views_.end(), [&](const View& v) { return v.number == image.number; });
  View& view = known != views_.end() ? *known : views_.emplace_back();
  view.number = image.number;
  view.pixels.resize(image.image->z.size());
  view.is_person.resize(image.image->z.size());
  return view;
}

bool StillThings::isThing(const Pixel& pixel, float z) const {
  const bool is_known = pixel.kept || (pixel.apart >= kApartImages && pixel.stretch != stretch_);
  return is_known && std::abs(pixel.z - z) < noiseAt(z);
}

void StillThings::update(const PersonImage& image, View& view) {
  std::copy(image.is_person.begin(), image.is_person.end(), view.is_person.begin());
  if (view.begin == view.end) return;
  const auto width = static_cast<std::size_t>(image.image->width);
  const std::size_t end = std::min(view.pixels.size(), view.end + width);
  for (std::size_t i = view.begin < width ? 0 : view.begin - width; i < end; ++i) {
    Pixel& pixel = view.pixels[i];
    const float z = image.image->z[i];
    if (pixel.z > 0.0f && z > 0.0f) {
      pixel.past = z > pixel.z + noiseAt(z) ? static_cast<std::uint8_t>(pixel.past + 1) : std::uint8_t{0};
      if (pixel.past >= kPastImages) pixel = {};
    }
    if (image.is_person[i] == 0) continue;
    // Edges flicker: beside a thing is more of it.
    bool is_thing = isThing(pixel, z);
    if (i >= width && i + width < view.pixels.size())
      for (const std::size_t beside : {i - 1, i + 1, i - width, i + width})
        is_thing = is_thing || isThing(view.pixels[beside], z);
    if (!is_thing) continue;
    view.is_person[i] = 0;
    ++removed_;
  }
}

void StillThings::keepChair() {
  for (View& view : views_)
    for (Pixel& pixel : view.pixels) pixel.kept = pixel.kept || pixel.chair >= kChairImages;
}

void StillThings::keep(std::span<const PersonImage> all, std::span<const PersonImage> rest) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    View& view = viewOf(all[k]);
    for (std::size_t i = 0; i < view.pixels.size(); ++i)
      if (all[k].is_person[i] != 0 && rest[k].is_person[i] == 0) {
        view.pixels[i] = {.z = all[k].image->z[i], .kept = true};
        view.mayHave(i);
      }
  }
}

void StillThings::forgetChair() {
  for (View& view : views_)
    for (Pixel& pixel : view.pixels) pixel.chair = 0;
}

void StillThings::forget() {
  for (View& view : views_)
    for (Pixel& pixel : view.pixels)
      if (!pixel.kept) pixel = {};
}

std::span<const PersonImage> StillThings::remove(std::span<const PersonImage> images) {
  images_.clear();
  removed_ = 0;
  for (const PersonImage& image : images) update(image, viewOf(image));
  for (const PersonImage& image : images) {
    images_.push_back(image);
    images_.back().is_person = viewOf(image).is_person;
  }
  return images_;
}

void StillThings::note(const DepthCamera& camera, const Vector3d& p_C, const Reasons& of, View& view) {
  const auto u = static_cast<int>(std::lround(camera.fx * p_C.x() / p_C.z() + camera.cx));
  const auto v = static_cast<int>(std::lround(camera.fy * p_C.y() / p_C.z() + camera.cy));
  const auto z = static_cast<float>(p_C.z());
  for (int y = std::max(0, v - kPointPixels); y <= std::min(camera.height - 1, v + kPointPixels); ++y)
    for (int x = std::max(0, u - kPointPixels); x <= std::min(camera.width - 1, u + kPointPixels); ++x) {
      const auto i = static_cast<std::size_t>(y * camera.width + x);
      Pixel& pixel = view.pixels[i];
      if (pixel.z == 0.0f && (of.is_apart || of.is_chair)) {
        pixel = {.z = z, .stretch = stretch_};
        view.mayHave(i);
      }
      if (pixel.z == 0.0f || std::abs(pixel.z - z) >= noiseAt(z)) continue;
      pixel.z += kMeanWeight * (z - pixel.z);
      if (of.is_chair && pixel.chair_image != image_ && pixel.chair < kChairImages) {
        pixel.chair_image = image_;
        ++pixel.chair;
      }
      if (!of.is_apart || pixel.image == image_ || pixel.apart >= kApartImages) continue;
      pixel.image = image_;
      ++pixel.apart;
      pixel.stretch = stretch_;
    }
}

void StillThings::noteKnees(const RigPlacement& X_WS) {
  const std::array<Vector3d, 2> knees{X_WS[index(RigSegment::kCalfLeft)].translation(),
                                      X_WS[index(RigSegment::kCalfRight)].translation()};
  const auto apart = [&](const std::array<Vector3d, 2>& others) {
    return std::max((knees[0] - others[0]).norm(), (knees[1] - others[1]).norm());
  };
  const bool is_steady = apart(last_knees_) < kMaxStillStep;
  last_knees_ = knees;
  if (!is_steady) {
    // One of the two poses is wrong, and so may be what was learned with it.
    for (View& view : views_)
      for (Pixel& pixel : view.pixels)
        if (!pixel.kept && pixel.stretch == stretch_) pixel = {};
    knees_ = knees;
  } else if (apart(knees_) > kLegMoved) {
    knees_ = knees;
    ++stretch_;
  }
}

void StillThings::learn(const BodyObservation& seen, const DepthFit& fit, const RigPlacement& X_WS) {
  noteKnees(X_WS);
  image_ = static_cast<std::uint16_t>(image_ == 65535 ? 1 : image_ + 1);
  const std::optional<ChairSpace> chair = ChairSpace::of(fit.rig(), X_WS);
  noteAll(seen, seen.points(), fit, X_WS, chair);
  noteAll(seen, seen.seat(), fit, X_WS, chair);
}

void StillThings::noteAll(const BodyObservation& seen, const SeenPoints& points, const DepthFit& fit,
                          const RigPlacement& X_WS, const std::optional<ChairSpace>& chair) {
  const bool is_seat = &points == &seen.seat();
  fit.scores(points, X_WS, DepthFit::kAll, score_.data());
  for (std::size_t i = 0; i < points.count; ++i) {
    const std::size_t k = points.view[i];
    if (k >= images_.size()) continue;
    const bool is_chair = chair && (is_seat || (score_[i] > kChairMisfit && chair->holds(points.point(i))));
    note(*images_[k].camera, seen.views()[k].X_CW() * points.point(i), {score_[i] > kApart, is_chair},
         viewOf(images_[k]));
  }
}

}  // namespace abstand::tracking
