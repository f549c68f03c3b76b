// TRC markers of Motion Analysis and OpenSim: a tab-separated table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tracking/recording/point_reader.hpp"
#include "tracking/table/cells.hpp"

namespace abstand::tracking {

/// True if the text begins with PathFileType.
bool looksLikeTrc(std::string_view text);

/// Marker names are separated by one, two or three tabs, so they are counted, not located by column. An empty
/// cell, `nan` in any case, or a row that ends early is a gap. If a row ends within a marker, an unknown
/// value is missing: all its markers are gaps, with a warning. Values of whole markers after the named ones
/// are ignored with a warning; other surplus values are an error. Markers and frames are those present; a
/// differing stated number is a warning.
class TrcReader : public PointReader {
 public:
  /// `text` must outlive this object. Throws ParseError for the header.
  TrcReader(std::string_view text, std::string file);

  const PointFacts& facts() const override { return facts_; }
  std::span<const std::string> names() const override { return names_; }
  bool next(PointFrame& frame) override;
  std::vector<FileWarning> warnings() const override { return warnings_; }

 private:
  std::string_view need(const char* what);
  void readHead();
  void readNames(std::string_view line);
  void finish();
  void readRow(Cells& cells, PointFrame& frame);

  std::string file_;
  Lines lines_;
  PointFacts facts_;
  std::vector<std::string> names_;
  std::vector<FileWarning> warnings_;
  long long claimed_frames_{-1}, claimed_markers_{-1};
  std::size_t frames_{0};
  double last_t_{0.0};
  /// Line numbers, 0: none. First rows with fewer markers than names, with more, and with a part of a marker.
  int first_short_line_{0}, first_long_line_{0}, first_odd_line_{0};
  bool done_{false};
};

}  // namespace abstand::tracking
