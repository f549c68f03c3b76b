// One person of a depth stream: measured, then tracked.
#pragma once

#include <future>
#include <memory>

#include "tracking/tracker/body_calibration.hpp"
#include "tracking/tracker/coming_into_view.hpp"
#include "tracking/tracker/held_things.hpp"
#include "tracking/tracker/stature.hpp"
#include "tracking/tracker/still_things.hpp"

namespace abstand::tracking {

/// Facing direction of a person when first seen. Who lies on the front faces away: cameras are above people
/// who lie.
struct Facing {
  bool away{false};   ///< the back is to the camera
  bool given{false};  ///< set by the user
  bool lies{false};   ///< in the images that were compared
  /// Ratio of the fit costs of the first images, facing away over facing the camera; NaN: not compared.
  double ratio{kNaN};
  /// Below kBackBelow the person faces away, above kFrontAbove certainly the camera. In between the images do
  /// not decide: front is assumed and reported as undecided (docs/tracking.md has measured ratios).
  static constexpr double kBackBelow = 0.95, kFrontAbove = 1.15;
  /// Neither direction is the likelier one of people who lie.
  double backBelow() const { return lies ? 1.0 / kFrontAbove : kBackBelow; }
  /// Sets `away` and `ratio` from two ratios of costs, facing away over facing the camera: `turning`, of
  /// turned poses, and `searching`, of searches from both sides; NaN: none. A turned pose has lost what a
  /// search would find: if they disagree, `ratio` is 1, and the likelier side is assumed. If they agree,
  /// `ratio` is `turning`; of people who lie, the less certain of both.
  void decide(double turning, double searching);
  bool decided() const { return given || ratio < backBelow() || ratio > kFrontAbove; }
};

/// Body learned from the images of a person.
struct KnownBody {
  humanmodel::HumanOptions body;
  Stature stature;
  Facing facing;
  StillThings things{};        ///< around the person
  HeldThings::Extents held{};  ///< in the hands in the first images
};

/// Processes the images of one person, of one camera or several. The body is first made from the stature of
/// the first images (median of the pixel extents, unless given) and tracked as facing the camera; then, from
/// the images explained well, facing is decided, lengths and girths are fitted, and the person is tracked
/// with these. A stature that is an interval is measured again as soon as the person stands upright in view,
/// and the body fitted anew. One thread, and another one for fit_aside. May allocate until it is fitted() and
/// the stature known.
class TrackedPerson {
 public:
  struct Options {
    std::optional<double> height;  ///< m
    bool fit_body{true};           ///< fit lengths and girths; otherwise the usual ones for the stature
    bool fit_aside{false};         ///< fit on a separate thread; images are tracked with the first body
                                   ///< meanwhile
    std::optional<bool> away;      ///< initially the back is to the camera, or not; if unset, fit_body
                                   ///< decides
    std::uint64_t seed{1};
  };
  explicit TrackedPerson(const Options& options);
  /// Starts with a known body.
  TrackedPerson(const Options& options, const KnownBody& known);

  /// One image of each camera that looks at `t` (s). Null while the stature is being measured.
  const TrackedBody* see(double t, std::span<const PersonImage> images);
  /// The body in an image from before the first one that was tracked, in which it was found: tracked
  /// backwards from it. `t` (s) decreases.
  TrackedBody seeBefore(double t, std::span<const PersonImage> images);
  bool fitted() const { return fitted_; }
  /// The current body; nullopt while the stature is being measured.
  const std::optional<humanmodel::HumanOptions>& body() const { return body_; }
  const Facing& facing() const { return facing_; }
  /// Valid if body() has a value.
  const Stature& stature() const { return stature_; }
  const StillThings& things() const { return things_; }
  const HeldThings& held() const { return held_; }
  /// The rig of body().
  const std::shared_ptr<const BodyRig>& rig() const { return rig_; }
  /// Ends measuring and fitting with the images so far.
  void settle();

 private:
  struct Fit {
    humanmodel::HumanOptions body;
    Facing facing;
    Stature stature;
    double front_over_back{kNaN};  ///< Lying::front_over_back
    std::uint64_t seed{1};         ///< of searches
    bool turned{false};            ///< the person in the images faces the other way than tracked
  };
  /// Compares facing directions unless given, and statures unless one is known.
  static Fit fit(BodyCalibration images, const Fit& start);
  /// Likewise, of the facing: into fit.facing and fit.turned.
  static void decideFacing(const BodyCalibration& images, Fit& fit);
  /// A body and what follows it.
  struct Follower {
    humanmodel::HumanOptions body;
    std::shared_ptr<const BodyRig> rig;
    std::unique_ptr<BodyTracker> tracker;
  };
  Follower followerOf(const humanmodel::HumanOptions& body, const Stature& stature) const;
  void adopt(Follower follower);
  void adopt(const Fit& fit);
  void use(const humanmodel::HumanOptions& body);
  void measure(std::span<const PersonImage> images);
  const TrackedBody* follow(double t, std::span<const PersonImage> images);
  /// Returns whether there is a new body, which has tracked nothing yet.
  bool remeasure(std::span<const PersonImage> images);
  bool standsUpright() const;
  bool checkUpright(double t, std::span<const PersonImage> images);

  Options options_;
  std::vector<VerticalExtent> extents_;  ///< of the first images; later of the last ones, while needed
  std::optional<humanmodel::HumanOptions> body_;
  Facing facing_;
  Stature stature_;
  std::shared_ptr<const BodyRig> rig_;
  std::unique_ptr<BodyTracker> tracker_;
  Follower before_;  ///< backwards in time
  BodyCalibration calibration_;
  StillThings things_;
  HeldThings held_;
  std::future<Fit> fitting_;
  ComingIntoView coming_;
  bool started_{false}, fitted_{false};
};

}  // namespace abstand::tracking
