#include "tracking/depth/calibration/surface_rows.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

constexpr double kSmallestScale = 5e-4;  // m, of the weights
constexpr double kDamping = 1e-6;        // share of the sum of weights

}  // namespace

SurfaceSum sumOf(const std::vector<SurfaceRow>& rows) {
  SurfaceSum sum;
  if (rows.empty()) return sum;
  std::vector<double> sizes;
  for (const SurfaceRow& row : rows) {
    sum.middle += row.p_W;
    sizes.push_back(std::abs(row.distance));
  }
  sum.rows = rows.size();
  sum.middle /= static_cast<double>(rows.size());
  const auto median = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), median, sizes.end());
  const double width = sum.width = 3.0 * std::max(kSmallestScale, 1.4826 * *median);
  for (const SurfaceRow& row : rows) {
    Vector6d J;
    J << row.n_W, (row.p_W - sum.middle).cross(row.n_W);
    const double part = row.distance / width;
    const double weight = row.weight / ((1.0 + part * part) * (1.0 + part * part));
    sum.weights += weight;
    sum.squares += weight * row.distance * row.distance;
    sum.JTJ += weight * J * J.transpose();
    sum.JTr += weight * row.distance * J;
    const double influence = row.distance * weight / row.weight;
    sum.all_weights += row.weight;
    sum.influence_squares += row.weight * influence * influence;
    sum.influence_slopes += weight * (1.0 - 3.0 * part * part) / (1.0 + part * part);
    sum.all_JTJ += row.weight * J * J.transpose();
  }
  return sum;
}

Matrix6d covarianceOf(const SurfaceSum& sum) {
  const auto rows = static_cast<double>(sum.rows);
  const double slope = sum.influence_slopes / sum.all_weights;
  const Matrix6d inverse = sum.all_JTJ.inverse();
  if (!(rows > 6.0) || !(slope > 0.0) || !inverse.allFinite()) return Matrix6d::Constant(kInfinity);
  const double variance = sum.influence_squares / sum.all_weights * rows / (rows - 6.0);
  return variance / (slope * slope) * inverse;
}

std::optional<Vector6d> stepOf(const SurfaceSum& sum) {
  Matrix6d damped = sum.JTJ;
  damped.diagonal().array() += kDamping * sum.weights;
  const Vector6d step = -damped.ldlt().solve(sum.JTr);
  if (!step.allFinite()) return std::nullopt;
  return step;
}

}  // namespace abstand::tracking
