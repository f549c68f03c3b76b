// One person of a depth stream: measured, then tracked.
#pragma once

#include <future>

#include "tracking/tracker/body_calibration.hpp"
#include "tracking/tracker/body_follower.hpp"
#include "tracking/tracker/coming_into_view.hpp"
#include "tracking/tracker/facing_trial.hpp"
#include "tracking/tracker/kept_moment.hpp"
#include "tracking/tracker/still_things.hpp"
#include "tracking/tracker/touching_things.hpp"

namespace abstand::tracking {

/// Bodies learned from the images of a person.
struct KnownBody {
  struct Side {
    humanmodel::HumanOptions body;
    BodyPath path{};             ///< in the first images
    HeldThings::Extents held{};  ///< in the hands in the first images
  };
  Side assumed;               ///< faces as in `facing`
  std::optional<Side> other;  ///< faces the other way, if the facing is undecided
  Stature stature;
  Facing facing;
  StillThings things{};  ///< around the person
};

/// Processes the images of one person, of one camera or several. The body is first made from the stature of
/// the first images (median of the pixel extents, unless given) and tracked as facing the camera. From the
/// first image in which it is found, a second one is tracked that faces the other way, until their
/// decision is final (FacingTrial); see() returns the likelier one, and its reach includes the other one.
/// Lengths and girths are fitted to the images explained well, and the person is tracked with these. A
/// stature that is an interval is measured again as soon as the person stands upright in view, and a measured
/// one as soon as the person is higher, with the feet on the floor, or a body of that stature explains the
/// image better; the body is then fitted anew. One thread, and another one for fit_aside. May allocate in the
/// first BodyPath::kMaxPoses images, until it is fitted(), the stature known, and the facing direction
/// decided, and while it searches for a body apart from the followed one.
class TrackedPerson {
 public:
  struct Options {
    std::optional<double> height;   ///< m
    bool fit_body{true};            ///< fit lengths and girths; otherwise the usual ones for the stature
    bool fit_aside{false};          ///< fit on a separate thread; images are tracked with the first body
                                    ///< meanwhile
    std::optional<bool> away;       ///< initially the back is to the camera, or not; if unset, fit_body
                                    ///< decides
    bool compares_measured{false};  ///< facing directions are compared in the images that measured the
                                    ///< person, too, when the body is found: all of them at once
    bool starts_on_path{false};     ///< of a known body: no search
    bool states_spreads{true};      ///< of the joints; otherwise their states only
    std::uint64_t seed{1};
  };
  explicit TrackedPerson(const Options& options);
  /// Starts with a known body.
  TrackedPerson(const Options& options, std::shared_ptr<const KnownBody> known);

  /// One image of each camera that looks at `t` (s). Null while the stature is being measured.
  const TrackedBody* see(double t, std::span<const PersonImage> images);
  /// The body in an image from before the first one in which it was found: tracked backwards from there. `t`
  /// (s) decreases.
  TrackedBody seeBefore(double t, std::span<const PersonImage> images);
  bool fitted() const { return fitted_; }
  /// Whether both facing directions are tracked, and more images may decide.
  bool comparesFacings() const { return other_ && !facing_.decided() && !trial_.complete(); }
  /// False while the stature is being measured.
  bool hasBody() const { return static_cast<bool>(now_); }
  /// The current body, valid if hasBody(), and its rig.
  const humanmodel::HumanOptions& body() const { return now_.body; }
  const std::shared_ptr<const BodyRig>& rig() const { return now_.rig; }
  const Facing& facing() const { return facing_; }
  /// Valid if hasBody().
  const Stature& stature() const { return stature_; }
  const HeldThings& held() const { return now_.held; }
  /// What a second pass needs. Valid if hasBody().
  KnownBody known() const;
  /// Sets Facing::ratio of the direction that is assumed. If it is undecided then, the body of `other`, which
  /// saw the same images and faces the other way, is tracked too, and later images decide.
  void reviseFacing(double ratio, TrackedPerson other);
  /// Ends measuring, comparing and fitting with the images so far.
  void settle();

 private:
  static constexpr std::size_t kMeasured = 15;  ///< images
  /// Of the body that faces the camera at first, and of the one that faces away: by Facing::away.
  template <class T>
  using BySide = std::array<T, 2>;
  struct Fit {
    BySide<humanmodel::HumanOptions> body;
    Facing facing;
    Stature stature;
    double front_over_back{kNaN};  ///< Lying::front_over_back
    bool compared{false};          ///< both facing directions were tracked
    bool turned{false};            ///< the person lies the other way than tracked
  };
  /// Compares the sides of a person who lies, unless given, and statures unless one is known.
  static Fit fit(BySide<BodyCalibration> images, const Fit& start);
  /// Likewise, of the sides: into fit.facing and fit.turned.
  static void decideLying(BodyCalibration& images, bool on_front, Fit& fit);
  static void decideStature(BySide<BodyCalibration>& images, Fit& fit);
  Fit startOfFit() const;
  void adopt(const Fit& fit);
  BodyFollower followerOf(const humanmodel::HumanOptions& body, const Stature& stature, bool away) const;
  BodyFollower continued(const BodyFollower& last, const humanmodel::HumanOptions& body, bool away) const;
  bool start(double t, std::span<const PersonImage> images);
  void keepMeasured(double t, std::span<const PersonImage> images);
  void follow(double t, std::span<const PersonImage> images);
  void tryOtherFacing();
  bool separateThings(double t, std::span<const PersonImage> images);
  void searchAnew(double t, std::span<const PersonImage> images);
  const TrackedBody& track(double t, std::span<const PersonImage> images);
  void noteFirst(double t);
  void startBefore();
  void measure(std::span<const PersonImage> images);
  void makeMeasured();
  bool checkUpright(double t, std::span<const PersonImage> images);
  void compareFacings(double t, std::span<const PersonImage> images);
  void compareMeasured(double t);
  void addToTrial(double t, const BodyFollower& mine, const BodyFollower& its);
  bool mayCompare() const;
  void assume(bool away);
  void endComparison();
  void compareAgain();
  bool renewBody(double t, std::span<const PersonImage> images);
  bool isTaller(const Stature& higher, double t, std::span<const PersonImage> images) const;
  bool remeasure(double t, std::span<const PersonImage> images);
  bool mayRemeasure() const;

  Options options_;
  std::vector<VerticalExtent> extents_;  ///< of the first images; later of the last ones, while needed
  std::vector<KeptMoment> measured_;     ///< while measuring, for compares_measured
  Facing facing_;
  Stature stature_;
  BodyFollower now_;    ///< faces as assumed
  BodyFollower other_;  ///< faces the other way
  FacingTrial trial_;
  double found_t_{kNaN};  ///< s, of the last image in which now_ was found
  /// Where the bodies were found first.
  struct First {
    double t;  ///< s
    Lying lying;
    RigPose now;
    std::optional<RigPose> other;
  };
  std::optional<First> first_;
  BodyFollower before_, other_before_;  ///< backwards in time
  BySide<BodyCalibration> calibration_;
  StillThings things_;
  TouchingThings touching_;
  Backoff separations_, searches_;
  std::future<Fit> fitting_;
  ComingIntoView coming_;
  std::shared_ptr<const KnownBody> known_;  ///< until the person is found
  bool started_{false}, fitted_{false};
  bool compared_{false};  ///< other_ was started
  bool decides_{true};    ///< the facing; it does not change in a second pass
};

}  // namespace abstand::tracking
