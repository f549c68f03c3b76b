// Kinect v2 skeletons in the format of IntelliRehabDS: a line for each joint (csv) or frame (txt).
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "tracking/recording/point_reader.hpp"
#include "tracking/table/cells.hpp"

namespace abstand::tracking {

/// True if the first line has the columns JointName and TrackingStatus.
bool looksLikeIrdsCsv(std::string_view text);
/// True if the text begins with "Version0." and a digit.
bool looksLikeIrdsText(std::string_view text);

/// Reads both forms. Lines with the same three integers of a time stamp are one frame. The third one counts
/// milliseconds and must increase from frame to frame. Metres; x to the right of a person who faces the
/// camera, y up, z away from it.
class IrdsReader : public PointReader {
 public:
  /// `text` must outlive this object. Throws ParseError for the header.
  IrdsReader(std::string_view text, std::string file);

  const PointFacts& facts() const override { return facts_; }
  std::span<const std::string> names() const override;
  bool next(PointFrame& frame) override;

 private:
  using Stamp = std::array<long long, 3>;
  /// Indices of the columns of the csv that are read.
  struct Columns {
    std::size_t stamp[3], joint, state, p[3], count;
  };

  void readColumns(std::string_view line);
  bool nextLine();
  bool nextOfTable(PointFrame& frame);
  bool nextOfText(PointFrame& frame);
  Stamp readStamp(std::span<const std::string_view> cells) const;
  void begin(const Stamp& stamp, PointFrame& frame);
  void setJoint(std::string_view name, std::string_view state, std::span<const std::string_view> p,
                PointFrame& frame) const;
  SourcePos pos() const { return {file_, lines_.number()}; }

  std::string file_;
  PointFacts facts_;
  Lines lines_;
  bool is_text_;
  Columns columns_{};
  std::string_view line_;
  bool has_line_{false};
  std::size_t frames_{0};
  double last_t_{0.0};
};

}  // namespace abstand::tracking
