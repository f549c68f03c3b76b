#include "core/contact/contact_limits_reader.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/data_folder.hpp"
#include "core/base/number.hpp"
#include "core/base/text_file.hpp"
#include "core/config/yaml_reader.hpp"

namespace abstand::contact {
namespace {

using config::YamlFields;
using config::YamlNode;
using config::YamlRange;

constexpr std::uintmax_t kMaxLimitsBytes = 1u << 20;
constexpr const char* kNotApplicable = "not_applicable";
constexpr double kPascal = 1e4;    // of 1 N/cm^2
constexpr double kPerMetre = 1e3;  // N/m of 1 N/mm

constexpr YamlRange kForceRange{0.0, 1e4, "N", true};
constexpr YamlRange kFactorRange{1.0, 10.0};
constexpr YamlRange kPressureRange{0.0, 1e4, "N/cm^2", true};
constexpr YamlRange kSpringRange{0.0, 1e4, "N/mm", true};
constexpr YamlRange kMassRange{0.0, 1e3, "kg", true};
constexpr YamlRange kEnergyRange{0.0, 1e4, "J", true};

/// What every value of a table needs: the file, its sources and the names of body parts.
struct LimitsContext {
  const std::string& file;
  std::vector<std::string> parts;
  std::map<std::string, std::string> sources;
};

std::string ticked(const std::string& text) { return "`" + text + "`"; }

std::string needText(const YamlFields& fields, const char* key) {
  return config::yamlText(fields.need(key), fields.file(), ticked(key));
}

std::vector<std::string> texts(const YamlFields& fields, const char* key) {
  std::vector<std::string> all;
  for (const YamlNode& item : fields.list(key))
    all.push_back(config::yamlText(item, fields.file(), ticked(key)));
  return all;
}

std::string sourceOf(const YamlFields& fields, const LimitsContext& context) {
  const std::string key = needText(fields, "source");
  const auto found = context.sources.find(key);
  if (found != context.sources.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [name, text] : context.sources) known.push_back(name);
  throw ParseError(fields.pos(fields.need("source")),
                   "found the source " + ticked(key) + ", which is not in `sources`",
                   config::nearestHint(key, known));
}

CitedValue cited(const YamlFields& fields, const LimitsContext& context) {
  CitedValue value;
  value.source = sourceOf(fields, context);
  value.to_be_checked = fields.text("to_be_checked").value_or("");
  return value;
}

/// `name: {unit: NUMBER, source: KEY, to_be_checked: TEXT}`, in SI by the factor `si`.
CitedValue quantity(const YamlFields& region, const char* name, const char* unit, const YamlRange& range,
                    double si, const LimitsContext& context) {
  const YamlFields fields(region.need(name), context.file, ticked(name), {unit, "source", "to_be_checked"});
  CitedValue value = cited(fields, context);
  value.value = si * config::yamlNumber(fields.need(unit), context.file, ticked(unit), range);
  return value;
}

CitedValue transientFactor(const YamlFields& region, const LimitsContext& context) {
  const YamlFields fields(region.need("transient"), context.file, "`transient`",
                          {"factor", "source", "to_be_checked"});
  const YamlNode& factor = fields.need("factor");
  CitedValue value = cited(fields, context);
  value.value = factor.text == kNotApplicable
                    ? kNaN
                    : config::yamlNumber(factor, context.file, "`factor`", kFactorRange);
  return value;
}

std::vector<PressurePlace> pressurePlaces(const YamlFields& region, const LimitsContext& context) {
  std::vector<PressurePlace> places;
  for (const YamlNode& node : config::yamlList(region.need("pressure"), context.file, "`pressure`")) {
    const YamlFields fields(node, context.file, "a place of `pressure`",
                            {"place", "n_per_cm2", "source", "to_be_checked"});
    PressurePlace place{needText(fields, "place"), cited(fields, context)};
    place.pressure.value =
        kPascal * config::yamlNumber(fields.need("n_per_cm2"), context.file, "`n_per_cm2`", kPressureRange);
    places.push_back(std::move(place));
  }
  if (places.empty())
    throw ParseError(region.pos(region.need("pressure")),
                     "found an empty list for `pressure`, expected a place");
  return places;
}

std::vector<std::string> partNames(const YamlFields& region, const char* key, const LimitsContext& context) {
  std::vector<std::string> names;
  for (const YamlNode& item : region.list(key))
    names.push_back(config::yamlChoice(item, context.file, ticked(key), context.parts));
  return names;
}

void checkEnergy(const RegionLimits& r, const YamlFields& region) {
  if (!r.energy) return;
  const double force = r.force.value * (r.excluded() ? 1.0 : r.transient.value);
  const double expected = force * force / (2.0 * r.spring.value);
  if (std::abs(r.energy->value - expected) <= kEnergyTolerance * expected) return;
  throw ParseError(region.keyPos("energy"),
                   "found an energy of " + formatDouble(r.energy->value) + " J in region " + ticked(r.name) +
                       ", expected F^2 / (2 K) = " + formatDouble(std::round(expected * 1e4) / 1e4) +
                       " J, as force, factor and spring give it");
}

void checkExcluded(const RegionLimits& r, const YamlFields& region) {
  if (r.excluded() || !(r.covers(kExcludedPart) || r.standsInFor(kExcludedPart))) return;
  throw ParseError(region.keyPos("transient"), "found a transient factor in region " + ticked(r.name) +
                                                   ", which covers the head, expected `" + kNotApplicable +
                                                   "`: contact with the head is excluded, never limited");
}

RegionLimits readRegion(const YamlNode& node, const LimitsContext& context) {
  const YamlFields fields(node, context.file, "a region",
                          {"name", "parts", "stands_in_for", "remark", "force", "transient", "pressure",
                           "spring", "body_mass", "energy"});
  RegionLimits r;
  r.name = needText(fields, "name");
  fields.need("parts");
  r.parts = partNames(fields, "parts", context);
  r.stands_in_for = partNames(fields, "stands_in_for", context);
  r.remark = fields.text("remark").value_or("");
  r.force = quantity(fields, "force", "n", kForceRange, 1.0, context);
  r.transient = transientFactor(fields, context);
  r.pressures = pressurePlaces(fields, context);
  r.spring = quantity(fields, "spring", "n_per_mm", kSpringRange, kPerMetre, context);
  r.body_mass = quantity(fields, "body_mass", "kg", kMassRange, 1.0, context);
  if (fields.find("energy")) r.energy = quantity(fields, "energy", "j", kEnergyRange, 1.0, context);
  checkExcluded(r, fields);
  checkEnergy(r, fields);
  return r;
}

void readSources(const YamlFields& table, LimitsContext& context) {
  const YamlNode& node = table.need("sources");
  if (node.kind != YamlNode::Kind::kMap)
    throw ParseError(table.pos(node), "found " + config::yamlFound(node) + " for `sources`, expected a map");
  for (std::size_t i = 0; i < node.keys.size(); ++i) {
    const YamlFields fields(node.items[i], context.file, "a source", {"edition", "table"});
    context.sources[node.keys[i].text] = needText(fields, "edition") + ", " + needText(fields, "table");
  }
}

void checkCovered(const ContactLimits& limits, const YamlFields& table, const LimitsContext& context) {
  for (const std::string& part : context.parts)
    if (limits.regionsOf(part).empty())
      throw ParseError(table.keyPos("regions"), "found no region that covers the body part " + ticked(part) +
                                                    ", expected one in `parts` or `stands_in_for`");
}

}  // namespace

ContactLimits parseContactLimits(const std::string& text, const std::string& file,
                                 std::span<const std::string_view> parts) {
  const YamlNode root = config::parseYaml(text, file);
  const YamlFields table(root, file, "a table of contact limits",
                         {"title", "edition", "note", "origin", "to_be_checked", "sources", "regions"});
  LimitsContext context{file, {parts.begin(), parts.end()}, {}};
  readSources(table, context);
  ContactLimits limits;
  limits.title = needText(table, "title");
  limits.edition = needText(table, "edition");
  limits.note = table.text("note").value_or("");
  limits.origin = table.text("origin").value_or("");
  limits.to_be_checked = texts(table, "to_be_checked");
  for (const YamlNode& node : config::yamlList(table.need("regions"), file, "`regions`")) {
    RegionLimits region = readRegion(node, context);
    if (limits.region(region.name))
      throw ParseError({file, node.line, node.column},
                       "found the region " + ticked(region.name) + " twice, expected it once");
    limits.regions.push_back(std::move(region));
  }
  checkCovered(limits, table, context);
  limits.file = file;
  ContentHash hash;
  hash.add(text.data(), text.size());
  limits.content = hash.value();
  return limits;
}

ContactLimits loadContactLimits(const std::filesystem::path& file, std::span<const std::string_view> parts) {
  return parseContactLimits(readFile(file, kMaxLimitsBytes), file.string(), parts);
}

std::filesystem::path defaultContactLimits() { return dataFolder() / "standards" / "iso_ts_15066_2016.yaml"; }

}  // namespace abstand::contact
