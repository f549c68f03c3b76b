// One person of a depth stream: measured, then followed.
#pragma once

#include <memory>

#include "tracking/tracker/body_calibration.hpp"

namespace abstand {

/// Stature of who stands upright, from the pixels: from the highest to the lowest, the outermost half a per
/// cent left out, m; to the floor where the lowest is close to it. 0 without pixels. The floor is z = 0 of
/// `camera`'s world.
double uprightExtent(const DepthImage& image, const DepthCamera& camera,
                     std::span<const std::uint8_t> is_person);

/// Takes images of one person as they come. For the first of them the body is made from the stature that the
/// pixels show (their median, unless it is given) and followed; with the images that this explains well the
/// lengths and girths of the body are fitted, and the person is followed with these. One thread. May allocate
/// until it is fitted().
class TrackedPerson {
 public:
  struct Options {
    std::optional<double> height;  ///< m
    bool fit_body{true};           ///< lengths and girths; else those usual for the height
    std::uint64_t seed{1};
  };
  explicit TrackedPerson(const Options& options);
  /// With a body that is known already.
  TrackedPerson(const Options& options, const HumanOptions& body);

  /// Nothing while the stature is being measured.
  const TrackedBody* see(double t, const DepthImage& image, const DepthCamera& camera,
                         std::span<const std::uint8_t> is_person);
  bool fitted() const { return fitted_; }
  /// The body in use; nothing while the stature is being measured.
  const std::optional<HumanOptions>& body() const { return body_; }
  /// The rig of body().
  const BodyRig* rig() const { return rig_.get(); }
  /// Ends measuring and fitting with the images that there are.
  void settle();

 private:
  void use(const HumanOptions& body);

  Options options_;
  std::vector<double> extents_;  ///< m
  std::optional<HumanOptions> body_;
  std::unique_ptr<BodyRig> rig_;
  std::unique_ptr<BodyTracker> tracker_;
  BodyCalibration calibration_;
  bool fitted_{false};
};

}  // namespace abstand
