// Recorded motion of a person, from any file format.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "humanmodel/joints.hpp"
#include "tracking/recording/marker_report.hpp"
#include "tracking/recording/proportions.hpp"
#include "tracking/recording/subject_facts.hpp"

namespace abstand::tracking {

/// User options that override the reader's guesses.
struct RecordingOptions {
  std::string format{"auto"};  ///< "auto" or one of recordingFormats()
  std::string units{"auto"};   ///< "auto", "m", "cm", "mm", "inches", "cmu" (1/0.45 inch), or metres per unit
  std::string up{"auto"};      ///< "auto", "x", "y", "z", "-x", "-y", "-z"
  std::filesystem::path joint_map{};  ///< empty: the best of the included maps
  double rate{0.0};                   ///< Hz; 0: as in the file; otherwise the time of frame i is i / rate
  std::string mirror{
      "none"};  ///< "none", "axes" (the file's axes are left-handed) or "sides" (names swapped)
  std::filesystem::path skeleton{};  ///< the ASF of an AMC; empty: searched in the same folder
  /// "auto" (the best of the included sets), "none" (joints are means of markers) or a file
  std::string marker_set{"auto"};
  bool repair{true};  ///< bones that a conversion has lost are put in
};

/// Interpretation of the file, with reasons; all guesses can be overridden.
struct RecordingReport {
  std::string format;
  double rate{0.0};         ///< Hz
  std::string rate_reason;  ///< source of the rate and the times
  double duration{0.0};     ///< s, from the first frame to the last
  struct Units {
    std::string name;  ///< e.g. "cm"; "free" if the person was scaled to an assumed stature
    std::string reason;
    bool guessed{false};  ///< not stated by the file, its format or the user
    std::string doubt;    ///< why a unit that the file states may be wrong; also in the warnings
  } units;
  double scale{1.0};  ///< metres per unit of the file
  struct UpAxis {
    std::string axis;  ///< "y"
    std::string reason;
    bool guessed{false};  ///< as units.guessed
  } up;
  struct Sides {
    std::string found;  ///< "agree", "mirrored" or "unknown": left and right relative to the direction of the
                        ///< toes
    std::string reason;
  } sides;
  double stature{0.0};  ///< m; 0: unknown
  struct Person {
    std::string stature_reason;               ///< source of the stature; empty if unknown
    SubjectFacts subject;                     ///< what the file says of the person
    std::vector<BoneProportion> proportions;  ///< empty: too few bones are known
    std::string no_body;               ///< why known joints move no part; empty: they do, or none is known
    std::vector<std::string> twisted;  ///< body parts whose twist is that of the file's orientations
  } person;
  std::string joint_map;  ///< name of the selected map
  struct MapUse {
    std::string reason;    ///< for this map, or for none
    bool is_guess{false};  ///< no map knew all names
    /// Points of the file for each canonical joint: none, one, or several of which it is the mean. Empty if
    /// markers were solved.
    std::array<std::vector<std::string>, humanmodel::kJointCount> names;
    bool of_markers{false};      ///< the map's points are on the skin
    bool head_is_middle{false};  ///< the file's head is the middle of the head, not its base
  } map_use;
  std::vector<std::string> joints;                         ///< names in the file
  std::map<std::string, std::vector<std::string>> mapped;  ///< body part -> joints of the file
  std::vector<std::string> not_mapped;
  std::vector<std::string> missing_parts;  ///< parts that this recording cannot move
  /// Frames stated or begun in the file but not complete: it was truncated. Lower limit.
  std::size_t frames_missing{0};
  double lowest_foot{kNaN};           ///< m, smallest z over all frames; NaN: no foot is known
  std::size_t gaps{0};                ///< frames in which a mapped joint is missing or not finite
  std::size_t swaps{0};               ///< rotations of the hips by more than 90 degrees between two frames
  MarkerReport markers;               ///< for a file of markers that were solved
  std::vector<std::string> repairs;   ///< what was put in because the file lacks it; also in the notes
  std::vector<std::string> notes;     ///< about the file, informative
  std::vector<std::string> warnings;  ///< "LINE: text" if a line is known
  /// Indices of the warnings that are also in fields of this report: frames_missing, missing_parts and
  /// lowest_foot.
  std::vector<std::size_t> in_fields;
};

struct Recording {
  RecordingReport report;
  std::vector<humanmodel::SkeletonFrame> frames;  ///< t increases; canonical joints, metres, z up
  double clock_start{kNaN};                       ///< s since 1970 UTC at t = 0; NaN: the file does not say

  /// The frame at time t: the recorded one at or just before it (no interpolation), clamped at both ends.
  const humanmodel::SkeletonFrame& at(double t) const;
};

}  // namespace abstand::tracking
