// Reads the values of a table of contact limits, each with its source.
#pragma once

#include <map>
#include <string>

#include "core/config/yaml_reader.hpp"
#include "core/contact/contact_limits.hpp"

namespace abstand::contact {

/// In a file: contact must be excluded.
inline constexpr const char* kNotApplicable = "not_applicable";

/// What every value of a table needs: the file, its sources and the names of body parts.
struct LimitsContext {
  const std::string& file;
  std::vector<std::string> parts;
  std::map<std::string, std::string> sources;
};

/// `text` in backticks, for messages.
std::string ticked(const std::string& text);

/// All of these throw ParseError with the place of what is wrong.
std::string needText(const config::YamlFields& fields, const char* key);

/// `name: {unit: NUMBER, source: KEY, to_be_checked: TEXT}`, in SI by the factor `si`.
CitedValue quantity(const config::YamlFields& region, const char* name, const char* unit,
                    const config::YamlRange& range, double si, const LimitsContext& context);

/// `transient: {factor: NUMBER or not_applicable, source: KEY}`; NaN where it is not applicable.
CitedValue transientFactor(const config::YamlFields& region, const LimitsContext& context);

/// `pressure: [{place: TEXT, n_per_cm2: NUMBER, source: KEY}, ...]`, one at least.
std::vector<PressurePlace> pressurePlaces(const config::YamlFields& region, const LimitsContext& context);

}  // namespace abstand::contact
