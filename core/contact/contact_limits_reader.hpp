// Reads and validates a table of contact limits from a YAML file.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/contact/contact_limits.hpp"

namespace abstand::contact {

/// Relative tolerance between a stated energy and (force x factor)^2 / (2 K). The edition's table of energies
/// (ISO/TS 15066:2016, A.4) has two digits; its 0.49 J for the hand is 6 % below the value from A.2 and A.3.
/// Using the force of a wrong column is an error by a factor of 2, hence 4 in energy.
inline constexpr double kEnergyTolerance = 0.10;

/// Reads a table; docs/contact.md lists the keys. `parts`: names of the human model's body parts, all of
/// which the table must cover. Throws ParseError with file, line and column for unknown and missing keys,
/// numbers that are not positive and finite, unknown or uncovered parts, an unlisted source, a stated energy
/// inconsistent with force and spring, a factor below 1, and a table that limits contact with the head
/// instead of excluding it.
ContactLimits loadContactLimits(const std::filesystem::path& file, std::span<const std::string_view> parts);

/// The same for a text; `file` is its name in errors.
ContactLimits parseContactLimits(const std::string& text, const std::string& file,
                                 std::span<const std::string_view> parts);

/// The table included with the project: data/standards/iso_ts_15066_2016.yaml.
std::filesystem::path defaultContactLimits();

}  // namespace abstand::contact
