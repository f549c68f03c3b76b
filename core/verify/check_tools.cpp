// Helpers of several checks.
#include "core/verify/check_tools.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/math/quantile.hpp"

namespace abstand::verify {
namespace {

std::shared_ptr<const structure::HapticStructure> build(std::shared_ptr<const geometry::Surface> surface,
                                                        structure::FieldKind field, double voxel,
                                                        int threads) {
  const structure::HapticOptions options{
      .voxel_size = voxel, .point_spacing = voxel, .outer_layers = kOuterLayers, .field = field};
  return structure::buildHapticStructure("body", std::move(surface), options, threads);
}

}  // namespace

std::shared_ptr<const structure::HapticStructure> structureOf(const geometry::Shape& shape,
                                                              structure::FieldKind field, double voxel,
                                                              int threads) {
  return build(geometry::makeSurface(shape), field, voxel, threads);
}

std::shared_ptr<const structure::HapticStructure> structureOf(const geometry::TriangleMesh& mesh,
                                                              structure::FieldKind field, double voxel,
                                                              int threads) {
  return build(geometry::makeSurface(mesh), field, voxel, threads);
}

query::PairResult query(const structure::HapticStructure& a, const Transform& X_WA,
                        const structure::HapticStructure& b, const Transform& X_WB,
                        const query::PairOptions& options) {
  kernels::PairScratch scratch;
  query::PairResult result;
  query::queryPair({a, X_WA}, {b, X_WB}, options, scratch, result);
  return result;
}

std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

void judge(CheckResult& result, const std::vector<double>& values, double limit) {
  result.limit = limit;
  result.poses = values.size();
  // The negated form treats NaN as a breach.
  result.breaches =
      static_cast<std::size_t>(std::ranges::count_if(values, [limit](double v) { return !(v <= limit); }));
  std::vector<double> sound = values;
  std::erase_if(sound, [](double v) { return std::isnan(v); });
  result.p50 = lowerQuantile(sound, 0.5);
  result.p99 = lowerQuantile(sound, 0.99);
  result.worst = lowerQuantile(sound, 1.0);
  result.passed = !values.empty() && result.breaches == 0;
}

}  // namespace abstand::verify
