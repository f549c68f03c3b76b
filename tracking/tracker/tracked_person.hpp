// One person of a depth stream: measured, then followed.
#pragma once

#include <future>
#include <memory>

#include "tracking/tracker/body_calibration.hpp"

namespace abstand {

/// Stature of who stands upright, from the pixels: from the highest to the lowest, the outermost half a per
/// cent left out, m; to the floor where the lowest is close to it. 0 without pixels. The floor is z = 0 of
/// `camera`'s world.
double uprightExtent(const DepthImage& image, const DepthCamera& camera,
                     std::span<const std::uint8_t> is_person);

/// Which way a person looked who was seen first.
struct Facing {
  bool away{false};  ///< the back was to the camera
  /// How much worse the first images were explained by a person who faces away than by one who faces the
  /// camera; NaN: not compared.
  double ratio{kNaN};
  /// Below it the back is taken. Of simulated people the front has given 1.3 to 4.0, the back 0.6 to 1.04
  /// (docs/tracking.md).
  static constexpr double kBackBelow = 1.15;
};

/// Takes images of one person as they come. For the first of them the body is made from the stature that the
/// pixels show (their median, unless it is given) and followed, as one that faces the camera; with the images
/// that this explains well it is decided whether it does, the lengths and girths of the body are fitted, and
/// the person is followed with these. One thread, and for
/// fit_aside another. May allocate until it is fitted().
class TrackedPerson {
 public:
  struct Options {
    std::optional<double> height;  ///< m
    bool fit_body{true};           ///< lengths and girths; else those usual for the height
    bool fit_aside{false};         ///< on a thread of its own: until it is done images are followed as before
    std::optional<bool> away;      ///< at first the back is to the camera, or not; else fit_body decides
    std::uint64_t seed{1};
  };
  explicit TrackedPerson(const Options& options);
  /// With a body that is known already.
  TrackedPerson(const Options& options, const HumanOptions& body, const Facing& facing);

  /// Nothing while the stature is being measured.
  const TrackedBody* see(double t, const DepthImage& image, const DepthCamera& camera,
                         std::span<const std::uint8_t> is_person);
  bool fitted() const { return fitted_; }
  /// The body in use; nothing while the stature is being measured.
  const std::optional<HumanOptions>& body() const { return body_; }
  const Facing& facing() const { return facing_; }
  /// The rig of body().
  const BodyRig* rig() const { return rig_.get(); }
  /// Ends measuring and fitting with the images that there are.
  void settle();

 private:
  struct Fit {
    HumanOptions body;
    Facing facing;
  };
  /// The facing is decided unless it is given.
  static Fit fit(BodyCalibration images, const HumanOptions& body, Facing facing, bool given);
  void use(const HumanOptions& body);
  void take(const Fit& fit);

  Options options_;
  std::vector<double> extents_;  ///< m
  std::optional<HumanOptions> body_;
  Facing facing_;
  std::unique_ptr<BodyRig> rig_;
  std::unique_ptr<BodyTracker> tracker_;
  BodyCalibration calibration_;
  std::future<Fit> fitting_;
  bool fitted_{false};
};

}  // namespace abstand
