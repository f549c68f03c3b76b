// How far the tracking of a depth recording is, and how to end it.
#pragma once

#include <cstddef>
#include <functional>

namespace abstand::tracking {

/// Both functions may be empty; they are called on the tracking thread.
struct TrackMonitor {
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< images
  std::function<bool()> cancelled;  ///< asked for each image; true ends the tracking
};

}  // namespace abstand::tracking
