// A whole recording of markers, solved: a body, and its joint centres frame by frame.
#pragma once

#include <span>
#include <vector>

#include "tracking/markers/marker_calibration.hpp"
#include "tracking/recording/marker_report.hpp"

namespace abstand::tracking {

struct MarkerSolution {
  std::vector<humanmodel::SkeletonFrame>
      frames;  ///< joint centres of the solved body, a frame for each moment
  MarkerBody body;
  MarkerReport report;  ///< all but `set` and `reason`
};

/// Calibrates on at most 60 moments with most markers, taken evenly, then solves every one from the one
/// before, and after a loss anew. A joint is tracked where its standard deviation, from the markers that were
/// seen, is below 30 mm, inferred below 120 mm, missing above and on segments that no marker shows; the chest
/// alone goes on from the pelvis, inferred. `t` (s) rises; `moments` in world axes, m.
MarkerSolution solveMarkers(const BodyRig& base, std::span<const FoundMarker> found,
                            std::span<const double> t, std::span<const MarkerPlaces> moments);

}  // namespace abstand::tracking
