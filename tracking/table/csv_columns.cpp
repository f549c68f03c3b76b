#include "tracking/table/csv_columns.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "core/base/error.hpp"
#include "core/text/message_text.hpp"
#include "humanmodel/joints.hpp"
#include "tracking/table/cells.hpp"

namespace abstand::tracking {
namespace {

struct Named {
  std::string_view joint;
  int field{-1};
};

/// Splits "neck.x" or "neck_x"; field -1 if it has no such suffix.
Named splitName(std::string_view cell) {
  const auto dot = cell.find_last_of("._");
  if (dot == std::string_view::npos || dot == 0) return {cell, -1};
  const std::string field = text::lowerCase(cell.substr(dot + 1));
  for (std::size_t k = 0; k < kCovarianceColumns.size(); ++k)
    if (field == kCovarianceColumns[k].name)
      return {cell.substr(0, dot), kCovarianceField + static_cast<int>(k)};
  for (std::size_t k = 0; k < kLateralColumns.size(); ++k)
    if (field == kLateralColumns[k]) return {cell.substr(0, dot), kLateralField + static_cast<int>(k)};
  const int f = field == "x"            ? 0
                : field == "y"          ? 1
                : field == "z"          ? 2
                : field == "confidence" ? kConfidenceField
                : field == "spread"     ? kSpreadField
                                        : -1;
  return {cell.substr(0, dot), f};
}

std::optional<CsvTime> timeOf(std::string_view cell) {
  const std::string name = text::lowerCase(cell);
  if (name == "t" || name == "time" || name == "timestamp") return CsvTime::kSeconds;
  if (name == "frame") return CsvTime::kFrames;
  return std::nullopt;
}

std::vector<std::string> canonicalNames() {
  std::vector<std::string> names;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    names.emplace_back(humanmodel::jointName(static_cast<humanmodel::Joint>(j)));
  return names;
}

/// True if most names are canonical or have a typing error in one.
bool meansCanonical(const std::vector<std::string>& joints) {
  const auto known = canonicalNames();
  const auto near = std::count_if(joints.begin(), joints.end(), [&](const std::string& name) {
    return name == text::lowerCase(name) && !nearestName(name, known).empty();
  });
  return 2 * static_cast<std::size_t>(near) > joints.size();
}

}  // namespace

bool looksLikeCsvColumns(std::string_view line) {
  const std::string file;
  Cells cells(line, file, 1);
  std::string_view cell;
  if (!cells.next(cell) || !timeOf(cell)) return false;
  while (cells.next(cell))
    if (splitName(cell).field == 0) return true;
  return false;
}

CsvColumns parseCsvColumns(std::string_view line, const std::string& file) {
  CsvColumns out;
  Cells cells(line, file, 1);
  std::string_view cell;
  cells.next(cell);
  const auto time = timeOf(cell);
  if (!time) throw ParseError(cells.pos(), "found " + text::inQuotes(cell) + ", expected the column 't'");
  out.time = *time;

  std::vector<std::array<bool, kFields>> seen;
  std::vector<SourcePos> places;
  std::unordered_map<std::string, std::size_t> index;
  while (cells.next(cell)) {
    const Named named = splitName(cell);
    if (named.field < 0)
      throw ParseError(cells.pos(), "found the column " + text::inQuotes(cell) +
                                        ", expected JOINT.x, .y, .z, .confidence, .spread, .cxx to .cyz "
                                        "or .lx to .lz");
    const auto [at, is_new] = index.emplace(std::string(named.joint), out.joints.size());
    if (is_new) {
      out.joints.emplace_back(named.joint);
      seen.push_back({});
      places.push_back(cells.pos());
    }
    bool& had = seen[at->second][static_cast<std::size_t>(named.field)];
    if (had)
      throw ParseError(cells.pos(),
                       "found the column " + text::inQuotes(cell) + " a second time, expected it once");
    had = true;
    out.columns.push_back({at->second, named.field});
  }
  if (out.joints.empty()) throw ParseError({file, 1}, "found no joint, expected JOINT.x, JOINT.y, JOINT.z");

  out.is_canonical = meansCanonical(out.joints);
  for (std::size_t j = 0; j < out.joints.size(); ++j) {
    if (out.is_canonical && !humanmodel::parseJoint(out.joints[j])) {
      const auto near = nearestName(out.joints[j], canonicalNames());
      throw ParseError(
          places[j],
          "found the joint " + text::inQuotes(out.joints[j]) + ", expected one of docs/recordings.md",
          near.empty() ? "" : "did you mean '" + near + "'?");
    }
    const auto covariances =
        std::count(seen[j].begin() + kCovarianceField, seen[j].begin() + kLateralField, true);
    const auto laterals = std::count(seen[j].begin() + kLateralField, seen[j].end(), true);
    out.has_laterals |= laterals != 0;
    if (laterals != 0 && laterals != kFields - kLateralField)
      throw ParseError({file, 1}, "found only some columns of the y axis that ends at " + out.joints[j] +
                                      ", expected .lx, .ly and .lz");
    out.has_covariances |= covariances != 0;
    if (covariances != 0 && (covariances != kLateralField - kCovarianceField || !seen[j][kSpreadField]))
      throw ParseError({file, 1}, "found only some columns of the covariance of " + out.joints[j] +
                                      ", expected .spread, .cxx, .cyy, .czz, .cxy, .cxz and .cyz");
    if (!seen[j][0] || !seen[j][1] || !seen[j][2])
      throw ParseError({file, 1}, "found only some columns of " + out.joints[j] + ", expected .x, .y and .z");
  }
  return out;
}

}  // namespace abstand::tracking
