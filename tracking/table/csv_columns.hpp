// The header of a table of joints: which column holds what.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace abstand::tracking {

inline constexpr int kConfidenceField = 3, kSpreadField = 4;

/// What a column holds: a joint's x, y, z (0 to 2), its confidence or its spread; -1: something else, not
/// read.
struct CsvColumn {
  std::size_t joint{0};
  int field{0};
};

enum class CsvTime : std::uint8_t { kSeconds, kFrames };

struct CsvColumns {
  CsvTime time{CsvTime::kSeconds};  ///< what the first column counts
  std::vector<CsvColumn> columns;   ///< those behind the first
  std::vector<std::string> joints;  ///< in the order of their x
  bool is_canonical{false};         ///< every joint has a canonical name
};

/// True where a line may be such a header: `t`, `time`, `timestamp` or `frame`, then a column that ends with
/// x.
bool looksLikeCsvColumns(std::string_view line);

/// Reads `t,JOINT.x,JOINT.y,JOINT.z[,JOINT.confidence][,JOINT.spread]...`; `_` for `.`, capitals or not; any
/// order. Where most names are canonical ones, all must be. Throws ParseError with the column.
CsvColumns parseCsvColumns(std::string_view line, const std::string& file);

}  // namespace abstand::tracking
