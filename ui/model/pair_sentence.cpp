#include "ui/model/pair_sentence.hpp"

#include <cmath>

#include "ui/model/closing_speed.hpp"
#include "ui/style/format.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

constexpr double kStill = 0.005;  // m/s; less is shown as 0.00 or 0.01

QString levelPhrase(PairLevel level, const query::PairResult& result) {
  switch (level) {
    case PairLevel::kTouching:
      return tr("%1 and %2 touch");
    case PairLevel::kInside:
      if (result.contacts == 0) return tr("%1 and %2 are not certainly outside the margin");
      return tr("%1 and %2 are inside the margin");
    case PairLevel::kNear:
      return tr("%1 and %2 are near each other, closer than twice the margin,");
    case PairLevel::kLost:
      return tr("The pose of %1 or %2 is lost");
    case PairLevel::kPaused:
      return tr("%1 and %2 are not checked: their group does not run, or they are in none");
    case PairLevel::kApart:
      return tr("%1 and %2 are clear of each other");
    case PairLevel::kUnknown:
      break;
  }
  return tr("Nothing is known of %1 and %2 yet");
}

QString sinceText(const LevelTimes::Since& since) {
  if (std::isnan(since.t)) return {};
  return (since.exact ? tr(" since %1") : tr(" since %1 or earlier")).arg(secondsWithUnit(since.t));
}

QString marginText(double margin, double uncertainty) {
  if (!(uncertainty > 0.0)) return tr("margin %1").arg(lengthText(margin, 0));
  if (std::isinf(uncertainty)) return tr("margin %1 and poses unknown").arg(lengthText(margin, 0));
  return tr("margin %1 and %2 for the poses").arg(lengthText(margin, 0), lengthText(uncertainty, 0));
}

QString closingText(double speed) {
  if (!std::isfinite(speed)) return tr("closing speed not known");
  if (std::abs(speed) < kStill) return tr("neither closing nor moving apart");
  return (speed > 0.0 ? tr("closing at %1 m/s") : tr("moving apart at %1 m/s"))
      .arg(fixed(std::abs(speed), 2));
}

}  // namespace

QString distanceText(double distance, double pose_uncertainty) {
  if (!(pose_uncertainty > 0.0)) return lengthText(distance);
  if (std::isinf(pose_uncertainty)) return tr("%1, pose unknown").arg(lengthText(distance, 0));
  return tr("%1 ± %2").arg(lengthText(distance, 0), lengthText(pose_uncertainty, 0));
}

QString pairSentence(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot, int pair,
                     const LevelTimes::Since& since) {
  const auto p = static_cast<std::size_t>(pair);
  if (pair < 0 || p >= outline.pairs.size() || snapshot.pairs.size() != outline.pairs.size() ||
      snapshot.objects.size() != outline.objects.size())
    return {};
  const auto objects = outline.pairs[p];
  const view::PairSnapshot& now = snapshot.pairs[p];
  const PairLevel level = pairLevel(snapshot, now, objects);
  const auto name = [&](int object) {
    return QString::fromStdString(outline.objects[static_cast<std::size_t>(object)].name);
  };
  const QString head =
      levelPhrase(level, now.result).arg(name(objects.first), name(objects.second)) + sinceText(since);
  if (level == PairLevel::kUnknown) return head + QLatin1Char('.');
  const QString distance =
      tr("distance %1 ± %2").arg(lengthText(now.result.distance), lengthText(now.result.bound));
  if (level == PairLevel::kPaused) return tr("%1. When last checked: %2.").arg(head, distance);
  return tr("%1: %2, %3, %4, %5.")
      .arg(head, distance, marginText(now.margin, poseUncertainty(snapshot, objects)),
           closingText(closingSpeeds(snapshot, now.result, objects).sum()),
           forceText(forceKind(now.result), now.result.force_a.norm()));
}

QString bodySentence(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot, int object,
                     const LevelTimes& times) {
  const auto i = static_cast<std::size_t>(object);
  if (object < 0 || i >= outline.objects.size() || snapshot.objects.size() != outline.objects.size())
    return {};
  std::vector<BodyState> states;
  findBodyStates(outline, snapshot, states);
  QString text = QString::fromStdString(outline.objects[i].name);
  if (states[i].pair >= 0)
    text += QLatin1Char('\n') + pairSentence(outline, snapshot, states[i].pair, times.of(states[i].pair));
  if (scene::isPoseLost(snapshot.objects[i].pose_state))
    text += QLatin1Char('\n') + tr("The pose is stale or was rejected: drawn hollow, never safe");
  return text;
}

}  // namespace abstand::ui
