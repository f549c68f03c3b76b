// Single pass over a recording that collects all data for margins.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/run/swept_check.hpp"
#include "app/tune/approach.hpp"
#include "app/tune/braking_clearance.hpp"
#include "app/tune/exposure_tally.hpp"
#include "app/tune/frame_contact.hpp"
#include "app/tune/need_watch.hpp"
#include "app/tune/separation.hpp"
#include "core/margin/clearance_track.hpp"
#include "core/safety/separation_standard.hpp"

namespace abstand::tune {

struct PassResult;

/// A frame that later frames do not change any more.
struct SettledFrame {
  const WindowFrame& frame;
  std::span<const ClosingMotion> motions;  ///< of each pair
  /// m, of each pair, as ClearanceTrack::between and braking.
  std::span<const double> between, braking;
};

struct PassOptions {
  BrakingOptions braking;
  double limit{0.0};  ///< m, MarginOptions::limit
  /// m: approaches below this clearance are reported, and contacts of pairs below it limit the robot's speed.
  double near{0.2};
  /// m: registration error between the frames of recording and robots. Part of every uncertainty.
  double calibration_error{0.0};
  /// s: how old a pose of a person is when it arrives (latency.hpp). Part of every uncertainty.
  double latency{0.0};
  std::shared_ptr<const contact::ContactLimits> contact;  ///< null: contacts are not judged
  /// Names of body parts that may be clamped between a robot and something fixed: their contacts are judged
  /// as quasi-static ones. Sorted, each once.
  std::vector<std::string> clamped;
  safety::SeparationOptions separation;
  /// Where numbers of `separation` come from; null: the defaults of the program.
  std::shared_ptr<const safety::SeparationStandard> separation_standard;
  /// False: the lists of PartClearance hold the last frame alone, so that memory does not grow.
  bool keep_frames{true};
  std::size_t frames{0};  ///< expected, with keep_frames
  /// Hears every frame in order, once it is settled; the names and pairs of the result are complete then.
  std::function<void(const SettledFrame&, const PassResult&)> on_frame;
};

/// What a body part did in a pass. Lists, those of `track` too: one entry a frame (PassOptions::keep_frames).
struct PartClearance {
  std::string part;  ///< "hand_left"; for several people the nearest one's
  margin::ClearanceTrack track;
  std::vector<double> distance;     ///< m, measured, of the pair with the smallest clearance
  std::vector<double> bound;        ///< m, of that pair
  std::vector<double> uncertainty;  ///< m, of that pair: pose uncertainty of the person
  /// m, of that pair: share of the uncertainty due to the age of the pose, for a part not seen recently.
  std::vector<double> age_uncertainty;
  std::vector<double> latency_uncertainty;  ///< m, of that pair: share of the uncertainty due to the latency
  std::vector<std::uint16_t> link;          ///< index of that pair's link in PassResult::links
  std::vector<std::uint16_t> tool;  ///< index in PassResult::tools; kNoTool: the part itself is nearest
  /// m/s, of that pair, towards each other; rounded up to whole steps of kSpeedStep.
  std::vector<double> robot_speed, person_speed;
  PartSeparation
      separation;  ///< over all pairs of the part; in whole steps of kSpeedStep, rounded to the safe side
  /// 0 to 1: share of the recorded robot speed at which contacts of all pairs nearer than
  /// PassOptions::near would be within the limits; if contact is excluded, separation.speed_scale, as only
  /// distance helps there. Rounded down to whole steps of kSpeedStep.
  std::vector<double> contact_scale;
  std::vector<FrameContact> contact;
  PartContacts contacts;         ///< over all frames
  bool contact_excluded{false};  ///< ApproachJudge::excluded
};

/// Reserves the lists for so many frames, so that they do not grow by copies.
void reserveFrames(std::size_t frames, PartClearance& part);
/// Empties the lists and releases their memory; what holds for the whole recording stays.
void dropFrames(PartClearance& part);

/// m/s. A power of two, so that files store it exactly.
inline constexpr double kSpeedStep = 1.0 / 16384.0;

/// Independent of margins, as distances do not depend on them.
struct PassResult {
  std::vector<PartClearance> parts;  ///< in the order of the body
  std::vector<std::string> links;    ///< names of the robots' links
  std::vector<std::string>
      regions;                     ///< names of the regions of FrameContact, in the order of their first use
  std::vector<std::string> tools;  ///< names of the objects in people's hands: "operator/driver"
  struct PairOfNames {
    std::uint16_t part, link;     ///< indices into `parts` and `links`
    std::uint16_t tool{kNoTool};  ///< index into `tools`; kNoTool: the part itself
  };
  /// Name of a tool; empty for kNoTool.
  std::string toolName(std::uint16_t tool) const { return tool == kNoTool ? std::string() : tools.at(tool); }
  std::vector<PairOfNames> pairs;      ///< in the order of WindowFrame's lists
  std::vector<MarginNeed> link_needs;  ///< of each link, with the nearest part of any person
  std::vector<MarginNeed> pair_needs;  ///< of each of `pairs`
  std::vector<Approach> approaches;    ///< in order of time
  PassExposure exposure;
  long swept_queries{0}, braking_queries{0};
};

/// Receives every frame of a run in lock step (RunOptions::on_cycle) and keeps a second of frames in memory
/// besides the result. Only pairs of people's parts with robots' links are used. One thread.
class DistancePass {
 public:
  /// Throws UsageError for invalid options, and for a scene without such a pair.
  DistancePass(const session::Session& session, const PassOptions& options);

  void frame(double t, const std::vector<query::PairResult>& results);
  const std::vector<WatchedPair>& watched() const { return window_.pairs(); }
  /// Call after the last frame.
  PassResult finish();

 private:
  void settle();
  void take(const WindowFrame& frame, const WindowFrame* next);
  void addFrame(double t);
  void watchNeeds(const WindowFrame& frame);
  void watchSpeeds(const WindowFrame& frame);
  void watchContact(std::size_t pair, const WindowFrame& frame);
  void watchApproach(std::size_t part, const WindowFrame& frame);
  void lookAhead(const WindowFrame* next);

  const session::Session& session_;
  PassOptions options_;
  MotionWindow window_;
  run::SweptCheck swept_;
  BrakingClearance braking_;
  std::vector<double> limits_, uncertainty_, between_, braking_of_first_;
  std::vector<double> between_moving_;  ///< m, of each pair: values that ClearanceTrack::between includes
  std::vector<NearestPair> nearest_to_link_;
  std::vector<double> link_between_, link_braking_;  ///< m
  std::vector<NeedWatch> link_watches_, pair_watches_;
  std::vector<double> closest_;  ///< m, of each part: smallest clearance at any frame so far
  ApproachJudge judge_;
  std::vector<ClosingMotion> motions_;  ///< of each pair in this frame
  std::vector<std::size_t> nearest_;    ///< of each part: pair with the smallest clearance in this frame
  std::vector<double> least_,
      ahead_;  ///< m, of each part: smallest clearance of the last and the next frame
  struct Hardest {
    double t{0.0};
    WatchedPair pair;
    ClosingMotion motion;  ///< with the highest closing speed so far
  };
  std::vector<std::optional<Hardest>> hardest_;  ///< of each part, until its next minimum
  std::optional<ExposureTally> exposure_;        ///< created once the names are known
  PassResult result_;
};

}  // namespace abstand::tune
