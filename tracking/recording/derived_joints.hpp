// Canonical joints that a file does not name but that follow from others.
#pragma once

#include <string>
#include <vector>

#include "humanmodel/joints.hpp"
#include "tracking/recording/joint_map.hpp"

namespace abstand::tracking {

/// Fills joints of the frames, and of `rest` by the same rules, in any axes and units:
///  - pelvis: middle of the hips; thorax and neck: middle of the shoulders; spine: middle of pelvis and
///  thorax;
///  - head_top: where the file's end site lies more than 60 degrees off the line from neck to head in the
///  median
///    frame, it is put onto that line at its own distance from the head (exporters write end sites in stale
///    axes); where there is none, on that line, half the length of the trunk (pelvis to neck) above the neck;
///  - head: files name the joint at the base of the skull; the canonical one is halfway from there to
///  head_top. Where the map says that the file names the middle of the head, it stays, and a head_top that is
///  not there lies 0.065 / 0.288 of the trunk beyond it (half a head, shoulders to hips; ibid.);
///  - hand: on the line from elbow to wrist, 0.108 / 0.146 of the forearm behind the wrist (segment lengths
///  of
///    Drillis and Contini 1966, in Winter 2009, fig. 4.1).
///  - toe: where there is none, or the file's end site goes on in the line of the shin (less than 25 degrees
///  in the
///    median frame: it is the sole, as in Biovision's first example), 0.45 of the calf in front of the ankle
///    and 0.16 below it (0.039 / 0.246, ibid.), forward being square to the calf and to the line of the hips.
/// Joints made so are kInferred. Returns a sentence on each thing that was made or moved.
std::vector<std::string> deriveJoints(humanmodel::SkeletonFrame& rest,
                                      std::vector<humanmodel::SkeletonFrame>& frames,
                                      HeadPoint head = HeadPoint::kBase);

/// Evenly spaced indices below `count`, at most `most` of them, for estimates over a whole recording.
std::vector<std::size_t> sampleIndices(std::size_t count, std::size_t most = 200);

}  // namespace abstand::tracking
