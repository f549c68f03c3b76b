// Reservations about a verdict, part of every output of `run` and `check`.
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
  /// frames that were run); frames_missing, gaps, unmapped_part, units_guess, up_guess, repair_guess, floor,
  /// recording (of recordings); no_body, missing_body, bodiless, link_center, mesh, no_limits, joint_limit
  /// (of robots and bodies); no_pairs.
  std::string kind;
  std::string text;              ///< one line
  std::optional<double> t0, t1;  ///< s, if it applies to a time range only
  std::optional<double> share;   ///< of the frames, 0 to 1
  scene::Severity fails{scene::Severity::kStrict};
  std::string recording;  ///< for `check` over several recordings; otherwise empty

  bool operator==(const Reservation&) const = default;
};

/// "always", "strict" or "never".
const char* severityName(scene::Severity severity);

/// Reservations known before a frame is run: of the scene, its robots, meshes and recordings.
std::vector<Reservation> reservationsOf(const session::Session& session);

/// Reservation about a run interrupted after `done` of `all` frames, the last one at `last` (s; nullopt: none
/// was run).
Reservation interruptedReservation(std::size_t done, std::size_t all, std::optional<double> last);

/// Appends those of `more` that are not in `all` yet.
void addReservations(std::vector<Reservation>& all, const std::vector<Reservation>& more);

/// True if the reservation fails the check.
bool failing(const Reservation& reservation, bool strict);

}  // namespace abstand::run
