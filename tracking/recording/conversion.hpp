// Converts joints in a file's axes and units to a recording in metres with z up.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tracking/recording/body_size.hpp"
#include "tracking/recording/file_warning.hpp"
#include "tracking/recording/joint_map.hpp"
#include "tracking/recording/part_turns.hpp"
#include "tracking/recording/recording.hpp"
#include "tracking/recording/sensor_error.hpp"
#include "tracking/recording/up_axis.hpp"

namespace abstand::tracking {

/// Output of a reader, before joints are derived, scaled or rotated.
struct RawRecording {
  std::string format;
  std::vector<std::string> joints;  ///< names in the file
  JointMatch match;
  humanmodel::SkeletonFrame rest;  ///< the file's rest pose, if it has one
  StatedTurns turns;               ///< not used if they are not those of all frames
  std::vector<humanmodel::SkeletonFrame>
      frames;        ///< canonical joints in the file's axes and units; at least one
  double rate{0.0};  ///< Hz
  std::string rate_reason;
  double clock_start{kNaN};        ///< as Recording::clock_start
  std::optional<UnitChoice> unit;  ///< if stated by the file or its format; otherwise it is guessed
  bool unit_is_guess{false};       ///< `unit` was guessed while markers were solved
  std::optional<UpChoice> up;      ///< likewise
  std::vector<FileWarning> warnings;
  std::vector<std::string> notes;
  SubjectFacts subject;
  std::optional<SensorError> sensor;  ///< of joints without a spread, derived ones included
  bool is_canonical{false};           ///< already canonical: no joints are derived
};

/// Derives missing joints, selects up axis and units, rotates and scales, and writes the report. Throws
/// UsageError for invalid options.
Recording convert(RawRecording raw, const RecordingOptions& options);

}  // namespace abstand::tracking
