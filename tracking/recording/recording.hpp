// A person's recorded motion, whatever file it came from.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "humanmodel/joints.hpp"
#include "tracking/recording/marker_report.hpp"

namespace abstand::tracking {

/// What a user may say about a file instead of letting the reader guess.
struct RecordingOptions {
  std::string format{"auto"};  ///< "auto" or a name of recordingFormats()
  std::string units{"auto"};   ///< "auto", "m", "cm", "mm", "inches", "cmu" (1/0.45 inch), or metres per unit
  std::string up{"auto"};      ///< "auto", "x", "y", "z", "-x", "-y", "-z"
  std::filesystem::path joint_map{};  ///< empty: the best of the shipped maps
  double rate{0.0};                   ///< Hz; 0: what the file says; else frame i lies at t = i / rate
  std::string mirror{
      "none"};  ///< "none", "axes" (those of the file are left-handed) or "sides" (names swapped)
  std::filesystem::path skeleton{};  ///< the ASF of an AMC; empty: looked for beside it
  /// "auto" (the best of the shipped sets), "none" (joints are middles of markers) or a file
  std::string marker_set{"auto"};
};

/// What was understood, and why; everything that was guessed can be overridden.
struct RecordingReport {
  std::string format;
  double rate{0.0};         ///< Hz
  std::string rate_reason;  ///< where the rate and the times come from
  double duration{0.0};     ///< s, from the first frame to the last
  struct Units {
    std::string name;  ///< e.g. "cm"; "free" where the person was scaled to a stature
    std::string reason;
    bool guessed{false};  ///< neither the file, its format nor the user says it
  } units;
  double scale{1.0};  ///< metres per unit of the file
  struct UpAxis {
    std::string axis;  ///< "y"
    std::string reason;
    bool guessed{false};  ///< as units.guessed
  } up;
  std::string sides;  ///< "agree", "mirrored" or "unknown": left and right against where the toes point
  std::string sides_reason;
  double stature{0.0};                                     ///< m, estimated from the bones; 0: not known
  std::string joint_map;                                   ///< name of the map in use
  std::vector<std::string> joints;                         ///< names in the file
  std::map<std::string, std::vector<std::string>> mapped;  ///< body part -> joints of the file
  std::vector<std::string> not_mapped;
  std::vector<std::string> missing_parts;  ///< parts that this file cannot move
  /// Frames that the file claims or begins and does not hold: it was cut. At least so many.
  std::size_t frames_missing{0};
  double lowest_foot{kNaN};           ///< m, z of it over all frames; NaN: no foot is known
  std::size_t gaps{0};                ///< frames in which a mapped joint is missing or not finite
  std::size_t swaps{0};               ///< turns of the hips by more than 90 degrees between two frames
  MarkerReport markers;               ///< of a file of markers that were solved
  std::vector<std::string> notes;     ///< about the file, nothing to worry about
  std::vector<std::string> warnings;  ///< "LINE: text" where a line is known
  /// Numbers of the warnings that fields of this report say as well: frames_missing, missing_parts and
  /// lowest_foot.
  std::vector<std::size_t> in_fields;
};

struct Recording {
  RecordingReport report;
  std::vector<humanmodel::SkeletonFrame> frames;  ///< t rises; canonical joints, metres, z up

  /// The frame at time t: the recorded one at or just before it (no interpolation), clamped at both ends.
  const humanmodel::SkeletonFrame& at(double t) const;
};

}  // namespace abstand::tracking
