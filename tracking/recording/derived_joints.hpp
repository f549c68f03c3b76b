// Derives canonical joints that a file does not have.
#pragma once

#include <string>
#include <vector>

#include "humanmodel/joints.hpp"
#include "tracking/recording/joint_map.hpp"

namespace abstand::tracking {

/// Derives joints of the frames, and of `rest` by the same rules, in any axes and units:
///  - pelvis: midpoint of the hips; thorax and neck: midpoint of the shoulders; spine: midpoint of pelvis and
///    thorax.
///  - head_top: if the file's end site is more than 60 degrees off the line from neck to head in the median
///    frame, it is moved onto that line at its own distance from the head (exporters write end sites in old
///    axes). If there is none, it is put on that line, half the length of the trunk (pelvis to neck) above
///    the neck.
///  - head: files name the joint at the base of the skull; the canonical one is halfway from there to
///    head_top. If the map states that the file names the middle of the head, it is kept, and a missing
///    head_top is 0.065 / 0.288 of the trunk beyond it (half a head over shoulders to hips; ibid.).
///  - hand: on the line from elbow to wrist, 0.108 / 0.146 of the forearm beyond the wrist (segment lengths
///    of Drillis and Contini 1966, in Winter 2009, fig. 4.1).
///  - toe: if there is none, or if the file's end site continues the line of the shin (less than 25 degrees
///    in the median frame: it is the sole, as in Biovision's first example), 0.45 of the calf in front of the
///    ankle and 0.16 below it (0.039 / 0.246, ibid.); forward is perpendicular to the calf and the hip line.
/// Derived joints are kInferred. Returns a sentence on each joint that was derived or moved.
std::vector<std::string> deriveJoints(humanmodel::SkeletonFrame& rest,
                                      std::vector<humanmodel::SkeletonFrame>& frames,
                                      HeadPoint head = HeadPoint::kBase);

/// Evenly spaced indices below `count`, at most `max_count`, for estimates over a whole recording.
std::vector<std::size_t> sampleIndices(std::size_t count, std::size_t max_count = 200);

}  // namespace abstand::tracking
