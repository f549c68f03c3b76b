// Helpers of several checks.
#pragma once

#include <memory>
#include <string>

#include "core/query/pair_query.hpp"
#include "core/verify/check.hpp"

namespace abstand::verify {

/// Half of the default; no check depends on the outer layers.
inline constexpr int kOuterLayers = 10;

std::shared_ptr<const structure::HapticStructure> structureOf(const geometry::Shape& shape,
                                                              structure::FieldKind field, double voxel,
                                                              int threads);
std::shared_ptr<const structure::HapticStructure> structureOf(const geometry::TriangleMesh& mesh,
                                                              structure::FieldKind field, double voxel,
                                                              int threads);

query::PairResult query(const structure::HapticStructure& a, const Transform& X_WA,
                        const structure::HapticStructure& b, const Transform& X_WB,
                        const query::PairOptions& options = {});

/// "%.3g".
std::string shortNumber(double value);

/// Sets poses, worst, p50, p99 and breaches from one value for each pose; passed if none exceeds the limit.
/// NaN exceeds any limit.
void judge(CheckResult& result, const std::vector<double>& values, double limit);

}  // namespace abstand::verify
