#include "ui/model/pair_level.hpp"

#include <algorithm>
#include <cmath>

#include "core/safety/clearance_verdict.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

double poseUncertainty(const view::SceneSnapshot& snapshot, std::pair<int, int> objects) {
  return snapshot.objects[static_cast<std::size_t>(objects.first)].pose_uncertainty +
         snapshot.objects[static_cast<std::size_t>(objects.second)].pose_uncertainty;
}

bool isTouching(const query::PairResult& result) { return safety::isTouching(result.distance, result.bound); }

ForceKind forceKind(const query::PairResult& result) {
  if (result.contacts == 0) return ForceKind::kNone;
  return isTouching(result) ? ForceKind::kContact : ForceKind::kVirtual;
}

QString forceText(ForceKind kind, double newtons) {
  switch (kind) {
    case ForceKind::kContact:
      return tr("contact force %1 N").arg(fixed(newtons, 1));
    case ForceKind::kVirtual:
      return tr("virtual (margin) force %1 N").arg(fixed(newtons, 1));
    case ForceKind::kNone:
      break;
  }
  return tr("no force");
}

QColor levelColour(PairLevel level) {
  switch (level) {
    case PairLevel::kTouching:
      return QColor(kVermillion);
    case PairLevel::kInside:
      return QColor(kOchre);
    case PairLevel::kNear:
    case PairLevel::kLost:
    case PairLevel::kPaused:
      return QColor(kAmber);
    case PairLevel::kApart:
    case PairLevel::kUnknown:
      break;
  }
  return QColor(kCalm);
}

PairLevel pairLevel(const view::SceneSnapshot& snapshot, const view::PairSnapshot& pair,
                    std::pair<int, int> objects) {
  const auto lost = [&](int object) {
    return scene::isPoseLost(snapshot.objects[static_cast<std::size_t>(object)].pose_state);
  };
  if (pair.paused) return PairLevel::kPaused;
  const query::PairResult& result = pair.result;
  if (isTouching(result)) return PairLevel::kTouching;
  if (result.contacts > 0) return PairLevel::kInside;
  if (lost(objects.first) || lost(objects.second)) return PairLevel::kLost;
  if (std::isnan(result.distance)) return PairLevel::kUnknown;
  const safety::KnownDistance known{result.distance, result.bound, poseUncertainty(snapshot, objects)};
  if (safety::verdict(known, pair.margin) != safety::ClearanceVerdict::kKept) return PairLevel::kInside;
  return safety::certifiedClearance(known) < kNearFactor * pair.margin ? PairLevel::kNear : PairLevel::kApart;
}

QString levelText(PairLevel level) {
  switch (level) {
    case PairLevel::kTouching:
      return tr("⚠ touching");
    case PairLevel::kLost:
      return tr("? pose lost");
    case PairLevel::kPaused:
      return tr("? not checked");
    case PairLevel::kNear:
      return tr("▲ near");
    case PairLevel::kInside:
      return tr("⚠ inside margin");
    case PairLevel::kApart:
      return tr("clear");
    case PairLevel::kUnknown:
      break;
  }
  return tr("–");
}

}  // namespace abstand::ui
