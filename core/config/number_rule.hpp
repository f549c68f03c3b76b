// Valid ranges of user options: one table is used by checks, readers and messages.
#pragma once

#include <string>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::config {

/// Allowed range: least <= x <= most, or least < x <= most with `above`. Never NaN.
struct NumberRule {
  double min, max;
  const char* unit{""};
  bool above{false};

  bool allows(double x) const { return x >= min && x <= max && !(above && x <= min); }
  /// The rule in words, e.g. "a number from 0 to 10 s".
  std::string text() const;
};

/// Throws UsageError: `OWNER.NAME VALUE: expected ...`.
void requireNumber(const char* owner, const char* name, double value, const NumberRule& rule);

/// One number for all joints, or one for each joint.
using JointNumbers = std::vector<double>;
/// Expands to `dof` numbers. Throws UsageError for a size other than 1 or `dof`, and for numbers outside of
/// the rule.
JointNumbers forJoints(const char* owner, const char* name, const JointNumbers& numbers, int dof,
                       const NumberRule& rule);

/// Checks options that define `template <class Self, class Visit> static void eachNumber(Self&, Visit)`,
/// which calls visit(name, member, rule) for every number. Throws UsageError for the first number outside of
/// its rule.
template <class Options>
void requireNumbers(const Options& options) {
  Options::eachNumber(options, [](const char* name, double value, const NumberRule& rule) {
    requireNumber(Options::kName, name, value, rule);
  });
}

/// Calls visit(name, value) for every number of such options that is not the default one.
template <class Options, class Visit>
void eachChangedNumber(const Options& options, Visit visit) {
  const Options usual;
  std::vector<double> defaults;
  Options::eachNumber(usual,
                      [&](const char*, double value, const NumberRule&) { defaults.push_back(value); });
  std::size_t i = 0;
  Options::eachNumber(options, [&](const char* name, double value, const NumberRule&) {
    if (value != defaults[i++]) visit(name, value);
  });
}

}  // namespace abstand::config
