// What was understood of the markers of a recording.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace abstand::tracking {

struct MarkerUse {
  std::string label, segment;
  double rms{0.0};           ///< m, from where the solved body has it, over the moments it fits
  double shift{0.0};         ///< m, how far from the set's place it was found to sit
  std::size_t seen{0};       ///< frames
  std::size_t misplaced{0};  ///< frames in which it was too far off to be believed
};

/// Labels that change places, and in how many frames.
struct MarkerSwap {
  std::string a, b;
  std::size_t frames{0};
};

struct MarkerReport {
  std::string set;      ///< empty: no markers were solved
  std::string reason;   ///< why this set, or why none
  double rms{0.0};      ///< m, over all markers that fit, all frames
  double stature{0.0};  ///< m, of the fitted body
  std::vector<MarkerUse> used;
  std::vector<std::pair<std::string, std::string>> ignored;  ///< label, why
  std::vector<MarkerSwap> swaps;
  std::vector<std::pair<std::string, double>> bones;  ///< fitted lengths, m
  std::size_t lost{0};                                ///< frames without a pose
};

}  // namespace abstand::tracking
