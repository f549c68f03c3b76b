// Images of several live cameras, grouped by their time of arrival.
#pragma once

#include <memory>

#include "tracking/depth/live/live_depth.hpp"
#include "tracking/tracker/depth_moments.hpp"

namespace abstand::tracking {

/// Moments are the arrivals of the images of one camera, the leader: the first that has sent an image within
/// DepthMoments::kGap. With each image of the leader belongs the newest image of every other camera that is
/// not older than DepthMoments::kFarthest. All cameras are on this computer, so their clock is the same; what
/// differs between exposure and arrival is not known. A camera that ends or falls silent has no image in the
/// following moments. One thread.
class LiveMoments {
 public:
  explicit LiveMoments(std::vector<std::unique_ptr<LiveDepth>> cameras);

  /// Waits at most `wait` seconds. kEnded: all cameras have ended. The frames of `moment` are valid until the
  /// next call; their times, and t, are s since the first image of any camera, and increase.
  LiveDepth::Outcome next(DepthMoment& moment, double wait);
  /// Arrival of the leader's image of the last moment.
  std::chrono::steady_clock::time_point came() const { return sources_[leader_].live.came; }

  std::size_t size() const { return sources_.size(); }
  const LiveDepth& camera(std::size_t c) const { return *sources_[c].camera; }
  /// Why there are no more images of a camera, once its last one was read; empty while there may be more.
  std::string ended(std::size_t c) const {
    return sources_[c].has_ended ? sources_[c].camera->ended() : std::string();
  }
  /// Images of all cameras that newer ones replaced before they were read.
  std::size_t dropped() const;

 private:
  struct Source {
    std::unique_ptr<LiveDepth> camera;
    LiveFrame live;        ///< the newest
    double t{-kInfinity};  ///< s, of it; -infinity: none
    bool is_new{false};    ///< not part of a moment yet
    bool has_ended{false};
  };
  void poll(Source& source, double wait);
  std::size_t chooseLeader(double now) const;
  void chooseNewest();
  void fill(DepthMoment& moment);
  double since(std::chrono::steady_clock::time_point then) const;

  std::vector<Source> sources_;
  std::size_t leader_{0};
  double last_{-kInfinity};                                     ///< s, of the last moment
  std::optional<std::chrono::steady_clock::time_point> begin_;  ///< arrival of the first image
};

}  // namespace abstand::tracking
