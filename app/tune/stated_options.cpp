#include "app/tune/stated_options.hpp"

#include <algorithm>
#include <map>

namespace abstand::tune {
namespace {

std::map<std::string, double> numbersByName(const TuneOptions& o) {
  std::map<std::string, double> numbers{{"limit", o.pass.limit},
                                        {"reaction_time", o.pass.braking.reaction_time},
                                        {"deceleration", o.pass.braking.deceleration},
                                        {"restart_time", o.restart_time},
                                        {"near", o.pass.near},
                                        {"calibration_error", o.pass.calibration_error},
                                        {"latency", o.pass.latency}};
  safety::SeparationOptions::eachNumber(o.pass.separation,
                                        [&](const char* key, const double& v, const config::NumberRule&) {
                                          numbers[std::string("separation.") + key] = v;
                                        });
  return numbers;
}

}  // namespace

std::vector<std::string> assumptionNames() {
  std::vector<std::string> names;
  for (const auto& [name, value] : numbersByName({})) names.push_back(name);
  return names;
}

bool isStated(const TuneOptions& options, const std::string& name) {
  if (std::find(options.stated.begin(), options.stated.end(), name) != options.stated.end()) return true;
  const auto numbers = numbersByName(options), defaults = numbersByName({});
  const auto value = numbers.find(name);
  return value != numbers.end() && value->second != defaults.at(name);
}

}  // namespace abstand::tune
