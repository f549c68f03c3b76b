// A surface of a segment, for tests.
#pragma once

#include "tracking/tracker/fit_surface.hpp"

namespace abstand::tracking {

/// With three different semi-axes, beside the origin of its segment.
inline FitSurface surfaceOf(bool drum) {
  FitSurface s;
  s.centre = {0.01f, -0.02f, -0.15f};
  s.semi = {0.06f, 0.09f, 0.2f};
  s.drum = drum;
  return s;
}

}  // namespace abstand::tracking
