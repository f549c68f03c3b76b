// In which frames of a chunk a part is inside its margins.
#pragma once

#include <bitset>

#include "core/margin/clearance_chunk.hpp"

namespace abstand::margin {

/// The margins of one part with every link.
struct PartMargins {
  struct Pair {
    std::size_t pair;  ///< StoreLayout::pairs
    double margin;     ///< m

    bool operator==(const Pair&) const = default;
  };
  std::vector<Pair> pairs;
  double least{kInfinity}, largest{-kInfinity};  ///< m

  bool same() const { return least == largest; }
  bool operator==(const PartMargins&) const = default;
};

/// Of each part. `margins`: m, of each object, multiplied by `factor`.
std::vector<PartMargins> partMargins(const StoreLayout& layout, std::span<const double> margins,
                                     double factor = 1.0);

/// The frames of a chunk with a clearance below the margin: as verdict() of core/safety, where it is not
/// certain that the margin is kept.
struct InsideFrames {
  bool all{false}, some{false};
  std::bitset<ClearanceChunk::kFrames> frames;  ///< where not all or none
  bool at(std::size_t frame) const { return all || (some && frames[frame]); }
};

InsideFrames insideFrames(const ClearanceChunk& chunk, std::size_t part, const PartMargins& margins);

}  // namespace abstand::margin
