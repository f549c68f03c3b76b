// Contact limits by body region, from a standard or the user.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/content_hash.hpp"
#include "core/config/cited_value.hpp"

namespace abstand::contact {

/// A part of the human model at which contact is always excluded: no table may limit it instead [ISO/TS
/// 15066:2016, A.2: not applicable].
inline constexpr std::string_view kExcludedPart = "head";

using config::CitedValue;

/// Permissible quasi-static pressure (Pa) at one place of a region.
struct PressurePlace {
  std::string place;
  CitedValue pressure;
};

/// One row of the table. SI. Each number has its source (edition and table).
struct RegionLimits {
  std::string name;
  std::vector<std::string> parts;          ///< parts of the human model covered by the region
  std::vector<std::string> stands_in_for;  ///< parts without a row of their own that use this one
  std::string remark;                      ///< optional
  CitedValue force;                        ///< N, permissible quasi-static force
  /// Factor of transient contact for force and pressure. NaN: not applicable, contact must be excluded.
  CitedValue transient;
  std::vector<PressurePlace> pressures;  ///< at least one
  CitedValue spring;                     ///< N/m, effective spring constant K of the region
  CitedValue body_mass;                  ///< kg, effective mass m_H of the region
  std::optional<CitedValue> energy;      ///< J, as stated in the table; only used for consistency checks

  /// True if contact must be excluded instead of limited.
  bool excluded() const;
  /// Pa: smallest quasi-static pressure of all places, as it is unknown which one is touched.
  double pressure() const;
  bool covers(std::string_view part) const;
  /// True if the standard has no row for the part and this one is used instead.
  bool standsInFor(std::string_view part) const;
};

/// Table of contact limits. Constant after loading; every function is thread-safe.
struct ContactLimits {
  std::string title, edition, note, origin;
  std::vector<std::string> to_be_checked;  ///< doubts about the whole table
  std::vector<RegionLimits> regions;       ///< in file order
  std::string file;
  ContentKey content;  ///< of the file's bytes

  /// The region with this name, or null.
  const RegionLimits* region(std::string_view name) const;
  /// All regions that cover the part or stand in for it; never empty for the parts that the table was loaded
  /// with.
  std::vector<const RegionLimits*> regionsOf(std::string_view part) const;
  /// One line for reports: title, edition, file name, the first 12 digits of the content's hash.
  std::string stamp() const;
  /// Values that need checking, one line each: "chest, force: ...".
  std::vector<std::string> doubts() const;
};

}  // namespace abstand::contact
