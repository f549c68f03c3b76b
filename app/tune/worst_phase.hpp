// Smallest clearance over all phases of robot program and recording.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/session/session.hpp"

namespace abstand::tune {

/// For one body part: the minimum clearance over every time of the recording and every time of the robots'
/// programs, as the two are not synchronised. Certified: no phase has a smaller clearance than `lower`,
/// between frames too.
struct WorstPhase {
  std::string part;
  bool touches{false};  ///< a clearance at or below `enough` was found; the minimum was not searched further
  /// m, certified: distance - bound - pose uncertainty; far below the minimum if they touch.
  double lower{0.0};
  double distance{0.0};                ///< m, measured at the times below
  double t_person{0.0}, t_robot{0.0};  ///< s, of the recording and of the program
  std::string link;
  /// s, lead of the program over the recording: t_robot - t_person, within one program.
  double phase{0.0};
  double unseen{0.0};  ///< s of the recording in which the part was not seen; not searched
  long queries{0};
};

struct WorstPhaseOptions {
  double tolerance{1e-3};  ///< m, between `lower` and the clearance found
  /// m: the search stops at a clearance at or below this; contact is the worst case.
  double enough{0.0};
  double calibration_error{0.0};  ///< m, PassOptions::calibration_error
  double rate{100.0};             ///< Hz, sampling rate of programs; interpolated by PoseSegment
  std::function<bool()> interrupted{};
  std::function<void(std::size_t parts, std::size_t all)> progress{};
};

/// Best-first branch and bound over pairs of time intervals (person, robot): the poses at the middle of both
/// intervals give a lower bound of the distance by the motion bounds within them. Only the scene's pairs are
/// used. Robots without a motion stand still. Changes the session's poses. Empty if interrupted.
std::vector<WorstPhase> worstPhases(session::Session& session, const WorstPhaseOptions& options);

}  // namespace abstand::tune
