// Reads those values of a table of contact limits that are more than a number.
#pragma once

#include "core/contact/contact_limits.hpp"

namespace abstand::contact {

/// In files: contact must be excluded.
inline constexpr const char* kNotApplicable = "not_applicable";

/// `transient: {factor: NUMBER or not_applicable, source: KEY}`; NaN if not applicable. Throws ParseError at
/// the position of the error.
CitedValue transientFactor(const config::YamlFields& region, const config::CitedSources& sources);

/// `pressure: [{place: TEXT, n_per_cm2: NUMBER, source: KEY}, ...]`, at least one. Throws ParseError as
/// above.
std::vector<PressurePlace> pressurePlaces(const config::YamlFields& region,
                                          const config::CitedSources& sources);

}  // namespace abstand::contact
