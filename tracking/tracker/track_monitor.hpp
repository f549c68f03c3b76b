// How far the tracking of a depth recording is, and how to end it.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace abstand::tracking {

struct FittedClip;

/// All functions may be empty; they are called on the tracking thread.
struct TrackMonitor {
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< images
  std::function<bool()> cancelled;  ///< asked for each image; true ends the tracking
  /// The bodies fitted to the images, once all are tracked. If empty, they are not kept.
  std::function<void(std::shared_ptr<const FittedClip>)> fitted;
};

}  // namespace abstand::tracking
