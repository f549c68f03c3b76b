// Surface by height, cell by cell.
#include "tracking/depth/people/pillars.hpp"

namespace abstand::tracking {

double sheerShare(const PlanView& plan, std::span<const int> component) {
  constexpr std::size_t kFirst = 1, kFewest = 3;  // slabs
  constexpr float kTop = 0.12f;                   // m, below the highest cell
  float top = 0.0f;
  for (const int i : component)
    if (!plan.cell(i).side) top = std::max(top, plan.cell(i).top);
  const auto end = static_cast<std::size_t>(static_cast<double>(top) / PlanView::kSlab);  // of whole slabs
  if (end < kFirst + kFewest) return 0.0;
  float whole = 0.0f, equal = 0.0f;
  for (const int i : component) {
    if (plan.cell(i).side) continue;
    const std::array<float, PlanView::kSlabs>& area = plan.cell(i).area;
    float mean = 0.0f;
    for (std::size_t slab = kFirst; slab < end; ++slab) mean += area[slab];
    whole += mean;
    if (plan.cell(i).top < top - kTop) continue;
    mean /= static_cast<float>(end - kFirst);
    for (std::size_t slab = kFirst; slab < end; ++slab) equal += std::min(mean, area[slab]);
  }
  return whole > 0.0f ? static_cast<double>(equal / whole) : 0.0;
}

}  // namespace abstand::tracking
