#include "core/config/number_rule.hpp"

#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand::config {
namespace {

std::string place(const char* owner, const char* name) { return std::string(owner) + "." + name; }

}  // namespace

std::string NumberRule::text() const {
  const std::string u = *unit ? std::string(" ") + unit : "";
  return std::string("a number ") + (above ? "above " : "from ") + formatDouble(min) +
         (above ? " and at most " : " to ") + formatDouble(max) + u;
}

void requireNumber(const char* owner, const char* name, double value, const NumberRule& rule) {
  if (rule.allows(value)) return;
  throw UsageError(place(owner, name) + " " + formatDouble(value) + ": expected " + rule.text());
}

JointNumbers forJoints(const char* owner, const char* name, const JointNumbers& numbers, int dof,
                       const NumberRule& rule) {
  for (const double x : numbers) requireNumber(owner, name, x, rule);
  const auto n = static_cast<std::size_t>(dof);
  if (numbers.size() == 1) return JointNumbers(n, numbers.front());
  if (numbers.size() == n) return numbers;
  throw UsageError(place(owner, name) + ": found " + std::to_string(numbers.size()) +
                   " numbers, expected one, or one for each of " + std::to_string(dof) + " joints");
}

}  // namespace abstand::config
