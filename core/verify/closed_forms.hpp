// Check of distances of pairs of shapes against closed forms.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// |distance - closed form| relative to the tolerance, for each kind of field: balls, boxes, capsules,
/// cylinders and ellipsoids in random poses, separated and overlapping. Tolerance up to four voxels apart
/// (where a mixed field is dense): one voxel with layers, a quarter of one with float distances, plus the
/// covering radius of the shell for bodies with edges; beyond, the pair's own bound. One result for each
/// field.
std::vector<CheckResult> checkClosedForms(const VerifyOptions& options);

}  // namespace abstand::verify
