// Solves a whole marker recording: a body, and its joint centres in every frame.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tracking/markers/marker_calibration.hpp"
#include "tracking/recording/marker_report.hpp"

namespace abstand::tracking {

struct MarkerSolution {
  std::vector<humanmodel::SkeletonFrame>
      frames;  ///< joint centres of the solved body, one frame for each moment
  MarkerBody body;
  MarkerReport report;  ///< without `set` and `reason`
};

/// Calibrates on at most 60 evenly spaced moments with most markers, then solves each moment starting from
/// the previous one, or by a search after a loss. A joint is tracked if its standard deviation, from the
/// visible markers, is below 30 mm, inferred below 120 mm, missing above and on segments without markers;
/// only the chest is extrapolated from the pelvis, as inferred. `t` (s) increases; `moments` in world axes,
/// m; `stature` (m), if known, is nearly kept. Moments without any marker are not lost but unseen.
MarkerSolution solveMarkers(const BodyRig& base, std::span<const FoundMarker> found,
                            std::span<const double> t, std::span<const MarkerPlaces> moments,
                            std::optional<double> stature = std::nullopt);

}  // namespace abstand::tracking
