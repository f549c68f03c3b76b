// Report on the markers of a recording.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace abstand::tracking {

struct MarkerUse {
  std::string label, segment;
  double rms{0.0};           ///< m, distance from its position on the solved body, over the frames that fit
  double shift{0.0};         ///< m, distance of the calibrated from the set's position
  std::size_t seen{0};       ///< frames
  std::size_t misplaced{0};  ///< frames in which it was too far off to be used
};

/// Labels that are exchanged, and the number of frames.
struct MarkerSwap {
  std::string a, b;
  std::size_t frames{0};
};

struct MarkerReport {
  std::string set;      ///< empty: markers were not solved
  std::string reason;   ///< reason for this set, or for none
  double rms{0.0};      ///< m, over all markers that fit, all frames
  double stature{0.0};  ///< m, of the fitted body
  std::vector<MarkerUse> used;
  std::vector<std::pair<std::string, std::string>> ignored;  ///< label, reason
  std::vector<MarkerSwap> swaps;
  std::vector<std::pair<std::string, double>> bones;  ///< fitted lengths, m
  std::size_t lost{0};                                ///< frames with markers of the set, but without a pose
  std::size_t unseen{0};                              ///< frames without any marker of the set
};

}  // namespace abstand::tracking
