// Header of a table of joints: content of its columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace abstand::tracking {

inline constexpr int kConfidenceField = 3, kSpreadField = 4;

/// Content of a column: a joint's x, y, z (0 to 2), its confidence or its spread; -1: ignored.
struct CsvColumn {
  std::size_t joint{0};
  int field{0};
};

enum class CsvTime : std::uint8_t { kSeconds, kFrames };

struct CsvColumns {
  CsvTime time{CsvTime::kSeconds};  ///< unit of the first column
  std::vector<CsvColumn> columns;   ///< those after the first
  std::vector<std::string> joints;  ///< in the order of their x columns
  bool is_canonical{false};         ///< every joint has a canonical name
};

/// True if a line may be such a header: `t`, `time`, `timestamp` or `frame`, then a column that ends with x.
bool looksLikeCsvColumns(std::string_view line);

/// Parses `t,JOINT.x,JOINT.y,JOINT.z[,JOINT.confidence][,JOINT.spread]...`; `_` for `.` is accepted, any
/// case, any order. If most names are canonical, all must be. Throws ParseError with the column.
CsvColumns parseCsvColumns(std::string_view line, const std::string& file);

}  // namespace abstand::tracking
