// Kinect v2 skeletons as IntelliRehabDS stores them: a line a joint (csv) or a line a frame (txt).
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "tracking/recording/point_reader.hpp"
#include "tracking/table/cells.hpp"

namespace abstand::tracking {

/// True where the first line names the columns JointName and TrackingStatus.
bool looksLikeIrdsCsv(std::string_view text);
/// True where the text begins with "Version0." and a digit.
bool looksLikeIrdsText(std::string_view text);

/// Both forms. The three integers of a time stamp are kept together: lines with the same three are one frame.
/// The third counts milliseconds; it must rise from frame to frame. Metres; x to the right of a person who
/// faces the camera, y up, z away from it.
class IrdsReader : public PointReader {
 public:
  /// `text` must outlive this. Throws ParseError for the head.
  IrdsReader(std::string_view text, std::string file);

  const PointFacts& facts() const override { return facts_; }
  std::span<const std::string> names() const override;
  bool next(PointFrame& frame) override;

 private:
  using Stamp = std::array<long long, 3>;
  /// Where the columns that are read stand in a line of the csv.
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
