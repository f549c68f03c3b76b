// Distances of pairs of shapes against closed forms.
#pragma once

#include "core/verify/check.hpp"

namespace abstand::verify {

/// |distance - closed form| in voxels, for each kind of field: balls, boxes, capsules, cylinders and eggs at
/// random poses apart from each other and pressed into each other. One result a field.
std::vector<CheckResult> checkClosedForms(const VerifyOptions& options);

}  // namespace abstand::verify
