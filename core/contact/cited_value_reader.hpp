// Reads the values of a table of contact limits with their sources.
#pragma once

#include <map>
#include <string>

#include "core/config/yaml_reader.hpp"
#include "core/contact/contact_limits.hpp"

namespace abstand::contact {

/// In files: contact must be excluded.
inline constexpr const char* kNotApplicable = "not_applicable";

/// Context for reading a value: file, sources and names of body parts.
struct LimitsContext {
  const std::string& file;
  std::vector<std::string> parts;
  std::map<std::string, std::string> sources;
};

/// `text` in backticks, for messages.
std::string ticked(const std::string& text);

/// All of these throw ParseError at the position of the error.
std::string needText(const config::YamlFields& fields, const char* key);

/// `name: {unit: NUMBER, source: KEY, to_be_checked: TEXT}`, converted to SI by the factor `si`.
CitedValue quantity(const config::YamlFields& region, const char* name, const char* unit,
                    const config::YamlRange& range, double si, const LimitsContext& context);

/// `transient: {factor: NUMBER or not_applicable, source: KEY}`; NaN if not applicable.
CitedValue transientFactor(const config::YamlFields& region, const LimitsContext& context);

/// `pressure: [{place: TEXT, n_per_cm2: NUMBER, source: KEY}, ...]`, at least one.
std::vector<PressurePlace> pressurePlaces(const config::YamlFields& region, const LimitsContext& context);

}  // namespace abstand::contact
