#include "ui/model/inspected_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

/// As PairLevel, but a pair without a result weighs more than one that is near.
int weightOf(PairLevel level) {
  return level == PairLevel::kUnknown ? 2 * static_cast<int>(PairLevel::kNear) + 1
                                      : 2 * static_cast<int>(level);
}

}  // namespace

InspectedPairs inspectPairs(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot,
                            const std::vector<int>& objects) {
  InspectedPairs found;
  const auto chosen = [&](int object) { return std::binary_search(objects.begin(), objects.end(), object); };
  const auto nearer = [&](std::size_t pair, int than) {
    const double d = snapshot.pairs[pair].result.distance;
    return !std::isnan(d) && (than < 0 || d < snapshot.pairs[static_cast<std::size_t>(than)].result.distance);
  };
  int heaviest = -1;
  for (std::size_t p = 0; p < std::min(outline.pairs.size(), snapshot.pairs.size()); ++p) {
    const auto [a, b] = outline.pairs[p];
    const bool of_a = chosen(a), of_b = chosen(b);
    if (!of_a && !of_b) continue;
    ++found.pairs;
    const PairLevel level = pairLevel(snapshot, snapshot.pairs[p], outline.pairs[p]);
    if (weightOf(level) > heaviest) {
      heaviest = weightOf(level);
      found.level = level;
      found.heaviest = static_cast<int>(p);
    }
    if (snapshot.pairs[p].paused) {
      ++found.paused;
      continue;
    }
    if (of_a && of_b) continue;
    const bool person = outline.objects[static_cast<std::size_t>(of_a ? b : a)].human;
    int& nearest = person ? found.nearest_person : found.nearest_other;
    if (nearer(p, nearest)) nearest = static_cast<int>(p);
  }
  for (const view::UncheckedPair& pair : outline.unchecked)
    if (chosen(pair.a) || chosen(pair.b)) ++found.never[static_cast<std::size_t>(pair.reason)];
  return found;
}

QString uncheckedReasonText(view::UncheckedReason reason) {
  switch (reason) {
    case view::UncheckedReason::kAdjacent:
      return tr("adjacent");
    case view::UncheckedReason::kOnePerson:
      return tr("within the person");
    case view::UncheckedReason::kOneGroup:
      return tr("within the robot or the room");
    case view::UncheckedReason::kListed:
      return tr("dropped by a file");
    case view::UncheckedReason::kExcluded:
      return tr("excluded by the scene");
  }
  return {};
}

std::vector<std::pair<QString, std::size_t>> uncheckedReasons(const InspectedPairs& pairs) {
  std::vector<std::pair<QString, std::size_t>> reasons;
  if (pairs.paused > 0) reasons.emplace_back(tr("paused"), pairs.paused);
  for (std::size_t r = 0; r < pairs.never.size(); ++r)
    if (pairs.never[r] > 0)
      reasons.emplace_back(uncheckedReasonText(static_cast<view::UncheckedReason>(r)), pairs.never[r]);
  return reasons;
}

QString uncheckedText(const InspectedPairs& pairs) {
  const std::size_t never =
      std::accumulate(pairs.never.begin(), pairs.never.end(), static_cast<std::size_t>(0));
  if (pairs.paused + never == 0) return tr("none: all its pairs are checked");
  return tr("%1 of %2 pairs").arg(pairs.paused + never).arg(pairs.pairs + never);
}

}  // namespace abstand::ui
