// Limits of contact by body region, as a standard or its user states them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/content_hash.hpp"

namespace abstand::contact {

/// A part of the human model at which contact is excluded in every edition: no table may limit it instead
/// [ISO/TS 15066:2016, A.2: not applicable].
inline constexpr std::string_view kExcludedPart = "head";

/// A number with where it stands.
struct CitedValue {
  double value{0.0};
  std::string source;         ///< edition and table
  std::string to_be_checked;  ///< why somebody should look it up; empty: nothing is known against it
};

/// Permissible quasi-static pressure (Pa) at one place of a region.
struct PressurePlace {
  std::string place;
  CitedValue pressure;
};

/// One row of the table. SI. The sources say edition and table of each number.
struct RegionLimits {
  std::string name;
  std::vector<std::string> parts;          ///< of the human model, covered by the region
  std::vector<std::string> stands_in_for;  ///< parts without a row of their own, judged by this one
  std::string remark;                      ///< may be empty
  CitedValue force;                        ///< N, permissible quasi-static force
  /// Factor of transient contact, for force and pressure. NaN: not applicable, contact must be excluded.
  CitedValue transient;
  std::vector<PressurePlace> pressures;  ///< one at least
  CitedValue spring;                     ///< N/m, effective spring constant K of the region
  CitedValue body_mass;                  ///< kg, effective mass m_H of the region
  std::optional<CitedValue> energy;      ///< J, as stated; only checked against the others

  /// True where contact must be excluded instead of limited.
  bool excluded() const;
  /// Pa: the smallest quasi-static pressure of all places, as it is not known which one is touched.
  double pressure() const;
  bool covers(std::string_view part) const;
  /// True where the standard has no row for the part and this one is used instead.
  bool standsInFor(std::string_view part) const;
};

/// A table of limits. Constant after loading; every function is safe from any thread.
struct ContactLimits {
  std::string title, edition, note, origin;
  std::vector<std::string> to_be_checked;  ///< doubts about the whole table
  std::vector<RegionLimits> regions;       ///< in file order
  std::string file;
  ContentKey content;  ///< of the file's bytes

  /// Null where there is none of this name.
  const RegionLimits* region(std::string_view name) const;
  /// All regions that cover the part or stand in for it; not empty for the parts that the table was loaded
  /// with.
  std::vector<const RegionLimits*> regionsOf(std::string_view part) const;
  /// One line for reports: title, edition, file name, the first 12 digits of the content's hash.
  std::string stamp() const;
  /// What somebody should look up, a line each: "chest, force: ...".
  std::vector<std::string> doubts() const;
};

}  // namespace abstand::contact
