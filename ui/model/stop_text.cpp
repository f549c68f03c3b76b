// What a robot's stop machine and the limits of its joints say, in the user's words and units.
#include "ui/model/stop_text.hpp"

#include <QCoreApplication>
#include <cmath>

#include "ui/style/format.hpp"

namespace abstand::ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("abstand::ui::StopText", text); }

QString reasonText(StopReason reason) {
  switch (reason) {
    case StopReason::kDistance:
      return tr("distance");
    case StopReason::kSeparation:
      return tr("separation");
    case StopReason::kEnergy:
      return tr("energy");
    case StopReason::kStaleInput:
      return tr("stale input");
    case StopReason::kLostPerson:
      return tr("lost person");
    case StopReason::kLostLink:
      return tr("lost connection");
    case StopReason::kTorque:
      return tr("torque");
    case StopReason::kJointSpeed:
      return tr("joint speed");
    case StopReason::kSpeedBound:
      return tr("bound on speed");
    case StopReason::kUser:
      return tr("user");
    case StopReason::kBraking:
      return tr("braking path");
  }
  return {};
}

/// The `index`th joint of a mechanism; null where there is none.
const SceneOutline::JointInfo* jointOf(const SceneOutline& outline, const std::string& mechanism, int index) {
  for (const auto& joint : outline.joints)
    if (joint.mechanism == mechanism && index-- == 0) return &joint;
  return nullptr;
}

QString numberText(double value, const StopCause& cause, const SceneOutline::JointInfo* joint) {
  switch (cause.reason) {
    case StopReason::kDistance:
    case StopReason::kBraking:
      return millimetresWithUnit(value);
    case StopReason::kSeparation:
    case StopReason::kSpeedBound:
      return tr("%1 m/s").arg(fixed(value, 2));
    case StopReason::kEnergy:
      return tr("%1 J").arg(fixed(value, 3));
    case StopReason::kStaleInput:
    case StopReason::kLostPerson:
    case StopReason::kLostLink:
      return tr("%1 s").arg(fixed(value, 3));
    case StopReason::kTorque:
      return (joint && joint->prismatic ? tr("%1 N") : tr("%1 N·m")).arg(fixed(value, 1));
    case StopReason::kJointSpeed:
      return (joint && joint->prismatic ? tr("%1 m/s") : tr("%1 rad/s")).arg(fixed(value, 2));
    case StopReason::kUser:
      break;
  }
  return fixed(value, 3);
}

int rank(StopState state) {
  switch (state) {
    case StopState::kRunning:
      return 0;
    case StopState::kSlowing:
      return 1;
    case StopState::kProtectiveStop:
      return 2;
    case StopState::kWaitingForReset:
      return 3;
    case StopState::kEmergencyStop:
      return 4;
  }
  return 0;
}

}  // namespace

QString stateText(StopState state) {
  switch (state) {
    case StopState::kRunning:
      return tr("running");
    case StopState::kSlowing:
      return tr("slowed down");
    case StopState::kProtectiveStop:
      return tr("protective stop");
    case StopState::kEmergencyStop:
      return tr("emergency stop");
    case StopState::kWaitingForReset:
      return tr("waiting for reset");
  }
  return {};
}

QString refusalText(ResetRefusal refusal) {
  switch (refusal) {
    case ResetRefusal::kCause:
      return tr("a cause asks for a stop");
    case ResetRefusal::kTooEarly:
      return tr("it does not stand yet");
    case ResetRefusal::kNone:
      break;
  }
  return {};
}

bool isStop(StopState state) { return rank(state) > rank(StopState::kSlowing); }

QString causeText(const StopCause& cause, const SceneOutline& outline, std::size_t robot) {
  const auto* joint = cause.joint >= 0 && robot < outline.reacting.size()
                          ? jointOf(outline, outline.reacting[robot], cause.joint)
                          : nullptr;
  QString text = reasonText(cause.reason);
  if (!std::isnan(cause.value)) text += QLatin1Char(' ') + numberText(cause.value, cause, joint);
  if (!std::isnan(cause.limit)) text += tr(", limit %1").arg(numberText(cause.limit, cause, joint));
  const auto pair = static_cast<std::size_t>(cause.pair);
  if (cause.pair >= 0 && pair < outline.pairs.size()) {
    const auto name = [&](int object) {
      return QString::fromStdString(outline.objects[static_cast<std::size_t>(object)].name);
    };
    text += tr(", %1 – %2").arg(name(outline.pairs[pair].first), name(outline.pairs[pair].second));
  }
  if (joint) text += tr(", joint %1").arg(QString::fromStdString(joint->name));
  return text;
}

QString entryText(const StopEntry& entry, const SceneOutline& outline, std::size_t robot) {
  const QString name =
      robot < outline.reacting.size() ? QString::fromStdString(outline.reacting[robot]) : QString();
  const QString text =
      tr("%1  %2: %3 → %4").arg(secondsWithUnit(entry.t), name, stateText(entry.from), stateText(entry.to));
  return rank(entry.to) < rank(entry.from) ? tr("%1, after %2").arg(text, secondsWithUnit(entry.lasted))
                                           : tr("%1: %2").arg(text, causeText(entry.cause, outline, robot));
}

QString breachText(const LimitBreach& breach, const SceneOutline& outline, std::size_t robot) {
  const std::string name = robot < outline.reacting.size() ? outline.reacting[robot] : std::string();
  const auto* joint = jointOf(outline, name, breach.dof);
  const bool slides = joint && joint->prismatic;
  const auto amount = [&](double value) {
    switch (breach.kind) {
      case LimitKind::kPosition:
        return slides ? tr("%1 m").arg(fixed(value, 3)) : tr("%1 rad").arg(fixed(value, 3));
      case LimitKind::kVelocity:
        return slides ? tr("%1 m/s").arg(fixed(value, 2)) : tr("%1 rad/s").arg(fixed(value, 2));
      case LimitKind::kAcceleration:
        return slides ? tr("%1 m/s²").arg(fixed(value, 2)) : tr("%1 rad/s²").arg(fixed(value, 2));
      case LimitKind::kEffort:
        return slides ? tr("%1 N").arg(fixed(value, 1)) : tr("%1 N m").arg(fixed(value, 1));
    }
    return QString();
  };
  const QString kind = breach.kind == LimitKind::kPosition       ? tr("position")
                       : breach.kind == LimitKind::kVelocity     ? tr("velocity")
                       : breach.kind == LimitKind::kAcceleration ? tr("acceleration")
                                                                 : tr("effort");
  return tr("%1  %2: joint %3 beyond its %4 limit: %5, limit %6")
      .arg(secondsWithUnit(breach.t), QString::fromStdString(name),
           joint ? QString::fromStdString(joint->name) : QString::number(breach.dof), kind,
           amount(breach.value), amount(breach.limit));
}

QString worstText(const SceneSnapshot& snapshot, const SceneOutline& outline, bool* alarm) {
  const RobotSnapshot* worst = nullptr;
  std::size_t who = 0;
  for (std::size_t i = 0; i < std::min(snapshot.robots.size(), outline.reacting.size()); ++i) {
    if (worst && rank(snapshot.robots[i].state) <= rank(worst->state)) continue;
    worst = &snapshot.robots[i];
    who = i;
  }
  *alarm = worst && isStop(worst->state);
  if (!worst) return {};
  if (worst->state == StopState::kRunning) return tr("Robots: running");
  return tr("%1: %2").arg(QString::fromStdString(outline.reacting[who]), stateText(worst->state));
}

}  // namespace abstand::ui
