// One person of a depth stream: measured, then followed.
#pragma once

#include <future>
#include <memory>

#include "tracking/tracker/body_calibration.hpp"
#include "tracking/tracker/stature.hpp"

namespace abstand::tracking {

/// Which way a person looked who was seen first.
struct Facing {
  bool away{false};   ///< the back was to the camera
  bool given{false};  ///< by the user
  /// How much worse the first images were explained by a person who faces away than by one who faces the
  /// camera; NaN: not compared.
  double ratio{kNaN};
  /// Below the one the back is taken, above the other the front is certain. Between them the images do not
  /// decide: the front is taken, and that is said (docs/tracking.md has measured ratios).
  static constexpr double kBackBelow = 0.95, kFrontAbove = 1.15;
  bool decided() const { return given || ratio < kBackBelow || ratio > kFrontAbove; }
};

/// What the images of a person have told of the body.
struct KnownBody {
  humanmodel::HumanOptions body;
  Stature stature;
  Facing facing;
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
  TrackedPerson(const Options& options, const KnownBody& known);

  /// Nothing while the stature is being measured.
  const TrackedBody* see(double t, const DepthImage& image, const DepthCamera& camera,
                         std::span<const std::uint8_t> is_person);
  bool fitted() const { return fitted_; }
  /// The body in use; nothing while the stature is being measured.
  const std::optional<humanmodel::HumanOptions>& body() const { return body_; }
  const Facing& facing() const { return facing_; }
  /// Meaningful with body().
  const Stature& stature() const { return stature_; }
  /// The rig of body().
  const BodyRig* rig() const { return rig_.get(); }
  /// Ends measuring and fitting with the images that there are.
  void settle();

 private:
  struct Fit {
    humanmodel::HumanOptions body;
    Facing facing;
  };
  /// The facing is compared unless it is given.
  static Fit fit(BodyCalibration images, const humanmodel::HumanOptions& body, Facing facing);
  void use(const humanmodel::HumanOptions& body);
  void take(const Fit& fit);

  Options options_;
  std::vector<VerticalExtent> extents_;
  std::optional<humanmodel::HumanOptions> body_;
  Facing facing_;
  Stature stature_;
  std::unique_ptr<BodyRig> rig_;
  std::unique_ptr<BodyTracker> tracker_;
  BodyCalibration calibration_;
  std::future<Fit> fitting_;
  bool fitted_{false};
};

}  // namespace abstand::tracking
