// Exchange format of skeletons: CSV, one line for each frame, canonical joint names.
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

/// Confidences written for the states of a joint, and the smallest one read as tracked. 0 is missing.
inline constexpr double kTrackedConfidence = 1.0, kInferredConfidence = 0.5, kMinTrackedConfidence = 0.75;

/// Header `t,JOINT.x,JOINT.y,JOINT.z,JOINT.confidence,...` for every joint in any frame; then one line for
/// each frame, s and metres, z up, numbers with the digits that read back to the same double. A joint missing
/// in a frame has empty cells and confidence 0. A joint with a known spread in any frame also has a column
/// JOINT.spread, m, 0 if unknown; one with a covariance in any frame columns JOINT.cxx, .cyy, .czz, .cxy,
/// .cxz, .cyz, m^2, empty in frames without one: the error then is isotropic. SkeletonFrame::lateral of a
/// joint is in the columns JOINT.lx, .ly, .lz if it is stated in any frame.
void writeSkeletonCsv(std::ostream& out, const Recording& recording);
/// The same to a file, completely or not at all. Throws UsageError if it cannot be written.
void writeSkeletonCsv(const std::filesystem::path& file, const Recording& recording);

/// True if the first line is such a header.
bool looksLikeSkeletonCsv(std::string_view text);

/// Reads the format of writeSkeletonCsv(), and variants by others: any order of joints, no confidences
/// (tracked), CRLF, empty cells for a gap. With canonical names: metres and z up; with names of a joint map
/// units and up axis are guessed. t increases; or the first column counts frames.
class SkeletonCsvReader : public PointReader {
 public:
  /// `text` must outlive this object. Throws ParseError for the header.
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
