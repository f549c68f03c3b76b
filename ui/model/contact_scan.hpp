// Touches and lost tracking in stored clearances, whatever the margins.
#pragma once

#include <vector>

#include "core/margin/clearance_store.hpp"
#include "ui/model/recording_event.hpp"

namespace abstand::ui {

/// Looks at each chunk once. A part touches where its distance to the nearest link is within the error bound
/// of the distance, at the poses as they are known; rounding of the store counts as touching. GUI thread
/// only.
class ContactScan {
 public:
  void clear();
  /// Takes over what is new. The store is always the same one and only grows.
  void update(const margin::ClearanceStore& store);
  /// Appends the events, those that are not over yet up to the last frame. Parts of one person that are lost
  /// in the same frames are one event.
  void append(const margin::ClearanceStore& store, std::vector<RecordingEvent>& events) const;

 private:
  struct Stretch {
    std::size_t begin{0}, end{0};  ///< frames, `end` the first one after it
    std::size_t nearest{0};        ///< the frame with the least clearance
    double least{kInfinity};       ///< m, its clearance
  };
  struct Part {
    std::vector<Stretch> contacts, losses;
  };
  static void extend(std::vector<Stretch>& stretches, std::size_t frame, double clearance);

  std::vector<Part> parts_;
  std::size_t chunks_{0}, frames_{0};
};

}  // namespace abstand::ui
