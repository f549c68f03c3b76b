// How near a person could have come had the robots' program begun at another time.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/session/session.hpp"

namespace abstand::tune {

/// Of one body part: the least clearance over every time of the recording and every time of the robots'
/// programs, as a recording of a person and a program of a robot are not synchronised. The search is
/// certified: no phase has a smaller clearance than `lower`, between the frames too.
struct WorstPhase {
  std::string part;
  bool touches{false};  ///< a clearance at or below `enough` was found; how near they come is not searched
  /// m, certified: distance - bound - uncertainty of the pose; far too low where they touch.
  double lower{0.0};
  double distance{0.0};                ///< m, measured at the times below
  double t_person{0.0}, t_robot{0.0};  ///< s, of the recording and of the program
  std::string link;
  /// s, by which the program would have to run ahead of the recording: t_robot - t_person, within one
  /// program.
  double phase{0.0};
  double unseen{0.0};  ///< s of the recording in which the part was not seen; not searched
  long queries{0};
};

struct WorstPhaseOptions {
  double tolerance{1e-3};  ///< m, between `lower` and the clearance that was found
  /// m: where a clearance at or below it was found, how much nearer it goes is not searched; touching is the
  /// worst.
  double enough{0.0};
  double calibration_error{0.0};  ///< m, PassOptions::calibration_error
  double rate{100.0};             ///< Hz, at which programs are sampled; between the samples as PoseSegment
  std::function<bool()> interrupted{};
  std::function<void(std::size_t parts, std::size_t all)> progress{};
};

/// Best-first branch and bound over pairs of time intervals (person, robot): a pair of poses in the middle
/// bounds the distance within both intervals by how far the bodies get in them. Pairs of the scene count,
/// others do not. Robots without a motion stand. The session is moved. Empty where it was interrupted.
std::vector<WorstPhase> worstPhases(session::Session& session, const WorstPhaseOptions& options);

}  // namespace abstand::tune
