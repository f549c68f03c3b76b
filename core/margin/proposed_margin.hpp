// The smallest safe margin of each body part over stored clearances.
#pragma once

#include <optional>
#include <vector>

#include "core/margin/clearance_store.hpp"
#include "core/margin/safe_margin.hpp"

namespace abstand::margin {

/// Of a part with its nearest link: what `tune` proposes for the same recording.
struct PartProposal {
  std::vector<std::size_t> parts;  ///< of StoreLayout: one of each person
  bool judged{false};  ///< in some frame a margin could have stopped the robot in time; else there is none
  double margin{0.0};  ///< m, rounded up to whole millimetres; infinite: none would do
  /// What decides it; none: no stop was ever needed.
  struct Decision {
    double t{0.0};          ///< s, of the stop command
    std::size_t part{0};    ///< of StoreLayout
    std::uint16_t link{0};  ///< of StoreLayout
    /// m, parts of the margin: the engine's error, what is not known of the pose, and motion in one frame.
    double bound{0.0}, pose{0.0}, sampling{0.0};
  };
  std::optional<Decision> decided_by;
};

/// In the order in which the layout names the kinds of parts.
std::vector<PartProposal> proposeMargins(const ClearanceStore& store, const MarginOptions& options);

}  // namespace abstand::margin
