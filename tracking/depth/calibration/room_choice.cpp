// Choice among poses of a camera that explain the room that two cameras see.
#include "tracking/depth/calibration/room_choice.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::tracking {
namespace {

constexpr double kRoomSame = 0.002;  // unexplained, by points at edges

bool isBetter(const RoomCandidate& a, const RoomCandidate& b) {
  if (isAcceptable(a) != isAcceptable(b)) return isAcceptable(a);
  const double more = unexplained(a.agreement) - unexplained(b.agreement);
  if (isAcceptable(a) && std::abs(more) > kRoomSame) return more < 0.0;
  return a.cost < b.cost;
}

/// Whether a pose explains the room nearly as well as the best one, elsewhere.
bool isRival(const RoomCandidate& a, const RoomCandidate& best, const Vector3d& middle_C) {
  const double spread = std::max(a.spread, best.spread);
  return isAcceptable(a) && unexplained(a.agreement) <= unexplained(best.agreement) + kRoomNearlyAsWell &&
         a.agreement.weakest >= kRoomWeakerRival * best.agreement.weakest &&
         apart(a.X_WC, best.X_WC, middle_C) > std::max(kRoomElsewhere, kRoomElsewhereSpreads * spread);
}

}  // namespace

bool isNear(const Transform& start, const Transform& X_WC, double share) {
  const Transform moved = start.inverse() * X_WC;
  return moved.translation().norm() <= share * kRoomStartMove &&
         Eigen::AngleAxisd(moved.linear()).angle() <= share * kRoomStartTurn;
}

double unexplained(const RoomAgreement& agreement) {
  return 1.0 - agreement.agreeing + kRoomPastCounts * agreement.seen_through;
}

double apart(const Transform& a, const Transform& b, const Vector3d& middle_C) {
  return std::max((a.translation() - b.translation()).norm(), (a * middle_C - b * middle_C).norm());
}

RoomChoice chooseRoomPose(const std::vector<RoomCandidate>& candidates, const Transform& start,
                          const Vector3d& middle_C) {
  ABSTAND_CHECK(!candidates.empty());
  RoomChoice choice;
  for (std::size_t i = 1; i < candidates.size(); ++i)
    if (isBetter(candidates[i], candidates[choice.best])) choice.best = i;
  const RoomCandidate& best = candidates[choice.best];
  if (!isAcceptable(best)) return choice;
  std::vector<std::size_t> likely{choice.best}, near;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (isRival(candidates[i], best, middle_C)) likely.push_back(i);
  if (likely.size() == 1) return choice;
  for (const std::size_t i : likely)
    if (isNear(start, candidates[i].X_WC, kRoomStartMargin)) near.push_back(i);
  choice.decided = near.size() == 1 && isNear(start, candidates[near[0]].X_WC, kRoomStartSlack) &&
                   unexplained(candidates[near[0]].agreement) <= unexplained(best.agreement) + kRoomAsWell;
  if (choice.decided) choice.best = near[0];
  double nearest = kInfinity;
  for (const std::size_t i : likely) {
    const double d = apart(candidates[i].X_WC, candidates[choice.best].X_WC, middle_C);
    if (i == choice.best || !(d < nearest)) continue;
    nearest = d;
    choice.rival = i;
  }
  return choice;
}

}  // namespace abstand::tracking
