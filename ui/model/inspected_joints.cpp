#include "ui/model/inspected_joints.hpp"

#include <algorithm>
#include <cmath>

#include "ui/model/stop_text.hpp"
#include "ui/style/format.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

QString limitsText(const view::SceneOutline::JointInfo& joint) {
  if (std::isinf(joint.lower) && std::isinf(joint.upper)) return tr("no limits");
  return tr("%1 to %2").arg(jointValueText(joint, joint.lower), jointValueText(joint, joint.upper));
}

QString torqueText(const view::SceneOutline::JointInfo& joint, const view::TorqueParts& torque) {
  const QString unit = joint.prismatic ? tr("N") : tr("N·m");
  QString text = tr("contact %1, reaction %2").arg(fixed(torque.contact, 1), fixed(torque.reaction, 1));
  if (!std::isnan(torque.gravity))
    text += tr(", gravity %1, motion %2").arg(fixed(torque.gravity, 1), fixed(torque.motion, 1));
  text += QLatin1Char(' ') + unit;
  return std::isinf(joint.effort) ? text : tr("%1 of at most %2 %3").arg(text, fixed(joint.effort, 0), unit);
}

}  // namespace

QString robotMotionText(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot, int robot) {
  const view::RobotCard& card = outline.robots[static_cast<std::size_t>(robot)];
  if (isByHand(snapshot, robot)) return tr("posed by hand");
  for (std::size_t i = 0; i < std::min(outline.reacting.size(), snapshot.robots.size()); ++i)
    if (outline.reacting[i] == card.name && snapshot.robots[i].state != safety::StopState::kRunning)
      return stopText(outline, snapshot, i);
  if (card.motion.empty()) return tr("rests");
  return tr("follows %1").arg(QString::fromStdString(card.motion).section(QLatin1Char('/'), -1));
}

QString jointValueText(const view::SceneOutline::JointInfo& joint, double value) {
  if (std::isinf(value)) return value > 0.0 ? QStringLiteral("∞") : QStringLiteral("−∞");
  return joint.prismatic ? lengthText(value) : angleText(value);
}

std::vector<InspectedRow> jointRows(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot,
                                    int robot) {
  std::vector<InspectedRow> rows;
  const view::RobotCard& card = outline.robots[static_cast<std::size_t>(robot)];
  for (int k = 0; k < card.joints; ++k) {
    const auto i = static_cast<std::size_t>(card.first_joint + k);
    if (i >= snapshot.joint_positions.size() || i >= snapshot.joint_torques.size() ||
        i >= outline.joints.size())
      break;
    const view::SceneOutline::JointInfo& joint = outline.joints[i];
    const double q = snapshot.joint_positions[i];
    const bool beyond = q < joint.lower || q > joint.upper;
    rows.push_back({tr("Joint %1").arg(QString::fromStdString(joint.name)),
                    tr("%1 (%2)").arg(jointValueText(joint, q), limitsText(joint)),
                    beyond ? InspectedRow::Mark::kAlarm : InspectedRow::Mark::kPlain});
    rows.push_back({tr("Torque of %1").arg(QString::fromStdString(joint.name)),
                    torqueText(joint, snapshot.joint_torques[i]), InspectedRow::Mark::kPlain});
  }
  return rows;
}

}  // namespace abstand::ui
