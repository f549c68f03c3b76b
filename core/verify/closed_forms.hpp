// Distances of pairs of shapes against closed forms.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// |distance - closed form| over what is allowed, for each kind of field: balls, boxes, capsules, cylinders
/// and eggs at random poses apart from each other and pressed into each other. Allowed is, up to four voxels
/// apart (where a mixed field is dense), a voxel with layers and a quarter of one with float distances, and
/// the covering radius of the shell for bodies with edges; beyond, the pair's own bound. One result a field.
std::vector<CheckResult> checkClosedForms(const VerifyOptions& options);

}  // namespace abstand::verify
