// The selection by names, so that it outlives a session.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/model/selection.hpp"

namespace abstand::ui {

/// Takes a selection's names while its session is open, and selects what the next one has of them.
class KeptSelection {
 public:
  void keep(const Selection& selection, const view::SceneOutline& outline);
  /// Selects nothing where no name is known.
  void restore(Selection& selection, const view::SceneOutline& outline) const;
  void clear();

 private:
  std::vector<std::string> objects_;
  std::pair<std::string, std::string> pair_;  // empty names: no pair
};

}  // namespace abstand::ui
