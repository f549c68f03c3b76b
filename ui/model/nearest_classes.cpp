#include "ui/model/nearest_classes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/safety/clearance_verdict.hpp"
#include "ui/model/pair_level.hpp"
#include "ui/model/pair_sentence.hpp"
#include "ui/style/format.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {
namespace {

constexpr int kClasses = 4;  // without other pairs

PairLevel levelOf(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot, int pair) {
  const auto i = static_cast<std::size_t>(pair);
  return pair >= 0 && i < snapshot.pairs.size() && i < outline.pairs.size() &&
                 snapshot.objects.size() == outline.objects.size()
             ? pairLevel(snapshot, snapshot.pairs[i], outline.pairs[i])
             : PairLevel::kUnknown;
}

/// With the state: "12.3 mm, ⚠ inside margin".
QString stateText(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot, int pair) {
  const auto i = static_cast<std::size_t>(pair);
  const QString distance =
      distanceText(snapshot.pairs[i].result.distance, poseUncertainty(snapshot, outline.pairs[i]));
  const PairLevel level = levelOf(outline, snapshot, pair);
  return level == PairLevel::kUnknown ? distance : tr("%1, %2").arg(distance, levelText(level));
}

QString pairText(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot, int pair) {
  const auto i = static_cast<std::size_t>(pair);
  const auto [a, b] = outline.pairs[i];
  return tr("%1 – %2, %3")
      .arg(QString::fromStdString(outline.objects[static_cast<std::size_t>(a)].name),
           QString::fromStdString(outline.objects[static_cast<std::size_t>(b)].name),
           stateText(outline, snapshot, pair));
}

}  // namespace

std::vector<NearestOfClass> nearestOfClasses(const view::SceneOutline& outline,
                                             const view::SceneSnapshot& snapshot) {
  std::array<NearestOfClass, kClasses> nearest;
  for (int i = 0; i < kClasses; ++i)
    nearest[static_cast<std::size_t>(i)] = {static_cast<PairClass>(i), -1, kInfinity};
  std::array<double, kClasses> clearances;
  clearances.fill(kInfinity);
  if (snapshot.objects.size() != outline.objects.size()) return {};
  for (std::size_t i = 0; i < outline.pairs.size() && i < snapshot.pairs.size(); ++i) {
    const auto of = static_cast<std::size_t>(pairClassOf(outline, outline.pairs[i]));
    const query::PairResult& result = snapshot.pairs[i].result;
    if (of >= kClasses || !(result.distance < kInfinity)) continue;
    const double clearance = safety::certifiedClearance(
        {result.distance, result.bound, poseUncertainty(snapshot, outline.pairs[i])});
    if (std::pair(clearance, result.distance) >= std::pair(clearances[of], nearest[of].distance)) continue;
    clearances[of] = clearance;
    nearest[of].pair = static_cast<int>(i);
    nearest[of].distance = result.distance;
  }
  std::vector<NearestOfClass> found;
  for (const NearestOfClass& of : nearest)
    if (of.pair >= 0) found.push_back(of);
  return found;
}

double clearancePersonRobot(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  double nearest = kNaN;
  for (std::size_t i = 0; i < outline.pairs.size() && i < snapshot.pairs.size(); ++i) {
    if (snapshot.pairs[i].paused || pairClassOf(outline, outline.pairs[i]) != PairClass::kPersonRobot)
      continue;
    const query::PairResult& result = snapshot.pairs[i].result;
    const double unknown = poseUncertainty(snapshot, outline.pairs[i]);
    nearest = std::fmin(nearest, safety::certifiedClearance({result.distance, result.bound, unknown}));
  }
  return nearest;
}

QString nearestText(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  const auto classes = nearestOfClasses(outline, snapshot);
  const int nearest = snapshot.nearest_pair;
  const auto known = [&](int pair) {
    return pair >= 0 && static_cast<std::size_t>(pair) < snapshot.pairs.size() &&
           static_cast<std::size_t>(pair) < outline.pairs.size();
  };
  if (!classes.empty()) {
    QString text = pairClassName(classes.front().of) + QStringLiteral(": ") +
                   pairText(outline, snapshot, classes.front().pair);
    for (std::size_t i = 1; i < classes.size(); ++i)
      text += QStringLiteral("; ") + pairClassInSentence(classes[i].of) + QStringLiteral(" ") +
              stateText(outline, snapshot, classes[i].pair);
    return text;
  }
  return known(nearest) ? tr("Nearest: %1").arg(pairText(outline, snapshot, nearest)) : QString();
}

PairLevel nearestLevel(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  const auto classes = nearestOfClasses(outline, snapshot);
  if (classes.empty()) return levelOf(outline, snapshot, snapshot.nearest_pair);
  PairLevel worst = PairLevel::kUnknown;
  for (const NearestOfClass& of : classes) worst = std::max(worst, levelOf(outline, snapshot, of.pair));
  return worst;
}

QString nearestLines(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  QString text;
  for (const NearestOfClass& of : nearestOfClasses(outline, snapshot))
    text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + pairClassName(of.of) +
            QStringLiteral(": ") + pairText(outline, snapshot, of.pair);
  return text;
}

}  // namespace abstand::ui
