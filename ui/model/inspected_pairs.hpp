// The pairs of some bodies at one moment.
#pragma once

#include <QString>
#include <array>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/model/pair_level.hpp"

namespace abstand::ui {

/// Indices are those of SceneOutline::pairs; -1: none.
struct InspectedPairs {
  /// The heaviest level of all of them; a pair without a result weighs more than one that is near, and what
  /// is not checked more than what is lost, so that neither passes for clear.
  PairLevel level{PairLevel::kUnknown};
  int heaviest{-1};        ///< the first pair of this level
  int nearest_person{-1};  ///< nearest that is checked, with a body part of a person on the other side
  int nearest_other{-1};   ///< likewise, without a person on the other side
  std::size_t pairs{0};    ///< of these bodies, with each other, too
  std::size_t paused{0};   ///< of these, not checked now
  /// Not in SceneOutline::pairs at all, by view::UncheckedReason.
  std::array<std::size_t, 5> never{};
};

/// @param objects  in order
InspectedPairs inspectPairs(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot,
                            const std::vector<int>& objects);

/// "12 of 40 pairs"; "none" where all are checked.
QString uncheckedText(const InspectedPairs& pairs);
/// Why they are not, with the number of pairs; reasons without any are left out.
std::vector<std::pair<QString, std::size_t>> uncheckedReasons(const InspectedPairs& pairs);
/// Why a pair is never checked.
QString uncheckedReasonText(view::UncheckedReason reason);

}  // namespace abstand::ui
