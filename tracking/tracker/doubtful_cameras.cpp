#include "tracking/tracker/doubtful_cameras.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "humanmodel/joint_covariance.hpp"

namespace abstand::tracking {
namespace {

using humanmodel::SkeletonFrame;

/// The last frame until `t`, or the first one.
const SkeletonFrame& lastFrameUntil(std::span<const SkeletonFrame> frames, double t) {
  const auto after = std::upper_bound(frames.begin(), frames.end(), t,
                                      [](double time, const SkeletonFrame& frame) { return time < frame.t; });
  return after == frames.begin() ? frames.front() : *std::prev(after);
}

/// m, that a joint is from its places `late` (s) before and after.
double movedIn(double late, std::span<const SkeletonFrame> frames, const SkeletonFrame& frame,
               std::size_t joint) {
  double moved = 0.0;
  for (const double t : {frame.t - late, frame.t + late}) {
    const SkeletonFrame& other = lastFrameUntil(frames, t);
    if (other.has(static_cast<humanmodel::Joint>(joint)))
      moved = std::max(moved, (other.p[joint] - frame.p[joint]).norm());
  }
  return moved;
}

void stateFault(const CameraFault& fault, double begin, CameraShare& share) {
  const double since = std::max(fault.since, begin);
  switch (fault.kind) {
    case CameraFault::Kind::kMoved:
      share.moved_at = std::min(share.moved_at, since);
      break;
    case CameraFault::Kind::kHangs:
      share.hung_at = std::min(share.hung_at, since);
      break;
    case CameraFault::Kind::kApart:
      share.apart_since = std::min(share.apart_since, since);
      share.apart = std::max(share.apart, fault.apart);
      share.apart_certain = share.apart_certain && fault.certain;
      break;
    case CameraFault::Kind::kLate:
      share.late_since = std::min(share.late_since, since);
      if (std::abs(fault.late) > std::abs(share.late)) share.late = fault.late;
      break;
  }
}

}  // namespace

void stateFaults(std::span<const CameraFault> faults, double begin, std::span<CameraShare> shares) {
  for (const CameraFault& fault : faults) stateFault(fault, begin, shares[fault.camera]);
}

void widenByFaults(std::span<const CameraFault> faults, ClipTrack& track) {
  for (ClipPerson& person : track.people)
    for (SkeletonFrame& frame : person.frames) {
      const double doubt = doubtAt(faults, frame.t), late = lateAt(faults, frame.t);
      if (doubt <= 0.0 && late <= 0.0) continue;
      for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
        const auto joint = static_cast<humanmodel::Joint>(j);
        const double moved = late > 0.0 ? movedIn(late, person.frames, frame, j) : 0.0;
        if (frame.has(joint)) humanmodel::addRadius(frame, joint, doubt + moved);
      }
    }
  stateFaults(faults, track.begin, track.cameras);
}

std::string apartReason(const CameraShare& share) {
  char text[240];
  std::snprintf(text, sizeof text,
                "disagrees with the others by %.2f m since %.2f s: it was pushed, or its pose is wrong; "
                "its images are not used then%s",
                share.apart, share.apart_since,
                share.apart_certain ? ""
                                    : ", and all joints are uncertain by this distance, as another "
                                      "camera may be the wrong one");
  return text;
}

std::string lateReason(const CameraShare& share) {
  char text[160];
  std::snprintf(text, sizeof text,
                "is %.2f s %s since %.2f s: all joints are uncertain by what they move in that time",
                std::abs(share.late), share.late > 0.0 ? "late" : "early", share.late_since);
  return text;
}

}  // namespace abstand::tracking
