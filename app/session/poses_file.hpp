// Recorded poses of named objects (`--poses`).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::session {

/// The table of a `--poses` CSV: header `t,NAME.r00,NAME.r01,NAME.r02,NAME.tx,NAME.r10,...,NAME.tz,...`; one
/// row a frame. A pose that is not finite or no rotation is kept as it is written: the scene refuses and
/// flags it.
struct PosesTable {
  std::vector<std::string> names;
  std::vector<double> t;        ///< s, strictly rising
  std::vector<Transform> X_WB;  ///< row-major: frame, then name

  /// Index of the row at or just before t; the first row before the beginning.
  std::size_t rowAt(double time) const;
  const Transform& pose(std::size_t row, std::size_t name) const { return X_WB[row * names.size() + name]; }
};

/// Throws ParseError with line and column.
PosesTable loadPoses(const std::filesystem::path& file);

}  // namespace abstand::session
