// Since when each pair is in its state.
#pragma once

#include <vector>

#include "ui/model/pair_level.hpp"

namespace abstand::ui {

/// Follows the moments that are shown. After a jump in time nothing is known of what was before. GUI thread
/// only.
class LevelTimes {
 public:
  struct Since {
    double t{kNaN};     ///< s; NaN: no moment was seen
    bool exact{false};  ///< it began then; else then or earlier
  };
  void clear();
  void add(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot);
  Since of(int pair) const;

 private:
  struct Entry {
    PairLevel level{PairLevel::kUnknown};
    Since since;
  };
  std::vector<Entry> entries_;  // by pair
  double last_{kNaN};           // s, the moment before
};

}  // namespace abstand::ui
