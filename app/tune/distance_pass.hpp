// One pass over a recording, from which every question about margins is answered.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/run/swept_check.hpp"
#include "app/tune/approach.hpp"
#include "app/tune/braking_clearance.hpp"
#include "app/tune/exposure_tally.hpp"
#include "app/tune/need_watch.hpp"
#include "app/tune/separation.hpp"
#include "core/margin/clearance_track.hpp"

namespace abstand::tune {

struct PassResult;

/// A frame of a pass that no later one changes.
struct SettledFrame {
  const WindowFrame& frame;
  std::span<const ClosingMotion> motions;  ///< of each pair
  /// m, of each pair, as ClearanceTrack::between and braking.
  std::span<const double> between, braking;
};

struct PassOptions {
  BrakingOptions braking;
  double limit{0.0};  ///< m, MarginOptions::limit
  /// m: approaches below this clearance are told, and contacts of pairs below it limit the robot's speed.
  double near{0.2};
  /// m: how far the recording's frame and the robots' may be apart (registration of cameras and robot). It is
  /// a part of every uncertainty.
  double calibration_error{0.0};
  std::shared_ptr<const contact::ContactLimits> contact;  ///< null: contacts are not judged
  safety::SeparationOptions separation;
  /// False: the lists of PartClearance hold the last frame alone, so that memory does not grow.
  bool keep_frames{true};
  /// Hears every frame in order, once it is settled; the names and pairs of the result are complete then.
  std::function<void(const SettledFrame&, const PassResult&)> on_frame;
};

/// What a body part did in a pass. Lists, those of `track` too: one entry a frame (PassOptions::keep_frames).
struct PartClearance {
  std::string part;  ///< "hand_left"; of several people the nearest one's
  margin::ClearanceTrack track;
  std::vector<double> distance;     ///< m, measured, of the pair with the least clearance
  std::vector<double> bound;        ///< m, of that pair
  std::vector<double> uncertainty;  ///< m, of that pair: what is not known of the person's pose
  std::vector<std::uint16_t> link;  ///< of that pair, index into PassResult::links
  /// m/s, of that pair: towards each other; whole steps of kSpeedStep, rounded up.
  std::vector<double> robot_speed, person_speed;
  PartSeparation
      separation;  ///< of all pairs of the part; numbers in whole steps of kSpeedStep, on the safe side
  /// 0 to 1: share of the recorded robot speed at which transient contacts of all pairs nearer than
  /// PassOptions::near would stay within the limits; where contact is excluded, separation.speed_scale: only
  /// distance helps there. Whole steps of kSpeedStep, rounded down.
  std::vector<double> contact_scale;
  bool contact_excluded{false};  ///< ApproachJudge::excluded
};

/// m/s. A power of two, so that files keep it exactly.
inline constexpr double kSpeedStep = 1.0 / 16384.0;

/// Margin-independent: distances do not depend on margins.
struct PassResult {
  std::vector<PartClearance> parts;  ///< in the order of the body
  std::vector<std::string> links;    ///< names of the robots' links
  struct PairOfNames {
    std::uint16_t part, link;  ///< indices into `parts` and `links`
  };
  std::vector<PairOfNames> pairs;      ///< in the order of WindowFrame's lists
  std::vector<MarginNeed> link_needs;  ///< of each link, with the nearest part of anyone
  std::vector<MarginNeed> pair_needs;  ///< of each of `pairs`
  std::vector<Approach> approaches;    ///< in order of time
  PassExposure exposure;
  long swept_queries{0}, braking_queries{0};
};

/// Hears every frame of a run in lock step (RunOptions::on_cycle) and needs a second of frames in memory
/// beside what it gives. Pairs of people's parts with robots' links count, others do not. One thread.
class DistancePass {
 public:
  /// Throws UsageError for options that are not allowed, and for a scene without such a pair.
  DistancePass(const session::Session& session, const PassOptions& options);

  void frame(double t, const std::vector<query::PairResult>& results);
  const std::vector<WatchedPair>& watched() const { return window_.pairs(); }
  /// After the last frame.
  PassResult finish();

 private:
  void settle();
  void take(const WindowFrame& frame, const WindowFrame* next);
  void addFrame(double t);
  void watchNeeds(const WindowFrame& frame);
  void watchSpeeds(const WindowFrame& frame);
  void watchApproach(std::size_t part, const WindowFrame& frame);
  void lookAhead(const WindowFrame* next);

  const session::Session& session_;
  PassOptions options_;
  run::SweptCheck swept_;
  MotionWindow window_;
  BrakingClearance braking_;
  std::vector<double> limits_, uncertainty_, between_, braking_of_first_;
  std::vector<double> between_moving_;  ///< m, of each pair: what ClearanceTrack::between counts
  std::vector<NearestPair> nearest_to_link_;
  std::vector<double> link_between_, link_braking_;  ///< m
  std::vector<NeedWatch> link_watches_, pair_watches_;
  std::vector<double> closest_;  ///< m, of each part: the least clearance at any frame so far
  ApproachJudge judge_;
  std::vector<ClosingMotion> motions_;  ///< of each pair in this frame
  std::vector<std::size_t> nearest_;    ///< of each part: the pair with the least clearance in this frame
  std::vector<double> least_,
      ahead_;  ///< m, of each part: the least clearance of the last and the next frame
  struct Hardest {
    double t{0.0};
    WatchedPair pair;
    ClosingMotion motion;  ///< with the highest closing speed so far
  };
  std::vector<std::optional<Hardest>> hardest_;  ///< of each part, on its way to the next minimum
  std::optional<ExposureTally> exposure_;        ///< once the names are known
  PassResult result_;
};

}  // namespace abstand::tune
