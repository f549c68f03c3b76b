// Markers of a file to joints of a person: finding the set, collecting the places, solving.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tracking/markers/marker_set.hpp"
#include "tracking/recording/conversion.hpp"
#include "tracking/recording/marker_report.hpp"
#include "tracking/recording/point_reader.hpp"

namespace abstand::tracking {

/// The markers of one file. Not shared between threads.
class MarkerTrack {
 public:
  /// The set that `options` name, else the best of data/marker_sets; its reason() says which, or why none.
  /// Throws ParseError for a set that cannot be read, and for one that the user named and that finds less
  /// than six markers on three segments.
  MarkerTrack(std::span<const std::string> names, const RecordingOptions& options, const std::string& file);

  bool hasSet() const { return match_.has_value(); }
  /// Markers of the set that the file has; 0 without a set.
  int found() const { return match_ ? static_cast<int>(match_->markers.size()) : 0; }
  const std::string& reason() const { return reason_; }

  /// The next frame of the file.
  void add(const PointFrame& frame);

  /// Solves all frames and puts the joint centres into raw.frames, in the axes and units of the file, with
  /// the unit and up axis that it chose. Where more than half of the frames show no body, `raw` stays, and
  /// the report has no set.
  MarkerReport solveInto(RawRecording& raw, const RecordingOptions& options) const;

 private:
  UpChoice chooseUpOf(const RecordingOptions& options) const;
  UnitChoice chooseUnitOf(const RecordingOptions& options) const;
  std::vector<humanmodel::SkeletonFrame> heightsOf() const;

  std::optional<MarkerMatch> match_;
  std::string reason_;
  std::vector<std::vector<Vector3d>> places_;  ///< by frame and found marker, axes and units of the file
};

}  // namespace abstand::tracking
