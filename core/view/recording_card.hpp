// How a person's recording was understood, for the window.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::view {

/// A value that a reader found or guessed, and why.
struct ReadValue {
  std::string value, reason;
  bool guessed{false};  ///< neither the file nor the user says it
};

/// One recording and its interpretation. Empty texts and zeros: not known.
struct RecordingCard {
  std::string person;  ///< whom it moves
  std::string file;    ///< with its folder
  std::string format;
  std::size_t frames{0};
  double duration{0.0};  ///< s
  double rate{0.0};      ///< Hz
  std::string rate_reason;
  double clock_start{kNaN};  ///< s since 1970 UTC at t = 0; NaN: not known
  ReadValue units, up;
  ReadValue sides;      ///< left and right: "agree", "mirrored" or "unknown"
  double stature{0.0};  ///< m
  std::string stature_reason;
  ReadValue joint_map;
  std::size_t moved_parts{0};  ///< body parts that it moves
  std::vector<std::string> missing_parts;
  std::size_t frames_missing{0};  ///< stated by the file, but not there or not complete
  std::size_t gaps{0};            ///< frames in which a joint is missing
  std::vector<std::string> notes, warnings;
};

}  // namespace abstand::view
