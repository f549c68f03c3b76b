// What margins would have done, played frame by frame and millisecond by millisecond.
#pragma once

#include <map>

#include "app/run/run_scene.hpp"
#include "app/tune/watched_pairs.hpp"
#include "humanmodel/body_part.hpp"

namespace abstand::testing {

/// What samples of a stretch of time found of the distance of bodies, m.
struct Sampled {
  double measured{kInfinity};  ///< smallest distance
  double certain{kInfinity};   ///< smallest distance less bound and pose uncertainty
  void take(const Sampled& other);
};

/// kNear: no touch, but within the engine's largest bound; kUnsure: within FrameByFrame::kTolerance.
enum class Touch { kNo, kNear, kUnsure, kYes };

/// The loop of a recording, a scene and a robot that is stopped: at each frame of `abstand run` the certified
/// clearance is compared with the margin; the robot that is told to stop goes on for its reaction time and
/// brakes along its program (forward kinematics of its motion), the person goes on, each body from frame to
/// frame on a line and about one axis, and cold queries every kStep say whether they touch. Shares with
/// app/tune nothing but the list of pairs, and with core/margin nothing. The closed loop of app/loop has no
/// time between cause and stop, and its laws bend the program, so it cannot play this.
class FrameByFrame {
 public:
  static constexpr double kStep = 1e-3;  ///< s
  /// m/s, no two bodies approach faster; checked on every recording.
  static constexpr double kFastest = 30.0;
  /// m: links go along the program here, and there from frame to frame on lines; so far these are apart.
  static constexpr double kPath = 5e-4;
  /// m: the search of the program ends within 1e-4 m, half a step of 1 ms brings bodies at 3 m/s 1.5e-3 m
  /// nearer than samples see, and kPath. A certified clearance may be smaller than a sampled one by so much.
  static constexpr double kTolerance = 1e-4 + 1.5e-3 + kPath;

  /// m: where a query near contact proves its distance by no plane, its bound is that of a search, 9 mm at
  /// points of 5 mm (docs/control.md); so much at the 20 mm of these clips. A certified clearance between
  /// frames may be smaller by so much, at a moment that no sample is at.
  static constexpr double kSearch = 0.036;

  struct Options {
    double reaction_time, deceleration, limit, restart_time;
  };
  FrameByFrame(session::Session& session, const Options& options, const run::RunOptions& run);

  using Parts = std::vector<humanmodel::BodyPart>;
  std::size_t frames() const { return frames_.size(); }
  double clearance(const Parts& parts, std::size_t frame) const;
  /// Whether a robot that is told to stop at the frame touches before it rests.
  Touch stopped(const Parts& parts, std::size_t frame);

  using PerPart = std::array<Sampled, humanmodel::kBodyPartCount>;
  /// Of the frames at which judge() told the robot to stop: until it rests. Infinite where nothing came
  /// within 1 cm and kSearch of the limit.
  const std::map<std::size_t, PerPart>& stops() const { return stopped_; }

  /// What a count may be: within the tolerance, and with the bound of a search on the safe side.
  struct Count {
    long least{0}, most{0}, safe_least{0}, safe_most{0};
    bool holds(long n) const { return least <= n && n <= most; }
    bool holdsSafely(long n) const { return safe_least <= n && n <= safe_most; }
    bool exact() const { return least == most; }
  };
  struct Judged {
    long stops{0};
    Count false_stops, missed_stops;
    double stopped_time{0.0};  ///< s
  };
  /// From frame `first` on.
  Judged judge(const Parts& parts, double margin, std::size_t first);

 private:
  struct Frame {
    double t;
    std::vector<Transform> X_WB;                           ///< of objects
    std::vector<double> q;                                 ///< of all robots
    std::vector<double> distance, clearance, uncertainty;  ///< of pairs
  };
  /// Clock and program of a robot, s from the beginning of a stretch.
  struct Drive {
    std::vector<double> t, s;
  };

  void checkSpeeds() const;
  bool moves(std::size_t object, std::size_t frame) const;
  double brakingTime(std::size_t robot, double from) const;
  Drive stop(std::size_t robot, std::size_t frame) const;
  Transform personAt(std::size_t object, double t) const;
  PerPart sample(std::size_t frame, const std::vector<Drive>& drives);
  const PerPart& inStep(std::size_t frame);
  const PerPart& stoppedAt(std::size_t frame);
  static Sampled of(const Parts& parts, const PerPart& all);
  Sampled atFrame(const Parts& parts, std::size_t frame) const;
  Touch touch(const Sampled& sampled) const;

  session::Session& session_;
  Options options_;
  std::vector<tune::WatchedPair> pairs_;
  std::vector<Frame> frames_;
  std::map<std::size_t, PerPart> in_step_, stopped_;
  kernels::PairScratch scratch_;
};

}  // namespace abstand::testing
