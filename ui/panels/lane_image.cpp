// Distances over time as rows of pixels.
#include "ui/panels/lane_image.hpp"

#include <algorithm>
#include <cmath>

#include "ui/style/heat.hpp"

namespace abstand::ui {

namespace {

LaneRow emptyRow(std::size_t columns) {
  return {std::vector<QRgb>(columns, 0), std::vector<bool>(columns, true), std::vector<bool>(columns, false),
          std::vector<bool>(columns, false), std::vector<bool>(columns, false)};
}

/// Marks the columns that an event touches: its first one always.
void mark(const RecordingEvent& event, const TimeRange& shown, LaneRow& row) {
  const auto columns = static_cast<int>(row.colour.size());
  if (event.t1 < shown.from || event.t0 > shown.to || columns == 0 || !(shown.length() > 0.0)) return;
  const auto column = [&](double t) {
    return std::clamp(static_cast<int>(std::floor((t - shown.from) / shown.length() * columns)), 0,
                      columns - 1);
  };
  const int first = column(event.t0), last = std::max(first, column(event.t1));
  const auto fill = [&](std::vector<bool>& marks) {
    std::fill(marks.begin() + first, marks.begin() + last + 1, true);
  };
  switch (event.kind) {
    case EventKind::kNear:
      return fill(row.near);
    case EventKind::kBetweenFrames:
      fill(row.touching);
      return fill(row.inside);
    case EventKind::kInside:
      return fill(row.inside);
    case EventKind::kContact:
      return fill(row.touching);
    case EventKind::kStop:
    case EventKind::kLost:
      break;
  }
}

}  // namespace

std::vector<std::size_t> columnFrames(const margin::ClearanceStore& store, const TimeRange& shown,
                                      int columns) {
  if (store.empty()) return std::vector<std::size_t>(static_cast<std::size_t>(columns) + 1, 0);
  std::vector<std::size_t> bounds;
  const double width = shown.length() / columns, last = store.t(store.frames() - 1);
  const double rounding = 1e-9 * (1.0 + std::abs(last));
  for (int x = 0; x <= columns; ++x) {
    const double t = shown.from + x * width;
    // Behind what is there: frames that the store does not have.
    bounds.push_back(t > last + rounding ? store.frames() : store.frameAt(t));
  }
  return bounds;
}

LaneRow laneRow(const RecordingReview& review, std::size_t part, const TimeRange& shown,
                const std::vector<std::size_t>& bounds) {
  if (bounds.empty()) return {};
  LaneRow row = emptyRow(bounds.size() - 1);
  for (std::size_t x = 0; x + 1 < bounds.size(); ++x) {
    const auto look = review.store()->look(part, bounds[x], bounds[x + 1] + 1);
    row.unknown[x] = look.unknown;
    if (std::isfinite(look.least)) row.colour[x] = heat(look.least);
  }
  for (const RecordingEvent& event : review.events())
    if (event.part == static_cast<int>(part)) mark(event, shown, row);
  return row;
}

LaneRow wholeRow(const RecordingReview& review, const TimeRange& shown, int columns) {
  const margin::ClearanceStore* store = review.store();
  LaneRow row = emptyRow(static_cast<std::size_t>(columns));
  if (!store || store->empty()) return row;
  const std::vector<std::size_t> bounds = columnFrames(*store, shown, columns);
  for (std::size_t x = 0; x + 1 < bounds.size(); ++x) {
    double least = kInfinity;
    for (std::size_t part = 0; part < store->layout().parts.size(); ++part)
      least = std::min(least, store->look(part, bounds[x], bounds[x + 1] + 1).least);
    row.unknown[x] = std::isinf(least);
    if (!row.unknown[x]) row.colour[x] = heat(least);
  }
  for (const RecordingEvent& event : review.events()) mark(event, shown, row);
  return row;
}

}  // namespace abstand::ui
