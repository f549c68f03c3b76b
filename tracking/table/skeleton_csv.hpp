// The plain exchange format for skeletons: one line a frame, canonical joint names.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

#include "tracking/recording/point_reader.hpp"
#include "tracking/recording/recording.hpp"
#include "tracking/table/cells.hpp"
#include "tracking/table/csv_columns.hpp"

namespace abstand::tracking {

/// Confidences that are written for the states of a joint, and the least that is read as tracked. 0 is
/// missing.
inline constexpr double kTrackedConfidence = 1.0, kInferredConfidence = 0.5, kMinTrackedConfidence = 0.75;

/// Header `t,JOINT.x,JOINT.y,JOINT.z,JOINT.confidence,...` for every joint that some frame has; then one line
/// a frame, s and metres, z up, each number with the digits that read back the same double. A joint that is
/// missing in a frame has empty cells and confidence 0. A joint whose spread is known in some frame has a
/// column JOINT.spread too, m, 0 where it is not known.
void writeSkeletonCsv(std::ostream& out, const Recording& recording);
/// The same into a file, whole or not at all. Throws UsageError when it cannot be written.
void writeSkeletonCsv(const std::filesystem::path& file, const Recording& recording);

/// True where the first line is such a header.
bool looksLikeSkeletonCsv(std::string_view text);

/// Reads what writeSkeletonCsv writes, and what others write in that form: any order of the joints, no
/// confidences (then tracked), CRLF, empty cells for a gap. With canonical names it is metres and z up; with
/// the names of a joint map, units and up are guessed. t rises; or the first column counts frames.
class SkeletonCsvReader : public PointReader {
 public:
  /// `text` must outlive this. Throws ParseError for the header.
  SkeletonCsvReader(std::string_view text, std::string file);

  const PointFacts& facts() const override { return facts_; }
  std::span<const std::string> names() const override { return head_.joints; }
  bool next(PointFrame& frame) override;

 private:
  void parsePoints(Cells& cells, PointFrame& frame);

  std::string file_;
  Lines lines_;
  CsvColumns head_;
  PointFacts facts_;
  std::vector<double> confidence_;
  std::size_t frames_{0};
  double last_t_{0.0};
};

/// Reads a whole table. Throws ParseError with line and column.
Recording readSkeletonCsv(std::string_view text, const std::string& file,
                          const RecordingOptions& options = {});

}  // namespace abstand::tracking
