// Abstand's own compact binary format of recordings.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

#include "tracking/recording/point_reader.hpp"
#include "tracking/recording/recording.hpp"

namespace abstand::tracking {

/// m; positions are stored in whole micrometres, with an error of at most 0.5 um.
inline constexpr double kCompactStep = 1e-6;

/// Writes canonical joints; README.md in this folder describes the layout. Throws UsageError for a position
/// beyond 1e6 m. The overload for a path writes the file completely or not at all.
void writeCompact(std::ostream& out, const Recording& recording);
void writeCompact(const std::filesystem::path& file, const Recording& recording);

/// True if the bytes begin with "ABSTREC1".
bool looksLikeCompact(std::string_view bytes);

/// Reads the format of writeCompact(). A truncated file gives its complete frames, with a warning.
class CompactReader : public PointReader {
 public:
  /// `bytes` must outlive this object. Throws ParseError with the offset.
  CompactReader(std::string_view bytes, std::string file);

  const PointFacts& facts() const override { return facts_; }
  std::span<const std::string> names() const override { return names_; }
  bool next(PointFrame& frame) override;
  std::vector<FileWarning> warnings() const override { return warnings_; }

 private:
  [[noreturn]] void fail(const std::string& message) const;
  bool readByte(std::uint8_t& value);
  bool readDifference(std::int64_t& value);
  bool readFrame(PointFrame& frame, std::uint8_t mark);
  bool readSpread(double& spread);
  bool readAxis(Eigen::Vector3f& axis);
  void readEnd();

  std::string_view bytes_;
  std::string file_;
  PointFacts facts_;
  std::vector<std::string> names_;
  std::vector<FileWarning> warnings_;
  std::vector<std::array<std::int64_t, 3>> last_;
  std::size_t at_{0}, frames_{0};
  double last_t_{0.0};
  bool done_{false};
};

}  // namespace abstand::tracking
