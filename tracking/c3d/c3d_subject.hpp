// What a C3D file says of the person.
#pragma once

#include "tracking/c3d/c3d_parameters.hpp"
#include "tracking/recording/subject_facts.hpp"

namespace abstand::tracking {

/// From SUBJECTS:NAMES or SUBJECT:NAME; HEIGHT and WEIGHT of SUBJECT; HEIGHT, BODYMASS and the joint widths,
/// leg lengths and offsets of PROCESSING, as Vicon writes them. The file does not state their units: a
/// stature is taken as mm, cm or m, whichever gives 0.5 to 2.5 m, and PROCESSING's sizes have the unit of its
/// stature, mm without one. Implausible values (mass beyond 10 to 300 kg, sizes beyond 5 mm to 1.5 m) are not
/// stated.
SubjectFacts subjectOf(const C3dParameters& parameters);

}  // namespace abstand::tracking
