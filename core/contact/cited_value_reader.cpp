#include "core/contact/cited_value_reader.hpp"

namespace abstand::contact {
namespace {

using config::YamlFields;
using config::YamlNode;
using config::YamlRange;

constexpr double kPascal = 1e4;  // of 1 N/cm^2
constexpr YamlRange kFactorRange{1.0, 10.0};
constexpr YamlRange kPressureRange{0.0, 1e4, "N/cm^2", true};

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

}  // namespace

std::string ticked(const std::string& text) { return "`" + text + "`"; }

std::string needText(const YamlFields& fields, const char* key) {
  return config::yamlText(fields.need(key), fields.file(), ticked(key));
}

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

}  // namespace abstand::contact
