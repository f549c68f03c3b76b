// What a robot's stop machine and the limits of its joints say, in the user's words and units.
#include "ui/model/stop_text.hpp"

#include <cmath>

#include "ui/style/format.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

QString reasonText(safety::StopReason reason) {
  switch (reason) {
    case safety::StopReason::kDistance:
      return tr("distance");
    case safety::StopReason::kSeparation:
      return tr("separation");
    case safety::StopReason::kEnergy:
      return tr("energy");
    case safety::StopReason::kStaleInput:
      return tr("stale input");
    case safety::StopReason::kLostPerson:
      return tr("lost person");
    case safety::StopReason::kLostLink:
      return tr("lost connection");
    case safety::StopReason::kTorque:
      return tr("torque");
    case safety::StopReason::kJointSpeed:
      return tr("joint speed");
    case safety::StopReason::kSpeedBound:
      return tr("bound on speed");
    case safety::StopReason::kUser:
      return tr("user");
    case safety::StopReason::kBraking:
      return tr("braking path");
  }
  return {};
}

QString reasonMeaning(safety::StopReason reason) {
  switch (reason) {
    case safety::StopReason::kDistance:
      return tr("A certified distance is below its limit.");
    case safety::StopReason::kSeparation:
      return tr("The robot is faster than the separation permits.");
    case safety::StopReason::kEnergy:
      return tr("A link has more kinetic energy than the repulsion can absorb.");
    case safety::StopReason::kStaleInput:
      return tr("The joint values are older than allowed.");
    case safety::StopReason::kLostPerson:
      return tr("The pose of a person is older than allowed, or unreliable.");
    case safety::StopReason::kLostLink:
      return tr("The connection to the robot is lost.");
    case safety::StopReason::kTorque:
      return tr("A joint torque was limited.");
    case safety::StopReason::kJointSpeed:
      return tr("A joint is faster than allowed.");
    case safety::StopReason::kSpeedBound:
      return tr("A body was faster than the bound that certified distances rely on.");
    case safety::StopReason::kUser:
      return tr("Somebody asks for a stop.");
    case safety::StopReason::kBraking:
      return tr("While it brakes, a person could come nearer than allowed.");
  }
  return {};
}

QString responseText(safety::StopResponse response) {
  switch (response) {
    case safety::StopResponse::kNone:
      return tr("no stop");
    case safety::StopResponse::kSlow:
      return tr("slow down");
    case safety::StopResponse::kProtective:
      return tr("protective stop");
    case safety::StopResponse::kEmergency:
      return tr("emergency stop");
  }
  return {};
}

namespace {

/// The `index`th joint of a mechanism; null where there is none.
const view::SceneOutline::JointInfo* jointOf(const view::SceneOutline& outline, const std::string& mechanism,
                                             int index) {
  for (const auto& joint : outline.joints)
    if (joint.mechanism == mechanism && index-- == 0) return &joint;
  return nullptr;
}

QString numberText(double value, const safety::StopCause& cause, const view::SceneOutline::JointInfo* joint) {
  switch (cause.reason) {
    case safety::StopReason::kDistance:
    case safety::StopReason::kBraking:
      return lengthText(value);
    case safety::StopReason::kSeparation:
    case safety::StopReason::kSpeedBound:
      return tr("%1 m/s").arg(fixed(value, 2));
    case safety::StopReason::kEnergy:
      return tr("%1 J").arg(fixed(value, 3));
    case safety::StopReason::kStaleInput:
    case safety::StopReason::kLostPerson:
    case safety::StopReason::kLostLink:
      return tr("%1 s").arg(fixed(value, 3));
    case safety::StopReason::kTorque:
      return (joint && joint->prismatic ? tr("%1 N") : tr("%1 N·m")).arg(fixed(value, 1));
    case safety::StopReason::kJointSpeed:
      return (joint && joint->prismatic ? tr("%1 m/s") : tr("%1 rad/s")).arg(fixed(value, 2));
    case safety::StopReason::kUser:
      break;
  }
  return fixed(value, 3);
}

int rank(safety::StopState state) {
  switch (state) {
    case safety::StopState::kRunning:
      return 0;
    case safety::StopState::kSlowing:
      return 1;
    case safety::StopState::kProtectiveStop:
      return 2;
    case safety::StopState::kWaitingForReset:
      return 3;
    case safety::StopState::kEmergencyStop:
      return 4;
  }
  return 0;
}

}  // namespace

QString stateText(safety::StopState state) {
  switch (state) {
    case safety::StopState::kRunning:
      return tr("running");
    case safety::StopState::kSlowing:
      return tr("slowed down");
    case safety::StopState::kProtectiveStop:
      return tr("protective stop");
    case safety::StopState::kEmergencyStop:
      return tr("emergency stop");
    case safety::StopState::kWaitingForReset:
      return tr("waiting for reset");
  }
  return {};
}

QString refusalText(safety::ResetRefusal refusal) {
  switch (refusal) {
    case safety::ResetRefusal::kCause:
      return tr("a cause asks for a stop");
    case safety::ResetRefusal::kTooEarly:
      return tr("the robot is not at standstill yet");
    case safety::ResetRefusal::kNone:
      break;
  }
  return {};
}

bool isStop(safety::StopState state) { return rank(state) > rank(safety::StopState::kSlowing); }

QString causeText(const safety::StopCause& cause, const view::SceneOutline& outline, std::size_t robot) {
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

QString stopText(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot, std::size_t robot) {
  const view::RobotSnapshot& now = snapshot.robots[robot];
  if (now.state == safety::StopState::kRunning) return {};
  const safety::StopCause& cause = now.cause;
  const auto pair = static_cast<std::size_t>(cause.pair);
  const bool near =
      cause.reason == safety::StopReason::kDistance || cause.reason == safety::StopReason::kBraking;
  if (!near || cause.pair < 0 || pair >= outline.pairs.size() || std::isnan(cause.value))
    return tr("%1: %2").arg(stateText(now.state), causeText(cause, outline, robot));
  const auto name = [&](int object) {
    return QString::fromStdString(outline.objects[static_cast<std::size_t>(object)].name);
  };
  return tr("%1: %2 – %3 at %4")
      .arg(stateText(now.state), name(outline.pairs[pair].first), name(outline.pairs[pair].second),
           lengthText(cause.value));
}

QString spanText(const StopSpan& span, const view::SceneOutline& outline) {
  const auto robot = static_cast<std::size_t>(span.robot);
  const QString name =
      robot < outline.reacting.size() ? QString::fromStdString(outline.reacting[robot]) : QString();
  return tr("%1 stood from %2 to %3 when this was played, %4: %5")
      .arg(name, secondsWithUnit(span.range.from), secondsWithUnit(span.range.to), stateText(span.state),
           causeText(span.cause, outline, robot));
}

QString entryText(const safety::StopEntry& entry, const view::SceneOutline& outline, std::size_t robot) {
  const QString name =
      robot < outline.reacting.size() ? QString::fromStdString(outline.reacting[robot]) : QString();
  const QString text =
      tr("%1  %2: %3 → %4").arg(secondsWithUnit(entry.t), name, stateText(entry.from), stateText(entry.to));
  return rank(entry.to) < rank(entry.from) ? tr("%1, after %2").arg(text, secondsWithUnit(entry.lasted))
                                           : tr("%1: %2").arg(text, causeText(entry.cause, outline, robot));
}

QString breachText(const mechanism::LimitBreach& breach, const view::SceneOutline& outline,
                   std::size_t robot) {
  const std::string name = robot < outline.reacting.size() ? outline.reacting[robot] : std::string();
  const auto* joint = jointOf(outline, name, breach.dof);
  const bool slides = joint && joint->prismatic;
  const auto amount = [&](double value) {
    switch (breach.kind) {
      case mechanism::LimitKind::kPosition:
        return slides ? tr("%1 m").arg(fixed(value, 3)) : tr("%1 rad").arg(fixed(value, 3));
      case mechanism::LimitKind::kVelocity:
        return slides ? tr("%1 m/s").arg(fixed(value, 2)) : tr("%1 rad/s").arg(fixed(value, 2));
      case mechanism::LimitKind::kAcceleration:
        return slides ? tr("%1 m/s²").arg(fixed(value, 2)) : tr("%1 rad/s²").arg(fixed(value, 2));
      case mechanism::LimitKind::kEffort:
        return slides ? tr("%1 N").arg(fixed(value, 1)) : tr("%1 N m").arg(fixed(value, 1));
    }
    return QString();
  };
  const QString kind = breach.kind == mechanism::LimitKind::kPosition       ? tr("position")
                       : breach.kind == mechanism::LimitKind::kVelocity     ? tr("velocity")
                       : breach.kind == mechanism::LimitKind::kAcceleration ? tr("acceleration")
                                                                            : tr("effort");
  return tr("%1  %2: joint %3 beyond its %4 limit: %5, limit %6")
      .arg(secondsWithUnit(breach.t), QString::fromStdString(name),
           joint ? QString::fromStdString(joint->name) : QString::number(breach.dof), kind,
           amount(breach.value), amount(breach.limit));
}

QString worstText(const view::SceneSnapshot& snapshot, const view::SceneOutline& outline, bool* alarm) {
  const view::RobotSnapshot* worst = nullptr;
  std::size_t who = 0;
  for (std::size_t i = 0; i < std::min(snapshot.robots.size(), outline.reacting.size()); ++i) {
    if (worst && rank(snapshot.robots[i].state) <= rank(worst->state)) continue;
    worst = &snapshot.robots[i];
    who = i;
  }
  *alarm = worst && isStop(worst->state);
  if (!worst) return {};
  if (worst->state == safety::StopState::kRunning) return tr("Robots: running");
  return tr("%1: %2").arg(QString::fromStdString(outline.reacting[who]), stateText(worst->state));
}

}  // namespace abstand::ui
