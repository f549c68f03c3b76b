// Numbers of standards, each with its source, as tables in YAML files state them.
#pragma once

#include <map>
#include <string>

#include "core/config/yaml_reader.hpp"

namespace abstand::config {

/// A number with its source.
struct CitedValue {
  double value{0.0};
  std::string source;         ///< edition and table
  std::string to_be_checked;  ///< why the number needs checking; empty: no known doubt
};

/// What the values of a table are read with. All functions below throw ParseError at the position of the
/// error.
struct CitedSources {
  const std::string& file;
  std::map<std::string, std::string> texts;  ///< "edition, table" by key
};

/// `text` in backticks, for messages.
std::string ticked(const std::string& text);

/// Text that must be there.
std::string neededText(const YamlFields& fields, const char* key);

/// Texts of a list; empty if the key is absent.
std::vector<std::string> textList(const YamlFields& fields, const char* key);

/// The table's `sources: {KEY: {edition: TEXT, table: TEXT}, ...}`.
CitedSources citedSources(const YamlFields& table);

/// `{..., source: KEY, to_be_checked: TEXT}`, without its number.
CitedValue citedValue(const YamlFields& fields, const CitedSources& sources);

/// `name: {unit: NUMBER, source: KEY, to_be_checked: TEXT}`, converted to SI by the factor `si`.
CitedValue citedNumber(const YamlFields& row, const char* name, const char* unit, const YamlRange& range,
                       double si, const CitedSources& sources);

}  // namespace abstand::config
