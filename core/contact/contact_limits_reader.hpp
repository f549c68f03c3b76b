// Reads a table of contact limits from a YAML file, and checks it.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/contact/contact_limits.hpp"

namespace abstand::contact {

/// How far a stated energy may be from (force x factor)^2 / (2 K), relative. The edition's own table of
/// energies (ISO/TS 15066:2016, A.4) is quoted with two digits, and with 0.49 J for the hand, 6 % below what
/// A.2 and A.3 give; the force of a wrong column is off by a factor of 2, so its energy by 4.
inline constexpr double kEnergyTolerance = 0.10;

/// Reads a table; docs/contact.md has the keys. `parts` are the names of the human model's body parts, all of
/// which the table has to cover. Throws ParseError with file, line and column for unknown and missing keys,
/// numbers that are not positive and finite, parts that are unknown or covered by no region, a source that is
/// not listed, a stated energy that does not fit force and spring, a factor below 1, and a table that limits
/// contact with the head instead of excluding it.
ContactLimits loadContactLimits(const std::filesystem::path& file, std::span<const std::string_view> parts);

/// The same for a text; `file` names it in errors.
ContactLimits parseContactLimits(const std::string& text, const std::string& file,
                                 std::span<const std::string_view> parts);

/// The table that the project ships: data/standards/iso_ts_15066_2016.yaml.
std::filesystem::path defaultContactLimits();

}  // namespace abstand::contact
