// Distances over time as rows of pixels.
#pragma once

#include <QColor>
#include <vector>

#include "ui/model/recording_review.hpp"
#include "ui/model/time_axis.hpp"

namespace abstand::ui {

/// A row of columns, left to right. Costs no more than its columns, however long the recording is.
struct LaneRow {
  std::vector<QRgb> colour;   ///< heat() of the least known clearance
  std::vector<bool> unknown;  ///< in some frame of the column it is not known; `colour` says nothing there
  /// Of the events; what touches between two frames is both inside and touching.
  std::vector<bool> near, inside, touching;
};

/// The frames of each column of `shown`: from bounds[x] to bounds[x + 1], both included. A frame lasts until
/// the next one; number frames() stands for all that are not there yet.
std::vector<std::size_t> columnFrames(const margin::ClearanceStore& store, const TimeRange& shown,
                                      int columns);

/// The lane of a part. `bounds`: of columnFrames().
LaneRow laneRow(const RecordingReview& review, std::size_t part, const TimeRange& shown,
                const std::vector<std::size_t>& bounds);

/// All parts in one row: the least of what is known, `unknown` only where nothing is.
LaneRow wholeRow(const RecordingReview& review, const TimeRange& shown, int columns);

}  // namespace abstand::ui
