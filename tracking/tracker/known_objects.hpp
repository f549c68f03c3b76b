// Whether depth images show objects whose poses are known.
#pragma once

#include <optional>

#include "tracking/tracker/clip_tracker.hpp"
#include "tracking/tracker/displaced_things.hpp"

namespace abstand::tracking {

/// Objects to remove from depth images.
struct KnownObjects {
  KnownThings known;           ///< may be empty
  KnownThings robots;          ///< those whose displacement is measured; empty, or null images: all of them
  std::optional<bool> remove;  ///< unset: if the images show them (compareWithKnown())
};

/// Pixels at which known objects would be seen.
struct KnownPixels {
  std::size_t there{0};    ///< the measured depth is theirs
  std::size_t through{0};  ///< the camera sees something behind them
  void add(const DepthImage& image, const DepthImage& known);
  /// Of those that nothing nearer hides; NaN: there is none.
  double share() const;
  /// Enough pixels, and most of those that nothing nearer hides show the objects.
  bool show() const;
};

/// Known objects in the images of a camera.
struct ObjectsInImages {
  static constexpr double kDisplacedShown = 0.35;  ///< KnownPixels::share()
  KnownPixels pixels;                              ///< of all
  DisplacedThings displaced;                       ///< of the robots, if there are any
  /// Where they are said to be, or displaced: part of the pixels show them also then. Of a person who is near
  /// the place of an absent object, hardly any do.
  bool show() const { return pixels.show() || (displaced.areNear() && pixels.share() >= kDisplacedShown); }
};

/// Up to kComparedImages images, evenly spread over the recording. Throws ParseError.
ObjectsInImages compareWithKnown(DepthStream& stream, const KnownObjects& objects);
inline constexpr std::size_t kComparedImages = 12;

/// The images of `known`, with a band (m) around the objects (BandedThings).
KnownThings withBand(KnownThings known, double band);

/// The rest of a sentence on objects that the images show elsewhere; empty: there is no band.
std::string bandReason(const DisplacedThings& displaced);

}  // namespace abstand::tracking
