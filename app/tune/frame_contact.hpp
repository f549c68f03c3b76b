// Predicted contact of a body part in one frame.
#pragma once

#include <cstdint>

namespace abstand::tune {

/// In place of the index of a region: no contact is predicted.
inline constexpr std::uint16_t kNoRegion = 65535;

/// The hardest contact of a part that could occur in a frame: of its pairs nearer than PassOptions::near that
/// close in, the one with the largest share of a limit. Force and energy are those of the region with the
/// largest share of the force; the pressure is its peak under the surface of the link
/// (contact::predictPressure). The numbers are rounded up (part_tables.hpp).
struct FrameContact {
  std::uint16_t link{0};            ///< index into PassResult::links
  std::uint16_t region{kNoRegion};  ///< index into PassResult::regions
  double force{0.0}, energy{0.0};   ///< N, J
  double pressure{0.0};             ///< Pa, infinite: no contact area is certain; 0: excluded
  /// The larger one of the shares of force and pressure. Infinite where contact is excluded, and for a part
  /// that is not seen, which has no region.
  double share{0.0};
};

}  // namespace abstand::tune
