// How fast the nearest points of two bodies come together.
#pragma once

#include <utility>

#include "core/view/snapshot.hpp"

namespace abstand::ui {

/// Speeds (m/s) of the nearest points of a pair towards each other: of the first body towards the second, and
/// of the second towards the first.
struct ClosingSpeeds {
  double first{0.0}, second{0.0};
  double sum() const { return first + second; }  ///< negative: they move apart
};

/// `objects`: of the pair. Where the nearest points give no direction, that of the centres of mass.
ClosingSpeeds closingSpeeds(const view::SceneSnapshot& snapshot, const query::PairResult& result,
                            std::pair<int, int> objects);

}  // namespace abstand::ui
