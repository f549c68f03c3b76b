#include "ui/model/law_text.hpp"

#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "ui/style/format.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

constexpr QChar kInfinitySign(0x221e), kMinusSign(0x2212);
constexpr double kSmallestPlain = 1e-4, kLargestPlain = 1e7;  // without an exponent
constexpr double kSizeOfZero = 0.1;                           // for the steps of a number that is 0

struct LawWords {
  const char* key;
  const char* name;
  const char* meaning;
};

#define TEXT(s) QT_TRANSLATE_NOOP("abstand::ui", s)  // scripts/translations knows this name

const LawWords kLaws[] = {
    {"torque", TEXT("Torque"), TEXT("Joint efforts of contacts and pokes, times a gain, reach the motors.")},
    {"repulsion", TEXT("Repulsion"), TEXT("A potential around the links pushes the robot away from bodies.")},
    {"proxy", TEXT("Held object"), TEXT("A held object stays on the surface while the hand is pressed in.")},
    {"admittance", TEXT("Admittance"),
     TEXT("Turns torques into motion, for a robot that is controlled by positions.")},
    {"speed", TEXT("Speed and separation"),
     TEXT("Slows the planned motion so that a person keeps the "
          "protective distance of ISO/TS 15066.")},
    {"braking", TEXT("Braking"), TEXT("Stops the robot if a person could reach its braking path.")},
    {"hold", TEXT("Hold"), TEXT("Keeps the robot on its planned motion; always active.")},
    {"stop", TEXT("Stop conditions"), TEXT("What stops the robot, and how it goes on; always active.")},
};

const LawWords kNumbers[] = {
    {"torque.gain", TEXT("Gain"), TEXT("Factor on the joint efforts of contacts.")},
    {"torque.limit", TEXT("Largest torque"), TEXT("Limit of the sum of all torques on a joint.")},
    {"repulsion.range", TEXT("Range"), TEXT("The force begins at this distance.")},
    {"repulsion.force", TEXT("Force"), TEXT("Force at distance 0 and inside.")},
    {"repulsion.damping", TEXT("Damping"), TEXT("Damping ratio of the approach; 1: critical.")},
    {"repulsion.mass", TEXT("Mass"), TEXT("Effective mass where no mass matrix is known.")},
    {"repulsion.stop_distance", TEXT("Stop distance"),
     TEXT("An approach must have ended at this distance; it must be below the range.")},
    {"repulsion.stop_share", TEXT("Stop share"),
     TEXT("Share of the potential energy that a moving link may use up; above it the brakes engage.")},
    {"proxy.stiffness", TEXT("Stiffness"), TEXT("Spring between object and hand.")},
    {"proxy.rotation_stiffness", TEXT("Rotation stiffness"), TEXT("Torsion spring between object and hand.")},
    {"proxy.force", TEXT("Largest force"), TEXT("Limit of the force of the spring.")},
    {"proxy.torque", TEXT("Largest torque"), TEXT("Limit of the torque of the spring.")},
    {"proxy.gap", TEXT("Gap"), TEXT("Distance kept between object and surface.")},
    {"proxy.step", TEXT("Step"), TEXT("Largest displacement of the object in one cycle.")},
    {"admittance.inertia", TEXT("Inertia"), TEXT("Virtual inertia of a joint.")},
    {"admittance.damping", TEXT("Damping"), TEXT("Virtual damper of a joint.")},
    {"admittance.stiffness", TEXT("Stiffness"),
     TEXT("Virtual spring of a joint; 0: it stays where it was pushed.")},
    {"admittance.velocity", TEXT("Largest velocity"), TEXT("Limit of the velocity that is added.")},
    {"admittance.offset", TEXT("Largest offset"), TEXT("Limit of the way from the planned position.")},
    {"speed.reaction_time", TEXT("Reaction time"), TEXT("Of sensor, network and controller together.")},
    {"speed.stopping_time", TEXT("Stopping time"), TEXT("Time that the robot needs to stand.")},
    {"speed.deceleration", TEXT("Deceleration"),
     TEXT("If it is not 0, the stopping time is the speed divided by it.")},
    {"speed.intrusion", TEXT("Intrusion"), TEXT("How far a person intrudes before the sensor sees it.")},
    {"speed.person_error", TEXT("Error of the person"), TEXT("Error of the measured position of a person.")},
    {"speed.robot_error", TEXT("Error of the robot"), TEXT("Error of the position of the robot.")},
    {"speed.person_speed", TEXT("Person's speed"), TEXT("Assumed speed of a walking person.")},
    {"speed.person_speed_near", TEXT("Speed when near"), TEXT("Assumed speed of a person who is near.")},
    {"speed.near", TEXT("Near"), TEXT("Within this distance a person is near.")},
    {"speed.person_acceleration", TEXT("Person's acceleration"),
     TEXT("Largest acceleration of a person; 0: measured speeds are not used.")},
    {"speed.release", TEXT("Release"), TEXT("How fast the share of the speed rises again.")},
    {"speed.least", TEXT("Smallest share"), TEXT("Smaller shares of the planned speed count as 0.")},
    {"braking.deceleration", TEXT("Deceleration"), TEXT("Of a joint while it brakes.")},
    {"braking.reaction_time", TEXT("Reaction time"), TEXT("Until the joints begin to brake.")},
    {"braking.distance", TEXT("Distance"), TEXT("Required distance until the robot stands.")},
    {"braking.person_speed", TEXT("Person's speed"), TEXT("A person moves at most this fast meanwhile.")},
    {"braking.person_acceleration", TEXT("Person's acceleration"),
     TEXT("A person accelerates at most this much meanwhile.")},
    {"hold.frequency", TEXT("Frequency"), TEXT("How fast and how stiffly the robot returns to its plan.")},
    {"hold.damping", TEXT("Damping"), TEXT("Damping ratio of the return; 1: no overshoot.")},
    {"stop.distance", TEXT("Distance"), TEXT("A smaller certified distance stops the robot.")},
    {"stop.input_age", TEXT("Age of joint values"), TEXT("Older joint values stop the robot.")},
    {"stop.person_age", TEXT("Age of a person"), TEXT("An older pose of a person stops the robot.")},
    {"stop.joint_speed", TEXT("Joint speed"), TEXT("A faster joint stops the robot.")},
    {"stop.resume_after", TEXT("Resume after"),
     TEXT("A protective stop ends by itself after this time without a cause; ∞: it waits for a reset.")},
    {"stop.standstill", TEXT("Standstill"), TEXT("A robot stands if no joint is faster.")},
    {"stop.settle", TEXT("Settle"), TEXT("Time of standstill before a reset is accepted.")},
    {"stop.slow_to", TEXT("Slow to"), TEXT("Share of the planned speed while something asks to slow down.")},
};
#undef TEXT

template <std::size_t N>
const LawWords* wordsOf(const LawWords (&table)[N], const std::string& key) {
  const auto* const it =
      std::find_if(std::begin(table), std::end(table), [&](const LawWords& w) { return key == w.key; });
  return it == std::end(table) ? nullptr : it;
}

QString shortestText(double value) {
  if (std::isinf(value)) return value > 0.0 ? QString(kInfinitySign) : QString(kMinusSign) + kInfinitySign;
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  const double size = std::abs(value);
  const bool plain = size == 0.0 || (size >= kSmallestPlain && size < kLargestPlain);
  return locale.toString(value, plain ? 'f' : 'g', QLocale::FloatingPointShortest);
}

QString withUnit(double value, const config::NumberRule& rule) {
  return *rule.unit ? shortestText(value) + QLatin1Char(' ') + unitText(rule.unit) : shortestText(value);
}

}  // namespace

QString lawName(const std::string& law) {
  const LawWords* const words = wordsOf(kLaws, law);
  return words ? tr(words->name) : QString();
}

QString lawMeaning(const std::string& law) {
  const LawWords* const words = wordsOf(kLaws, law);
  return words ? tr(words->meaning) : QString();
}

QString numberName(const std::string& key) {
  const LawWords* const words = wordsOf(kNumbers, key);
  return words ? tr(words->name) : QString();
}

QString numberMeaning(const std::string& key) {
  const LawWords* const words = wordsOf(kNumbers, key);
  return words ? tr(words->meaning) : QString();
}

QString unitText(const char* unit) {
  QString text = QString::fromUtf8(unit).replace(QLatin1String("^2"), QStringLiteral("²"));
  QStringList choices = text.split(QStringLiteral(" or "));
  for (QString& choice : choices) choice.replace(QLatin1Char(' '), QStringLiteral("·"));
  return choices.size() == 2 ? tr("%1 or %2").arg(choices[0], choices[1])
                             : choices.join(QStringLiteral(" / "));
}

QString ruleText(const config::NumberRule& rule, int joints) {
  QString text;
  if (std::isinf(rule.min))
    text = tr("Expected a number up to %1, or −∞ for no limit.").arg(withUnit(rule.max, rule));
  else if (std::isinf(rule.max))
    text = (rule.above ? tr("Expected a number above %1, or ∞ for no limit.")
                       : tr("Expected a number from %1 on, or ∞ for no limit."))
               .arg(withUnit(rule.min, rule));
  else
    text = (rule.above ? tr("Expected a number above %1 and at most %2.")
                       : tr("Expected a number from %1 to %2."))
               .arg(shortestText(rule.min), withUnit(rule.max, rule));
  if (joints > 1) text += QLatin1Char(' ') + tr("Or %1 numbers, one for each joint: 1; 2; …").arg(joints);
  return text;
}

QString numbersText(const config::JointNumbers& numbers) {
  QStringList parts;
  for (const double number : numbers) parts << shortestText(number);
  return parts.join(QStringLiteral("; "));
}

config::JointNumbers numbersFromText(const QString& text) {
  config::JointNumbers numbers;
  static const QRegularExpression kBetween(QStringLiteral("[;\\s]+"));
  for (QString part : text.trimmed().split(kBetween, Qt::SkipEmptyParts)) {
    part.replace(kMinusSign, QLatin1Char('-'));
    const bool below = part.startsWith(QLatin1Char('-'));
    const QString size = below ? part.mid(1) : part;
    if (size == QString(kInfinitySign) || size == QLatin1String("inf")) {
      numbers.push_back(below ? -kInfinity : kInfinity);
      continue;
    }
    const std::optional<double> number = numberFromText(part);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

double steppedNumber(double value, int steps, const config::NumberRule& rule) {
  if (!std::isfinite(value)) return value;
  const double size = value == 0.0 ? kSizeOfZero : std::abs(value);
  const double step = std::pow(10.0, std::floor(std::log10(size)) - 1.0);
  // A whole number of steps, so that what is shown stays short.
  const double next = (std::round(value / step) + steps) * step;
  const double rounded = std::round(next / step) / std::round(1.0 / step);
  const double wanted = step < 1.0 ? rounded : next;
  return rule.allows(wanted) ? wanted : value;
}

}  // namespace abstand::ui
