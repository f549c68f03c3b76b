#include "ui/model/nearest_classes.hpp"

#include <QCoreApplication>
#include <array>
#include <cmath>

#include "ui/style/format.hpp"

namespace abstand::ui {
namespace {

QString trClass(const char* text) { return QCoreApplication::translate("NearestClasses", text); }

/// A body of no person and no mechanism is in this group.
constexpr const char* kThings = "objects";

enum Side { kPerson, kRobot, kThing };

Side sideOf(const view::SceneOutline::ObjectInfo& object) {
  if (object.human) return kPerson;
  return object.group == kThings ? kThing : kRobot;
}

constexpr int kClasses = 4;

/// 0 to 3 in the order of the reports, -1: no class.
int classOf(Side a, Side b) {
  if (b < a) std::swap(a, b);
  if (a == kPerson) return b == kRobot ? 0 : b == kThing ? 1 : -1;
  if (a == kRobot) return b == kRobot ? 2 : 3;
  return -1;
}

QString className(int i) {
  const std::array<QString, kClasses> names{trClass("Person – robot"), trClass("Person – thing"),
                                            trClass("Robot – robot"), trClass("Robot – thing")};
  return names[static_cast<std::size_t>(i)];
}

QString pairText(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot, int pair) {
  const auto i = static_cast<std::size_t>(pair);
  const auto [a, b] = outline.pairs[i];
  return trClass("%1 – %2, %3")
      .arg(QString::fromStdString(outline.objects[static_cast<std::size_t>(a)].name),
           QString::fromStdString(outline.objects[static_cast<std::size_t>(b)].name),
           millimetresWithUnit(snapshot.pairs[i].result.distance));
}

}  // namespace

std::vector<NearestOfClass> nearestOfClasses(const view::SceneOutline& outline,
                                             const view::SceneSnapshot& snapshot) {
  std::array<NearestOfClass, kClasses> least;
  for (int i = 0; i < kClasses; ++i) least[static_cast<std::size_t>(i)] = {className(i), -1, kInfinity};
  for (std::size_t i = 0; i < outline.pairs.size() && i < snapshot.pairs.size(); ++i) {
    const auto [a, b] = outline.pairs[i];
    const int of = classOf(sideOf(outline.objects[static_cast<std::size_t>(a)]),
                           sideOf(outline.objects[static_cast<std::size_t>(b)]));
    const double d = snapshot.pairs[i].result.distance;
    if (of < 0 || !(d < least[static_cast<std::size_t>(of)].distance)) continue;
    least[static_cast<std::size_t>(of)].pair = static_cast<int>(i);
    least[static_cast<std::size_t>(of)].distance = d;
  }
  std::vector<NearestOfClass> found;
  for (const NearestOfClass& of : least)
    if (of.pair >= 0) found.push_back(of);
  return found;
}

double nearestPersonRobot(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  double least = kNaN;
  for (std::size_t i = 0; i < outline.pairs.size() && i < snapshot.pairs.size(); ++i) {
    const auto [a, b] = outline.pairs[i];
    if (classOf(sideOf(outline.objects[static_cast<std::size_t>(a)]),
                sideOf(outline.objects[static_cast<std::size_t>(b)])) == 0)
      least = std::fmin(least, snapshot.pairs[i].result.distance);
  }
  return least;
}

QString nearestText(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  const auto classes = nearestOfClasses(outline, snapshot);
  const int nearest = snapshot.nearest_pair;
  const auto known = [&](int pair) {
    return pair >= 0 && static_cast<std::size_t>(pair) < snapshot.pairs.size() &&
           static_cast<std::size_t>(pair) < outline.pairs.size();
  };
  if (!classes.empty()) {
    QString text =
        classes.front().name + QStringLiteral(": ") + pairText(outline, snapshot, classes.front().pair);
    for (std::size_t i = 1; i < classes.size(); ++i)
      text += QStringLiteral("; ") + classes[i].name.toLower() + QStringLiteral(" ") +
              millimetresWithUnit(classes[i].distance);
    return text;
  }
  return known(nearest) ? trClass("Nearest: %1").arg(pairText(outline, snapshot, nearest)) : QString();
}

QString nearestLines(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  QString text;
  for (const NearestOfClass& of : nearestOfClasses(outline, snapshot))
    text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + of.name + QStringLiteral(": ") +
            pairText(outline, snapshot, of.pair);
  return text;
}

}  // namespace abstand::ui
