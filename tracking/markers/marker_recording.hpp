// From markers of a file to joints of a person: selects the set, collects positions, solves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tracking/markers/marker_set.hpp"
#include "tracking/recording/conversion.hpp"
#include "tracking/recording/marker_report.hpp"
#include "tracking/recording/point_reader.hpp"

namespace abstand::tracking {

/// Markers of one file. Not shared between threads.
class MarkerTrack {
 public:
  /// Uses the set named in `options`, otherwise the best of data/marker_sets; its reason() states which, or
  /// why none. Throws ParseError for an invalid set, and for a user's set that finds fewer than six markers
  /// on three segments.
  MarkerTrack(std::span<const std::string> names, const RecordingOptions& options, const std::string& file);

  bool hasSet() const { return match_.has_value(); }
  /// Number of the set's markers in the file; 0 without a set.
  int found() const { return match_ ? static_cast<int>(match_->markers.size()) : 0; }
  const std::string& reason() const { return reason_; }

  /// Adds the next frame of the file.
  void add(const PointFrame& frame);

  /// Solves all frames and writes the joint centres to raw.frames, in the axes and units of the file, with
  /// the selected unit and up axis. If more than half of the frames with markers show no body, `raw` keeps
  /// its frames and the report has no set. A doubt about a stated unit is the warning of raw.unit.
  MarkerReport solveInto(RawRecording& raw, const RecordingOptions& options) const;

 private:
  UpChoice chooseUpOf(const RecordingOptions& options) const;
  std::optional<double> statureOf() const;
  std::vector<humanmodel::SkeletonFrame> heightsOf() const;

  std::optional<MarkerMatch> match_;
  std::string reason_;
  std::vector<std::vector<Vector3d>> places_;  ///< by frame and found marker, axes and units of the file
};

}  // namespace abstand::tracking
