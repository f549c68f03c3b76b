#include "tracking/tracker/pose_from_person.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/error.hpp"
#include "core/math/quantile.hpp"
#include "tracking/depth/calibration/pose_from_points.hpp"
#include "tracking/tracker/clock_offset.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace {

using humanmodel::Joint;
using humanmodel::SkeletonFrame;

constexpr std::size_t kSearchImages = 90;  // evenly spread, for the search over clocks
constexpr double kMinMatched = 1.0;        // s
constexpr double kOutlying = 3.0;          // medians
constexpr int kRounds = 5;
// m, RMS distance of the joints, of one person in both recordings: fits had 0.025 to 0.060, and two movements
// that were fitted to each other 0.131. The second holds where the clock is not determined: any time of two
// recordings of people who hardly move may look alike.
constexpr double kAgree = 0.090, kAgreeAtUnknownClock = 0.070;

/// Recordings have these elsewhere.
bool isMatched(std::size_t j) {
  return j != static_cast<std::size_t>(Joint::kSpine) && j != static_cast<std::size_t>(Joint::kThorax);
}

double stepOf(std::span<const SkeletonFrame> frames) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < frames.size(); ++i) steps.push_back(frames[i].t - frames[i - 1].t);
  return std::max(nearestQuantile(steps, 0.5), 1e-3);
}

/// Joints tracked in both at the same time; in the camera's frame, and in the world. `images`: largest number
/// of frames of `world` used.
std::vector<MatchedPoint> matchAt(std::span<const SkeletonFrame> world, std::span<const SkeletonFrame> own,
                                  double clock, std::size_t images) {
  std::vector<MatchedPoint> points;
  const double near = 0.6 * stepOf(own);
  const std::size_t stride = std::max<std::size_t>(1, world.size() / images);
  for (std::size_t i = 0; i < world.size(); i += stride) {
    const double t = world[i].t - clock;
    const auto at = std::lower_bound(own.begin(), own.end(), t,
                                     [](const SkeletonFrame& frame, double time) { return frame.t < time; });
    const SkeletonFrame* frame = at != own.end() ? &*at : &own.back();
    if (at != own.begin() && std::abs(std::prev(at)->t - t) < std::abs(frame->t - t)) frame = &*std::prev(at);
    if (std::abs(frame->t - t) > near) continue;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      if (isMatched(j) && world[i].state[j] == humanmodel::JointState::kTracked &&
          frame->state[j] == humanmodel::JointState::kTracked)
        points.push_back({frame->p[j], world[i].p[j]});
  }
  return points;
}

std::vector<SkeletonFrame> moved(const Transform& X, std::span<const SkeletonFrame> frames) {
  std::vector<SkeletonFrame> out(frames.begin(), frames.end());
  for (SkeletonFrame& frame : out)
    for (Vector3d& p : frame.p) p = X * p;
  return out;
}

struct Alignment {
  PoseFit fit;  ///< from the axes of the camera's frames
  double clock{0.0};
};

/// The clock with the smallest residual.
Alignment align(std::span<const SkeletonFrame> world, std::span<const SkeletonFrame> own) {
  Alignment best;
  best.fit.rms = kInfinity;
  const double step = stepOf(own);
  const auto steps = static_cast<int>(ClockOffset::kFarthest / step);
  const std::size_t enough = std::max<std::size_t>(3, matchAt(world, own, 0.0, kSearchImages).size() / 2);
  for (int k = -steps; k <= steps; ++k) {
    const std::vector<MatchedPoint> points = matchAt(world, own, k * step, kSearchImages);
    if (points.size() < enough) continue;
    const PoseFit fit = fitPose(points);
    if (fit.rms < best.fit.rms) best = {fit, k * step};
  }
  return best;
}

double movedBy(std::span<const SkeletonFrame> frames) {
  double most = 0.0;
  Eigen::AlignedBox2d box;
  for (const SkeletonFrame& frame : frames)
    if (frame.has(Joint::kPelvis)) box.extend(frame[Joint::kPelvis].head<2>());
  if (!box.isEmpty()) most = box.diagonal().norm();
  return most;
}

/// Throws UsageError if joints that are `rms` (m) apart are not those of one person.
void requireOneMotion(double rms, bool clock_known) {
  const double limit = clock_known ? kAgree : kAgreeAtUnknownClock;
  if (rms < limit) return;
  throw UsageError("found joints " + std::to_string(std::lround(1e3 * rms)) + " mm apart (RMS)" +
                   (clock_known ? "" : ", and a clock offset that the motion does not determine") +
                   ", expected one person in both recordings, with the same motion: at most " +
                   std::to_string(std::lround(1e3 * limit)) + " mm");
}

}  // namespace

PersonPoseFit fitPoseToPerson(std::span<const SkeletonFrame> world, std::span<const SkeletonFrame> own,
                              const Transform& X_FC) {
  if (world.size() < 2 || own.size() < 2 || own.back().t - own.front().t < kMinMatched)
    throw UsageError("found less than a second of the person, expected more");
  std::vector<SkeletonFrame> flipped;
  for (const SkeletonFrame& frame : own) flipped.push_back(flippedFacing(frame));
  const Alignment straight = align(world, own), other = align(world, flipped);
  PersonPoseFit out;
  out.exchanged = other.fit.rms < straight.fit.rms;
  const std::span<const SkeletonFrame> mine = out.exchanged ? flipped : own;
  const Alignment& best = out.exchanged ? other : straight;
  if (!std::isfinite(best.fit.rms))
    throw UsageError("found no time at which both recordings show the person, expected some seconds");
  const ClockOffset clock = estimateClockOffset(world, moved(best.fit.X_WC, mine));
  out.clock = clock.decided ? clock.offset : best.clock;
  out.clock_known = clock.decided;

  const std::vector<MatchedPoint> all = matchAt(world, mine, out.clock, world.size());
  PoseFit fit = fitPose(all);
  std::vector<MatchedPoint> used;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> off;
    for (const MatchedPoint& point : all) off.push_back((fit.X_WC * point.p_C - point.p_W).norm());
    const double limit = kOutlying * nearestQuantile(off, 0.5);
    used.clear();
    for (std::size_t i = 0; i < all.size(); ++i)
      if (off[i] <= limit) used.push_back(all[i]);
    fit = fitPose(used);
  }
  requireOneMotion(fit.rms, out.clock_known);
  out.X_WC = fit.X_WC * X_FC;
  out.rms = fit.rms;
  // The errors of a joint are nearly the same in all images: its matches count as one.
  const auto matches = static_cast<double>(used.size()) / static_cast<double>(humanmodel::kJointCount);
  const Vector3d to_camera = out.X_WC.translation() - fit.middle;
  out.spread = std::hypot(fit.sigma, spreadWithin(std::max(1.0, matches) * fit.covariance, to_camera));
  out.joints = all.size();
  out.used = used.size();
  out.moved = movedBy(world);
  return out;
}

}  // namespace abstand::tracking
