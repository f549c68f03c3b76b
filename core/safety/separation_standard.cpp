#include "core/safety/separation_standard.hpp"

#include <algorithm>
#include <array>

#include "core/base/data_folder.hpp"
#include "core/base/text_file.hpp"
#include "core/config/cited_table.hpp"

namespace abstand::safety {
namespace {

using config::YamlFields;

constexpr std::uintmax_t kMaxTableBytes = 1u << 20;
constexpr std::array kOfAnEdition{"person_speed", "person_speed_near", "near"};

/// "m/s^2" as a key: "m_per_s2".
std::string unitKey(std::string unit) {
  const auto slash = unit.find('/');
  if (slash != std::string::npos) unit.replace(slash, 1, "_per_");
  std::erase(unit, '^');
  return unit;
}

std::vector<std::string> termKeys() {
  std::vector<std::string> keys;
  const SeparationOptions options;
  SeparationOptions::eachNumber(
      options, [&](const char* key, const double&, const config::NumberRule&) { keys.emplace_back(key); });
  return keys;
}

std::vector<SeparationStandard::Term> readTerms(const YamlFields& table,
                                                const config::CitedSources& sources) {
  const YamlFields rows(table.need("terms"), table.file(), "`terms`", termKeys());
  for (const char* key : kOfAnEdition) rows.need(key);
  std::vector<SeparationStandard::Term> terms;
  const SeparationOptions options;
  SeparationOptions::eachNumber(options, [&](const char* key, const double&, const config::NumberRule& rule) {
    if (!rows.find(key)) return;
    const config::YamlRange range{rule.min, rule.max, rule.unit, rule.above};
    terms.push_back({key, config::citedNumber(rows, key, unitKey(rule.unit).c_str(), range, 1.0, sources)});
  });
  return terms;
}

}  // namespace

const SeparationStandard::Term* SeparationStandard::term(const std::string& key) const {
  const auto at = std::find_if(terms.begin(), terms.end(), [&](const Term& t) { return t.key == key; });
  return at == terms.end() ? nullptr : &*at;
}

SeparationOptions SeparationStandard::options() const {
  SeparationOptions options;
  SeparationOptions::eachNumber(options, [&](const char* key, double& value, const config::NumberRule&) {
    if (const Term* stated = term(key)) value = stated->cited.value;
  });
  return options;
}

std::string SeparationStandard::stamp() const { return config::tableStamp(*this); }

SeparationStandard parseSeparationStandard(const std::string& text, const std::string& file) {
  const config::YamlNode root = config::parseYaml(text, file);
  const YamlFields fields(root, file, "a table of the protective distance",
                          {"title", "edition", "note", "origin", "to_be_checked", "sources", "terms"});
  SeparationStandard table;
  config::readTableHead(fields, text, table);
  table.terms = readTerms(fields, config::citedSources(fields));
  return table;
}

SeparationStandard loadSeparationStandard(const std::filesystem::path& file) {
  return parseSeparationStandard(readFile(file, kMaxTableBytes), file.string());
}

std::filesystem::path defaultSeparationTable() { return dataFolder() / "standards" / "iso_13855_2010.yaml"; }

}  // namespace abstand::safety
