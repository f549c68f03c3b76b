// Speed and separation, and predicted contact, of each body part at one moment.
#include "ui/model/separation_rows.hpp"

#include <algorithm>
#include <cmath>

#include "core/safety/clearance_verdict.hpp"
#include "ui/model/closing_speed.hpp"
#include "ui/model/groups.hpp"
#include "ui/model/pair_class.hpp"
#include "ui/model/pair_level.hpp"
#include "ui/style/format.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

constexpr double kHalf = 0.5;  // share of a limit from which a contact is drawn with a mark

bool isSeen(const view::ObjectSnapshot& object) { return !scene::isPoseLost(object.pose_state); }

void judgeContact(SeparationRow& row, const std::string& part, const SeparationSettings& settings,
                  const contact::ContactLimits* limits) {
  if (!limits) return;
  const contact::ContactMotion motion{
      row.robot_speed + row.person_speed,
      {settings.robot_mass > 0.0 ? settings.robot_mass : kInfinity, contact::RobotMassSource::kPosture},
      settings.clamped ? contact::ContactKind::kQuasiStatic : contact::ContactKind::kTransient};
  row.contact = contact::worstContact(limits->regionsOf(part), motion);
  if (!row.contact.region || row.state == SeparationState::kUnknown) return;
  const double share = row.contact.contact.share;
  row.contact_state = !(motion.speed > 0.0) ? ContactState::kNoImpact
                      : !(share <= 1.0)     ? ContactState::kAbove
                      : share > kHalf       ? ContactState::kBelow
                                            : ContactState::kBelowHalf;
}

/// Of one pair; the state is not judged yet.
SeparationRow rowOf(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot, std::size_t pair,
                    const SeparationSettings& settings) {
  const auto [a, b] = outline.pairs[pair];
  const query::PairResult& result = snapshot.pairs[pair].result;
  const bool person_first = outline.objects[static_cast<std::size_t>(a)].human;
  const view::ObjectSnapshot& one = snapshot.objects[static_cast<std::size_t>(a)];
  const view::ObjectSnapshot& other = snapshot.objects[static_cast<std::size_t>(b)];
  const auto [speed_a, speed_b] = closingSpeeds(snapshot, result, {a, b});
  SeparationRow row;
  row.part = person_first ? a : b;
  row.link = person_first ? b : a;
  row.pair = static_cast<int>(pair);
  row.person_speed = person_first ? speed_a : speed_b;
  row.robot_speed = person_first ? speed_b : speed_a;
  if (snapshot.pairs[pair].paused || !isSeen(one) || !isSeen(other)) return row;
  row.clearance =
      safety::certifiedClearance({result.distance, result.bound, poseUncertainty(snapshot, {a, b})});
  row.needed = safety::protectiveDistance(settings.options, row.robot_speed, row.person_speed, row.clearance);
  if (std::isinf(row.clearance) || std::isnan(row.clearance)) return row;
  row.permitted_speed = safety::permittedSpeed(settings.options, std::max(0.0, row.robot_speed),
                                               row.person_speed, row.clearance);
  row.state = row.clearance >= row.needed.sum() ? SeparationState::kKept
              : row.robot_speed > 0.0           ? SeparationState::kNotKept
                                                : SeparationState::kNoApproach;
  return row;
}

/// Of two pairs of one part.
bool isWorse(const SeparationRow& row, const SeparationRow& than) {
  if (row.state != than.state) return row.state > than.state;
  return row.needed.sum() - row.clearance > than.needed.sum() - than.clearance;
}

QString cited(const contact::CitedValue& value, const QString& text) {
  QString line = tr("%1 [%2]").arg(text, QString::fromStdString(value.source));
  if (!value.to_be_checked.empty())
    line += tr("; to be checked: %1").arg(QString::fromStdString(value.to_be_checked));
  return line;
}

QStringList contactLines(const SeparationRow& row, const SeparationSettings& settings) {
  const contact::RegionLimits& region = *row.contact.region;
  const contact::PredictedContact& now = row.contact.contact;
  QStringList lines{tr("Contact at this speed, region \"%1\": %2")
                        .arg(QString::fromStdString(region.name), contactText(row))};
  if (now.excluded) {
    lines << tr("Contact with this region is excluded at any speed [%1]")
                 .arg(QString::fromStdString(region.transient.source));
    return lines;
  }
  lines << cited(region.force, tr("limit of the force %1 N").arg(fixed(region.force.value, 0)));
  if (!settings.clamped)
    lines << cited(region.transient,
                   tr("times %1 for a part that can recoil").arg(fixed(region.transient.value, 1)));
  lines << cited(region.spring, tr("stiffness %1 N/mm").arg(fixed(1e-3 * region.spring.value, 0)))
        << cited(region.body_mass, tr("mass of the region %1 kg").arg(fixed(region.body_mass.value, 1)))
        << (settings.robot_mass > 0.0
                ? tr("mass of the robot %1 kg [set here]").arg(fixed(settings.robot_mass, 1))
                : tr("mass of the robot not known: counts as immovable [on the safe side]"))
        << tr("permitted speed towards each other %1 m/s").arg(fixed(now.allowed_speed, 3));
  return lines;
}

}  // namespace

bool SeparationSettings::operator==(const SeparationSettings& other) const {
  std::vector<double> mine, theirs;
  const auto into = [](std::vector<double>& list) {
    return [&list](const char*, double value, const config::NumberRule&) { list.push_back(value); };
  };
  safety::SeparationOptions::eachNumber(options, into(mine));
  safety::SeparationOptions::eachNumber(other.options, into(theirs));
  return mine == theirs && robot_mass == other.robot_mass && clamped == other.clamped;
}

std::vector<SeparationRow> separationRows(const view::SceneOutline& outline,
                                          const view::SceneSnapshot& snapshot,
                                          const SeparationSettings& settings,
                                          const contact::ContactLimits* limits) {
  std::vector<int> row_of(outline.objects.size(), -1);
  std::vector<SeparationRow> rows;
  for (std::size_t i = 0; i < outline.objects.size(); ++i) {
    if (!outline.objects[i].human) continue;
    row_of[i] = static_cast<int>(rows.size());
    rows.emplace_back().part = static_cast<int>(i);
  }
  for (std::size_t p = 0; p < std::min(outline.pairs.size(), snapshot.pairs.size()); ++p) {
    if (pairClassOf(outline, outline.pairs[p]) != PairClass::kPersonRobot) continue;
    const SeparationRow now = rowOf(outline, snapshot, p, settings);
    SeparationRow& row = rows[static_cast<std::size_t>(row_of[static_cast<std::size_t>(now.part)])];
    if (row.pair < 0 || isWorse(now, row)) row = now;
  }
  for (SeparationRow& row : rows)
    if (row.pair >= 0)
      judgeContact(row, shortName(outline.objects[static_cast<std::size_t>(row.part)]), settings, limits);
  return rows;
}

QString separationText(const SeparationRow& row) {
  const double spare = row.clearance - row.needed.sum();
  switch (row.state) {
    case SeparationState::kKept:
      return tr("%1 to spare").arg(lengthText(spare, 0));
    case SeparationState::kNoApproach:
      return tr("%1 short, no approach").arg(lengthText(-spare, 0));
    case SeparationState::kNotKept:
      return tr("⚠ %1 short").arg(lengthText(-spare, 0));
    case SeparationState::kUnknown:
      break;
  }
  return row.pair < 0 ? tr("no pair is checked") : tr("not known");
}

QString contactText(const SeparationRow& row) {
  const contact::PredictedContact& now = row.contact.contact;
  switch (row.contact_state) {
    case ContactState::kNoImpact:
      return tr("moving apart");
    case ContactState::kBelowHalf:
    case ContactState::kBelow:
    case ContactState::kAbove:
      if (now.excluded) return tr("⚠ excluded");
      return (row.contact_state == ContactState::kAbove ? tr("⚠ %1 of %2 N") : tr("%1 of %2 N"))
          .arg(fixed(now.force, 0), fixed(now.allowed_force, 0));
    case ContactState::kUnknown:
      break;
  }
  return tr("not known");
}

QString separationTip(const view::SceneOutline& outline, const SeparationRow& row,
                      const SeparationSettings& settings) {
  const auto name = [&](int object) {
    return QString::fromStdString(outline.objects[static_cast<std::size_t>(object)].name);
  };
  if (row.pair < 0) return tr("%1: no pair with a robot is checked").arg(name(row.part));
  const safety::SeparationOptions& set = settings.options;
  QStringList lines{tr("%1 – %2: %3").arg(name(row.part), name(row.link), separationText(row))};
  if (row.state != SeparationState::kUnknown) {
    lines << tr("certified clearance %1 [distance − uncertainty − poses]").arg(lengthText(row.clearance, 0))
          << tr("S_h, the person: %1 [ISO 13855:2010: %2 m/s, or %3 m/s nearer than %4]")
                 .arg(lengthText(row.needed.person, 0), fixed(set.person_speed, 1),
                      fixed(set.person_speed_near, 1), lengthText(set.near, 0))
          << tr("S_r, reaction: %1 [robot at %2 m/s for %3 s, set here]")
                 .arg(lengthText(row.needed.reaction, 0), fixed(std::max(0.0, row.robot_speed), 2),
                      fixed(set.reaction_time, 2))
          << (set.deceleration > 0.0
                  ? tr("S_s, stopping: %1 [at %2 m/s², set here]")
                        .arg(lengthText(row.needed.stopping, 0), fixed(set.deceleration, 1))
                  : tr("S_s, stopping: %1 [in %2 s, set here]")
                        .arg(lengthText(row.needed.stopping, 0), fixed(set.stopping_time, 2)))
          << tr("C + Z_d + Z_r: %1 [set here]").arg(lengthText(row.needed.constant, 0))
          << tr("S_p, their sum: %1 [ISO/TS 15066:2016, 5.5.4]").arg(lengthText(row.needed.sum(), 0))
          << tr("towards each other: robot %1 m/s, person %2 m/s")
                 .arg(fixed(row.robot_speed, 2), fixed(row.person_speed, 2))
          << tr("the robot may approach at %1 m/s").arg(fixed(row.permitted_speed, 2));
  }
  if (row.contact.region) lines << contactLines(row, settings);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace abstand::ui
