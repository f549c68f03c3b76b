#include "core/contact/contact_limits_reader.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/data_folder.hpp"
#include "core/base/number.hpp"
#include "core/base/text_file.hpp"
#include "core/config/cited_table.hpp"
#include "core/contact/cited_value_reader.hpp"

namespace abstand::contact {
namespace {

using config::ticked;
using config::YamlFields;
using config::YamlNode;
using config::YamlRange;

constexpr std::uintmax_t kMaxLimitsBytes = 1u << 20;
constexpr double kPerMetre = 1e3;  // N/m of 1 N/mm

constexpr YamlRange kForceRange{0.0, 1e4, "N", true};
constexpr YamlRange kSpringRange{0.0, 1e4, "N/mm", true};
constexpr YamlRange kMassRange{0.0, 1e3, "kg", true};
constexpr YamlRange kEnergyRange{0.0, 1e4, "J", true};

/// What a region is read with.
struct LimitsContext {
  config::CitedSources sources;
  std::vector<std::string> parts;  ///< names of the body's parts
};

std::vector<std::string> partNames(const YamlFields& region, const char* key, const LimitsContext& context) {
  std::vector<std::string> names;
  for (const YamlNode& item : region.list(key))
    names.push_back(config::yamlChoice(item, context.sources.file, ticked(key), context.parts));
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
  const YamlFields fields(node, context.sources.file, "a region",
                          {"name", "parts", "stands_in_for", "remark", "force", "transient", "pressure",
                           "spring", "body_mass", "energy"});
  RegionLimits r;
  r.name = config::neededText(fields, "name");
  fields.need("parts");
  r.parts = partNames(fields, "parts", context);
  r.stands_in_for = partNames(fields, "stands_in_for", context);
  r.remark = fields.text("remark").value_or("");
  r.force = config::citedNumber(fields, "force", "n", kForceRange, 1.0, context.sources);
  r.transient = transientFactor(fields, context.sources);
  r.pressures = pressurePlaces(fields, context.sources);
  r.spring = config::citedNumber(fields, "spring", "n_per_mm", kSpringRange, kPerMetre, context.sources);
  r.body_mass = config::citedNumber(fields, "body_mass", "kg", kMassRange, 1.0, context.sources);
  if (fields.find("energy"))
    r.energy = config::citedNumber(fields, "energy", "j", kEnergyRange, 1.0, context.sources);
  checkExcluded(r, fields);
  checkEnergy(r, fields);
  return r;
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
  const LimitsContext context{config::citedSources(table), {parts.begin(), parts.end()}};
  ContactLimits limits;
  config::readTableHead(table, text, limits);
  for (const YamlNode& node : config::yamlList(table.need("regions"), file, "`regions`")) {
    RegionLimits region = readRegion(node, context);
    if (limits.region(region.name))
      throw ParseError({file, node.line, node.column},
                       "found the region " + ticked(region.name) + " twice, expected it once");
    limits.regions.push_back(std::move(region));
  }
  checkCovered(limits, table, context);
  return limits;
}

ContactLimits loadContactLimits(const std::filesystem::path& file, std::span<const std::string_view> parts) {
  return parseContactLimits(readFile(file, kMaxLimitsBytes), file.string(), parts);
}

std::filesystem::path defaultContactLimits() { return dataFolder() / "standards" / "iso_ts_15066_2016.yaml"; }

}  // namespace abstand::contact
