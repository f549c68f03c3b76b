// The numbers that a user may choose: one table serves checks, files and texts.
#pragma once

#include <string>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::config {

/// Allowed numbers: least <= x <= most, or least < x with `above`. Never NaN.
struct NumberRule {
  double least, most;
  const char* unit{""};
  bool above{false};

  bool allows(double x) const { return x >= least && x <= most && !(above && x <= least); }
  /// "a number from 0 to 10 s".
  std::string text() const;
};

/// Throws UsageError: `OWNER.NAME VALUE: expected ...`.
void requireNumber(const char* owner, const char* name, double value, const NumberRule& rule);

/// A list with one number for all joints or one a joint.
using JointNumbers = std::vector<double>;
/// Throws UsageError for another size than 1 or `dof`, and for numbers that the rule does not allow.
JointNumbers forJoints(const char* owner, const char* name, const JointNumbers& numbers, int dof,
                       const NumberRule& rule);

/// Options with `template <class Self, class Visit> static void eachNumber(Self&, Visit)`, which calls
/// visit(name, member, rule) for every number. Throws UsageError for the first one that is not allowed.
template <class Options>
void requireNumbers(const Options& options) {
  Options::eachNumber(options, [](const char* name, double value, const NumberRule& rule) {
    requireNumber(Options::kName, name, value, rule);
  });
}

}  // namespace abstand::config
