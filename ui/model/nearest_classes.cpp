#include "ui/model/nearest_classes.hpp"

#include <array>
#include <cmath>

#include "ui/style/format.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {
namespace {

constexpr int kClasses = 4;  // without other pairs

QString pairText(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot, int pair) {
  const auto i = static_cast<std::size_t>(pair);
  const auto [a, b] = outline.pairs[i];
  return tr("%1 – %2, %3")
      .arg(QString::fromStdString(outline.objects[static_cast<std::size_t>(a)].name),
           QString::fromStdString(outline.objects[static_cast<std::size_t>(b)].name),
           lengthText(snapshot.pairs[i].result.distance));
}

}  // namespace

std::vector<NearestOfClass> nearestOfClasses(const view::SceneOutline& outline,
                                             const view::SceneSnapshot& snapshot) {
  std::array<NearestOfClass, kClasses> nearest;
  for (int i = 0; i < kClasses; ++i)
    nearest[static_cast<std::size_t>(i)] = {static_cast<PairClass>(i), -1, kInfinity};
  for (std::size_t i = 0; i < outline.pairs.size() && i < snapshot.pairs.size(); ++i) {
    const auto of = static_cast<int>(pairClassOf(outline, outline.pairs[i]));
    const double d = snapshot.pairs[i].result.distance;
    if (of >= kClasses || !(d < nearest[static_cast<std::size_t>(of)].distance)) continue;
    nearest[static_cast<std::size_t>(of)].pair = static_cast<int>(i);
    nearest[static_cast<std::size_t>(of)].distance = d;
  }
  std::vector<NearestOfClass> found;
  for (const NearestOfClass& of : nearest)
    if (of.pair >= 0) found.push_back(of);
  return found;
}

double nearestPersonRobot(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  double nearest = kNaN;
  for (std::size_t i = 0; i < outline.pairs.size() && i < snapshot.pairs.size(); ++i) {
    if (pairClassOf(outline, outline.pairs[i]) == PairClass::kPersonRobot)
      nearest = std::fmin(nearest, snapshot.pairs[i].result.distance);
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
              lengthText(classes[i].distance);
    return text;
  }
  return known(nearest) ? tr("Nearest: %1").arg(pairText(outline, snapshot, nearest)) : QString();
}

QString nearestLines(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  QString text;
  for (const NearestOfClass& of : nearestOfClasses(outline, snapshot))
    text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + pairClassName(of.of) +
            QStringLiteral(": ") + pairText(outline, snapshot, of.pair);
  return text;
}

}  // namespace abstand::ui
