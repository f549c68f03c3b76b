// Extents and heights of components.
#include "tracking/depth/people/lying_people.hpp"

#include <Eigen/Eigenvalues>

namespace abstand::tracking {
namespace {

using Place = PlanView::Place;

// m. Statures of adults are 1.45 to 2.05; parts may be hidden, and arms stretched beyond the head.
constexpr double kShortestBody = 1.1, kLongestBody = 2.4;
constexpr double kNarrowest = 0.2, kBroadest = 1.0;
// m. A trunk is 0.2 to 0.3 thick; knees may be raised.
constexpr float kLowestTop = 0.15f, kHighestTop = 0.65f;
constexpr double kMinArea = 0.2;      // m^2 of the floor
constexpr float kUnevenBody = 0.02f;  // m, standard deviation of the heights of the cells
constexpr double kOutermost =
    2.0;  // times the standard deviation: half the extent, as of a uniform density 1.7

/// Whether a component may be a person who lies; sets the middle.
bool isBody(const PlanView& plan, std::span<const int> cells, Place& middle) {
  const auto n = static_cast<double>(cells.size());
  if (n * PlanView::kCell * PlanView::kCell < kMinArea) return false;
  middle.setZero();
  float top = 0.0f, sum = 0.0f, squares = 0.0f;
  for (const int i : cells) {
    const float h = plan.cell(i).top;
    top = std::max(top, h);
    sum += h;
    squares += h * h;
    middle += PlanView::placeOf(i);
  }
  if (top < kLowestTop || top > kHighestTop) return false;
  middle /= n;
  const float mean = sum / static_cast<float>(n);
  if (squares / static_cast<float>(n) - mean * mean < kUnevenBody * kUnevenBody) return false;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const int i : cells) {
    const Place off = PlanView::placeOf(i) - middle;
    scatter += off * off.transpose() / n;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(scatter);
  const Place along = axes.eigenvectors().col(1);
  double from = kInfinity, to = -kInfinity;
  for (const int i : cells) {
    const double s = along.dot(PlanView::placeOf(i) - middle);
    from = std::min(from, s);
    to = std::max(to, s);
  }
  const double breadth = 2.0 * kOutermost * std::sqrt(std::max(0.0, axes.eigenvalues()[0]));
  return to - from >= kShortestBody && to - from <= kLongestBody && breadth >= kNarrowest &&
         breadth <= kBroadest;
}

}  // namespace

void LyingPeople::find(const PlanView& plan) {
  found_.start();
  count_ = 0;
  for (std::size_t k = 0; k < plan.components() && !found_.full(); ++k) {
    Place middle;
    if (!isBody(plan, plan.component(k), middle)) continue;
    if (found_.add(middle).images >= kImages) places_[count_++] = middle;
  }
}

}  // namespace abstand::tracking
