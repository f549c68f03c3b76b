// From joints in a file's own axes and units to a recording in metres with z up.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tracking/recording/body_size.hpp"
#include "tracking/recording/file_warning.hpp"
#include "tracking/recording/joint_map.hpp"
#include "tracking/recording/recording.hpp"
#include "tracking/recording/up_axis.hpp"

namespace abstand::tracking {

/// What a reader found, before anything is derived, scaled or turned.
struct RawRecording {
  std::string format;
  std::vector<std::string> joints;  ///< names in the file
  JointMatch match;
  humanmodel::SkeletonFrame rest;  ///< the file's rest pose, where it has one
  std::vector<humanmodel::SkeletonFrame>
      frames;        ///< canonical joints in the file's axes and units; at least one
  double rate{0.0};  ///< Hz
  std::string rate_reason;
  std::optional<UnitChoice> unit;  ///< where the file or its format says it; else it is guessed
  std::optional<UpChoice> up;      ///< likewise
  std::vector<FileWarning> warnings;
  std::vector<std::string> notes;
  bool is_canonical{false};  ///< canonical joints already: none is derived
};

/// Derives what is missing, chooses up axis and units, turns and scales, and writes the report. Throws
/// UsageError for options that mean nothing.
Recording convert(RawRecording raw, const RecordingOptions& options);

}  // namespace abstand::tracking
