// Camera pose from the room that a camera with known pose sees, too.
#include "tracking/depth/calibration/room_pose.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "tracking/depth/calibration/refuse.hpp"
#include "tracking/depth/calibration/room_search.hpp"

namespace abstand::tracking {
namespace {

constexpr double kRoomMaxSpread = 0.1;  // m

/// Throws UsageError if the pose is not certain.
void refuseDoubtful(const RoomCandidate& fit) {
  if (fit.points < kRoomMinPoints)
    refuse(
        "--room: found %zu points that both cameras see, expected %zu or more: their views do not overlap, "
        "or "
        "the camera's start is more than 0.2 m or 20 degrees off",
        fit.points, kRoomMinPoints);
  if (!(fit.agreement.agreeing >= kRoomMinAgreeing))
    refuse(
        "--room: found that the cameras agree on %.0f %% of their common view, expected %.0f %% or more: the "
        "room has changed between the recordings, or the camera's start is more than 0.2 m or 20 degrees off",
        100.0 * fit.agreement.agreeing, 100.0 * kRoomMinAgreeing);
  if (!(fit.agreement.weakest >= kRoomMinConstraint))
    throw UsageError(
        "--room: found surfaces that do not determine every degree of freedom of the camera, as a floor and "
        "one "
        "wall do, expected surfaces with three directions in the common view");
  if (!(fit.rms <= kRoomMaxRms))
    refuse(
        "--room: found an RMS distance of %.0f mm between the surfaces of the cameras, expected %.0f or "
        "less: "
        "the intrinsics are wrong, or the room has changed",
        1e3 * fit.rms, 1e3 * kRoomMaxRms);
  if (!(fit.spread <= kRoomMaxSpread))
    refuse(
        "--room: found a position uncertainty of %.0f mm, expected %.0f or less: too few surfaces determine "
        "the camera, add some to the common view",
        1e3 * fit.spread, 1e3 * kRoomMaxSpread);
}

/// Throws UsageError for several poses between which the start does not decide, `d` (m) apart.
[[noreturn]] void refuseRepeated(double d) {
  // Within it no other pose is near enough to the start.
  const double near = std::min(kRoomStartMove, d - kRoomStartMargin * kRoomStartMove);
  if (near > kRoomElsewhere)
    refuse(
        "--room: found poses %.2f m apart that explain the room nearly equally, since parts of it are "
        "repeated, "
        "expected one: add something that is not repeated, or give a start (--camera) within %.2f m and 20 "
        "degrees of the true pose",
        d, near);
  refuse(
      "--room: found poses %.2f m apart that explain the room nearly equally, since parts of it are "
      "repeated, "
      "expected one: add something that is not repeated",
      d);
}

}  // namespace

RoomFit fitPoseToRoom(const RoomView& known, const RoomView& camera) {
  const RoomRows rows(known, camera);
  const Transform& start = camera.camera().X_WC;
  const std::vector<RoomCandidate> candidates = searchRoom(known, camera);
  const RoomChoice choice = chooseRoomPose(candidates, start, camera.middle());
  const RoomCandidate best =
      judgeRoomPose(rows, rows.from(candidates[choice.best].X_WC, RoomRows::kLastGate, RoomRows::kAllPoints));
  refuseDoubtful(best);
  RoomFit fit{.X_WC = best.X_WC, .rms = best.rms, .points = best.points, .agreement = best.agreement};
  if (choice.rival) fit.rival = apart(candidates[*choice.rival].X_WC, fit.X_WC, camera.middle());
  if (!choice.decided) refuseRepeated(fit.rival);
  const Transform moved = start.inverse() * fit.X_WC;
  fit.moved = moved.translation().norm();
  fit.turned = Eigen::AngleAxisd(moved.linear()).angle();
  fit.is_start_near = isNear(start, fit.X_WC, kRoomStartSlack);
  fit.spread = std::hypot(best.spread, known.camera().spread);
  return fit;
}

}  // namespace abstand::tracking
