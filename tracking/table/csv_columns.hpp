// Header of a table of joints: content of its columns.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace abstand::tracking {

inline constexpr int kConfidenceField = 3, kSpreadField = 4, kCovarianceField = 5, kLateralField = 11,
                     kFields = 14;

/// Columns of a covariance (m^2) from kCovarianceField on, and their row and column in the matrix.
struct CovarianceColumn {
  std::string_view name;
  int row, column;
};
inline constexpr std::array<CovarianceColumn, 6> kCovarianceColumns{
    {{"cxx", 0, 0}, {"cyy", 1, 1}, {"czz", 2, 2}, {"cxy", 0, 1}, {"cxz", 0, 2}, {"cyz", 1, 2}}};

/// Columns of SkeletonFrame::lateral, from kLateralField on.
inline constexpr std::array<std::string_view, 3> kLateralColumns{"lx", "ly", "lz"};

/// Content of a column: a joint's x, y, z (0 to 2), its confidence, its spread, an element of its covariance
/// or of the y axis of the part that ends at it; -1: ignored.
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
  bool has_covariances{false};      ///< of any joint
  bool has_laterals{false};         ///< likewise
};

/// True if a line may be such a header: `t`, `time`, `timestamp` or `frame`, then a column that ends with x.
bool looksLikeCsvColumns(std::string_view line);

/// Parses `t,JOINT.x,JOINT.y,JOINT.z[,JOINT.confidence][,JOINT.spread[,JOINT.cxx,...]][,JOINT.lx,...]...`;
/// `_` for `.` is accepted, any case, any order. A joint has all columns of a covariance, and its spread, or
/// none, and all of .lx, .ly and .lz or none. If most names are canonical, all must be. Throws ParseError
/// with the column.
CsvColumns parseCsvColumns(std::string_view line, const std::string& file);

}  // namespace abstand::tracking
