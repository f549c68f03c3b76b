// Whether markers contradict the stature that their file states.
#pragma once

#include <span>
#include <string>

#include "tracking/markers/marker_solution.hpp"

namespace abstand::tracking {

/// The markers of a file, in metres with z up, and the stature that it states (m).
struct StatedStature {
  const BodyRig& base;
  std::span<const FoundMarker> found;
  std::span<const double> t;
  std::span<const MarkerPlaces> moments;
  double stature{0.0};
};

/// A sentence if the stated stature is wrong. As it is prior knowledge of the fit, the fitted stature follows
/// it and shows nothing. At most 24 moments are fitted with and without it. A doubt needs two estimates that
/// differ from it by more than 7 % to the same side: the stature that is fitted without it, and the one whose
/// usual share thigh and calf are in the fit with it. The first alone may be 11 % off, if clusters of markers
/// hardly determine the bones; the second is drawn towards what is stated. Empty: no doubt, or no markers on
/// thighs and calves.
std::string doubtOfStature(const StatedStature& stated);

}  // namespace abstand::tracking
