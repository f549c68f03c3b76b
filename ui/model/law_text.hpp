// Laws of a robot's reaction and their numbers in words.
#pragma once

#include <QString>

#include "core/control/reaction_change.hpp"

namespace abstand::ui {

/// "Repulsion" of "repulsion"; empty for a name that is not known.
QString lawName(const std::string& law);
/// What the law does, in a sentence.
QString lawMeaning(const std::string& law);
/// "Range" of "repulsion.range"; empty for a key that is not known.
QString numberName(const std::string& key);
/// What the number means, in a sentence.
QString numberMeaning(const std::string& key);
/// "rad/s² or m/s²" of a rule's unit.
QString unitText(const char* unit);
/// "Expected a number from 0 to 10 m." For `joints` above 1: or one for each joint.
QString ruleText(const config::NumberRule& rule, int joints);
/// Numbers as they are typed: "0.5", "1; 2; ∞"; ∞: no limit.
QString numbersText(const config::JointNumbers& numbers);
/// The inverse, with decimal point or comma; empty: not numbers.
config::JointNumbers numbersFromText(const QString& text);
/// The next number up or down for an arrow key: a tenth of the leading decimal place, within the rule.
double steppedNumber(double value, int steps, const config::NumberRule& rule);

}  // namespace abstand::ui
