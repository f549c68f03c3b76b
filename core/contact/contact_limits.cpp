#include "core/contact/contact_limits.hpp"

#include <algorithm>
#include <cmath>

#include "core/config/cited_table.hpp"

namespace abstand::contact {
namespace {

bool hasName(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void addDoubt(std::vector<std::string>& doubts, const std::string& what, const CitedValue& value) {
  if (!value.to_be_checked.empty()) doubts.push_back(what + ": " + value.to_be_checked);
}

}  // namespace

bool RegionLimits::excluded() const { return std::isnan(transient.value); }

double RegionLimits::pressure() const {
  return std::min_element(pressures.begin(), pressures.end(),
                          [](const PressurePlace& a, const PressurePlace& b) {
                            return a.pressure.value < b.pressure.value;
                          })
      ->pressure.value;
}

bool RegionLimits::covers(std::string_view part) const { return hasName(parts, part); }

bool RegionLimits::standsInFor(std::string_view part) const { return hasName(stands_in_for, part); }

const RegionLimits* ContactLimits::region(std::string_view name) const {
  for (const RegionLimits& r : regions)
    if (r.name == name) return &r;
  return nullptr;
}

std::vector<const RegionLimits*> ContactLimits::regionsOf(std::string_view part) const {
  std::vector<const RegionLimits*> found;
  for (const RegionLimits& r : regions)
    if (r.covers(part) || r.standsInFor(part)) found.push_back(&r);
  return found;
}

std::string ContactLimits::stamp() const { return config::tableStamp(*this); }

std::vector<std::string> ContactLimits::doubts() const {
  std::vector<std::string> all = to_be_checked;
  for (const RegionLimits& r : regions) {
    addDoubt(all, r.name + ", force", r.force);
    addDoubt(all, r.name + ", transient", r.transient);
    for (const PressurePlace& p : r.pressures) addDoubt(all, r.name + ", pressure, " + p.place, p.pressure);
    addDoubt(all, r.name + ", spring", r.spring);
    addDoubt(all, r.name + ", body_mass", r.body_mass);
    if (r.energy) addDoubt(all, r.name + ", energy", *r.energy);
  }
  return all;
}

}  // namespace abstand::contact
