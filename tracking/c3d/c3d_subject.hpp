// What a C3D file says of its people.
#pragma once

#include "tracking/c3d/c3d_parameters.hpp"
#include "tracking/recording/subject_facts.hpp"

namespace abstand::tracking {

/// From SUBJECTS:NAMES and LABEL_PREFIXES, or SUBJECT:NAME; HEIGHT and WEIGHT of SUBJECT or SUBJECTS; HEIGHT,
/// BODYMASS and the joint widths, leg lengths and offsets of PROCESSING, as Vicon writes them. Of parameters
/// with several values, the first belongs to the first subject, and so on. Empty: nothing is stated. The file
/// does not state their units: a stature is taken as m, cm, mm or inches, whichever gives 1.2 to 2.3 m, and
/// each size as mm, cm or m (or in the unit of the stature), whichever gives that of a person. A stature in
/// inches is noted, one that no unit makes plausible is ignored with a warning. Other implausible values
/// (mass beyond 10 to 300 kg, sizes) are not stated.
std::vector<StatedSubject> subjectsOf(const C3dParameters& parameters);

}  // namespace abstand::tracking
