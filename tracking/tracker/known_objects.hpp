// Whether depth images show objects whose poses are known.
#pragma once

#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {

/// Pixels at which known objects would be seen.
struct KnownPixels {
  std::size_t there{0};    ///< the measured depth is theirs
  std::size_t through{0};  ///< the camera sees something behind them
  void add(const DepthImage& image, const DepthImage& known);
  /// Enough pixels, and most of those that nothing nearer hides show the objects.
  bool show() const;
};

/// The pixels of up to kComparedImages images, evenly spread over the recording. Throws ParseError.
KnownPixels compareWithKnown(DepthStream& stream, const KnownThings& known);
inline constexpr std::size_t kComparedImages = 12;

}  // namespace abstand::tracking
