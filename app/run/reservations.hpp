// What weakens a verdict, and so stands beside it in every output of `run` and `check`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/session.hpp"
#include "core/scene/scene_note.hpp"

namespace abstand::run {

/// One reason to doubt a verdict.
struct Reservation {
  /// One of: refused_pose, stale_pose, inferred_pose, no_person, outside_recording, interrupted (of the
  /// frames that were run); frames_missing, gaps, unmapped_part, units_guess, up_guess, floor, recording (of
  /// recordings); no_body, missing_body, bodiless, link_center, mesh, no_limits, joint_limit (of robots and
  /// bodies); no_pairs.
  std::string kind;
  std::string text;              ///< one line
  std::optional<double> t0, t1;  ///< s, where it holds for a time only
  std::optional<double> share;   ///< of the frames, 0 to 1
  scene::Severity fails{scene::Severity::kStrict};
  std::string recording;  ///< of `check` over several; else empty

  bool operator==(const Reservation&) const = default;
};

/// "always", "strict" or "never".
const char* severityName(scene::Severity severity);

/// What is known before a frame is run: of the scene, its robots, meshes and recordings.
std::vector<Reservation> reservationsOf(const session::Session& session);

/// Of a run that was interrupted when `done` of `all` frames were run, the last one at `last` (s; nothing:
/// none was).
Reservation interruptedReservation(std::size_t done, std::size_t all, std::optional<double> last);

/// Appends those of `more` that are not among `all` yet.
void addReservations(std::vector<Reservation>& all, const std::vector<Reservation>& more);

/// Whether one of them fails the check.
bool failing(const Reservation& reservation, bool strict);

}  // namespace abstand::run
