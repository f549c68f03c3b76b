// Recorded poses of named objects (`--poses`).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::session {

/// Table of a `--poses` CSV file: header `t,NAME.r00,NAME.r01,NAME.r02,NAME.tx,NAME.r10,...,NAME.tz,...`; one
/// row for each frame. Poses that are not finite or not rotations are kept: the scene rejects and flags them.
struct PosesTable {
  std::vector<std::string> names;
  std::vector<double> t;        ///< s, strictly increasing
  std::vector<Transform> X_WB;  ///< row-major: frame, then name

  /// Index of the row at or just before `time`; the first row for earlier times.
  std::size_t rowAt(double time) const;
  const Transform& pose(std::size_t row, std::size_t name) const { return X_WB[row * names.size() + name]; }
};

/// Throws ParseError with line and column.
PosesTable loadPoses(const std::filesystem::path& file);

}  // namespace abstand::session
