#include "app/tune/stored_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "app/tune/line_fields.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand::tune {
namespace {

constexpr std::size_t kValues = 5;                      // force, factor, pressure, spring, mass
constexpr std::size_t kRegionFields = 2 + 3 * kValues;  // name, place of the pressure; value, source, doubt

const contact::PressurePlace& smallestPressure(const contact::RegionLimits& r) {
  return *std::min_element(r.pressures.begin(), r.pressures.end(),
                           [](const auto& a, const auto& b) { return a.pressure.value < b.pressure.value; });
}

}  // namespace

std::vector<contact::RegionLimits> occurringRegions(const PassResult& pass,
                                                    const contact::ContactLimits& limits) {
  std::set<std::string> names(pass.regions.begin(), pass.regions.end());
  for (const Approach& a : pass.approaches) names.insert(a.contact.region);
  std::vector<contact::RegionLimits> regions;
  for (const contact::RegionLimits& region : limits.regions)
    if (names.contains(region.name)) {
      regions.push_back(region);
      regions.back().pressures = {smallestPressure(region)};
    }
  return regions;
}

std::vector<contact::RegionLimits> occurringRegions(const std::vector<TunedRecording>& recordings) {
  std::vector<contact::RegionLimits> regions;
  std::set<std::string> names;
  for (const TunedRecording& r : recordings)
    for (const contact::RegionLimits& region : r.regions)
      if (names.insert(region.name).second) regions.push_back(region);
  std::sort(regions.begin(), regions.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return regions;
}

std::string regionLine(const contact::RegionLimits& r) {
  const contact::PressurePlace& place = smallestPressure(r);
  std::string line = fieldText(r.name) + "\t" + fieldText(place.place);
  for (const contact::CitedValue* v : {&r.force, &r.transient, &place.pressure, &r.spring, &r.body_mass})
    line += "\t" + (std::isnan(v->value) ? std::string() : formatDouble(v->value)) + "\t" +
            fieldText(v->source) + "\t" + fieldText(v->to_be_checked);
  return line;
}

contact::RegionLimits regionOf(const std::string& line, const std::string& file) {
  const std::vector<std::string> fields = fieldsOf(line);
  if (fields.size() != kRegionFields)
    throw ParseError({file}, "found damaged contact limits of a region, expected " +
                                 std::to_string(kRegionFields) + " fields");
  contact::RegionLimits r;
  r.name = fields[0];
  std::array<contact::CitedValue, kValues> values;
  for (std::size_t i = 0; i < kValues; ++i) {
    const std::string* field = &fields[2 + 3 * i];
    const bool excluded = i == 1 && field[0].empty();
    const auto value = excluded ? std::optional(kNaN) : parseDouble(field[0]);
    if (!value || (!excluded && !(*value > 0.0 && std::isfinite(*value))))
      throw ParseError({file}, "found '" + field[0] + "' in the contact limits of region '" + r.name +
                                   "', expected a number above 0");
    values[i] = {*value, field[1], field[2]};
  }
  r.force = values[0], r.transient = values[1], r.spring = values[3], r.body_mass = values[4];
  r.pressures = {{fields[1], values[2]}};
  return r;
}

std::optional<JudgedContact> judgedContact(const TunedRecording& recording, const Approach& approach) {
  const ContactShare& c = approach.contact;
  const auto region = std::find_if(recording.regions.begin(), recording.regions.end(),
                                   [&](const auto& r) { return r.name == c.region; });
  if (c.region.empty() || region == recording.regions.end()) return std::nullopt;
  JudgedContact judged{*region, {}, 0.0};
  judged.contact = contact::predictContact(
      *region, {c.closing, {c.robot_mass, contact::RobotMassSource::kPosture}, c.kind});
  if (!judged.contact.excluded)
    judged.allowed_pressure =
        region->pressure() * (c.kind == contact::ContactKind::kTransient ? region->transient.value : 1.0);
  return judged;
}

}  // namespace abstand::tune
