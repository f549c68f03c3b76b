#include "core/contact/cited_value_reader.hpp"

namespace abstand::contact {
namespace {

using config::ticked;
using config::YamlFields;
using config::YamlNode;
using config::YamlRange;

constexpr double kPascal = 1e4;  // of 1 N/cm^2
constexpr YamlRange kFactorRange{1.0, 10.0};
constexpr YamlRange kPressureRange{0.0, 1e4, "N/cm^2", true};

}  // namespace

CitedValue transientFactor(const YamlFields& region, const config::CitedSources& sources) {
  const YamlFields fields(region.need("transient"), sources.file, "`transient`",
                          {"factor", "source", "to_be_checked"});
  const YamlNode& factor = fields.need("factor");
  CitedValue value = config::citedValue(fields, sources);
  value.value = factor.text == kNotApplicable
                    ? kNaN
                    : config::yamlNumber(factor, sources.file, "`factor`", kFactorRange);
  return value;
}

std::vector<PressurePlace> pressurePlaces(const YamlFields& region, const config::CitedSources& sources) {
  std::vector<PressurePlace> places;
  for (const YamlNode& node : config::yamlList(region.need("pressure"), sources.file, "`pressure`")) {
    const YamlFields fields(node, sources.file, "a place of `pressure`",
                            {"place", "n_per_cm2", "source", "to_be_checked"});
    PressurePlace place{config::neededText(fields, "place"), config::citedValue(fields, sources)};
    place.pressure.value =
        kPascal * config::yamlNumber(fields.need("n_per_cm2"), sources.file, "`n_per_cm2`", kPressureRange);
    places.push_back(std::move(place));
  }
  if (places.empty())
    throw ParseError(region.pos(region.need("pressure")),
                     "found an empty list for `pressure`, expected a place");
  return places;
}

}  // namespace abstand::contact
