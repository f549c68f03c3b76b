// Plan view: surfaces above the floor, seen from above.
#include "tracking/depth/people/plan_view.hpp"

namespace abstand::tracking {
namespace {

constexpr int kGap = 2;  // cells that a component may skip

}  // namespace

PlanView::PlanView() : cells_(static_cast<std::size_t>(kColumns) * kRows) {
  // Upper bound of the size, so that nothing is allocated later.
  used_.reserve(cells_.size());
  joined_.reserve(cells_.size());
  starts_.reserve(cells_.size() + 1);
}

void PlanView::clear() {
  for (const int i : used_) cell(i) = {};
  used_.clear();
  joined_.clear();
  starts_.assign(1, 0);
}

void PlanView::join() {
  for (const int first : used_) {
    if (!occupied(first) || cell(first).component >= 0) continue;
    const auto number = static_cast<int>(starts_.size()) - 1;
    cell(first).component = number;
    joined_.push_back(first);
    // The cells already connected to this component are the queue.
    for (std::size_t next = starts_.back(); next < joined_.size(); ++next) {
      const int row = joined_[next] / kColumns, column = joined_[next] % kColumns;
      for (int r = std::max(0, row - kGap); r <= std::min(kRows - 1, row + kGap); ++r)
        for (int c = std::max(0, column - kGap); c <= std::min(kColumns - 1, column + kGap); ++c) {
          const int i = r * kColumns + c;
          if (!occupied(i) || cell(i).component >= 0) continue;
          cell(i).component = number;
          joined_.push_back(i);
        }
    }
    starts_.push_back(joined_.size());
  }
}

}  // namespace abstand::tracking
