// Images of several depth streams, grouped by time.
#pragma once

#include <span>
#include <vector>

#include "tracking/depth/formats/depth_stream.hpp"

namespace abstand::tracking {

/// A stream of several that are read together.
struct ClipCamera {
  DepthStream* stream{nullptr};
  double offset{0.0};  ///< s, added to the stream's times
};

/// What the cameras see at one moment.
struct DepthMoment {
  double t{0.0};  ///< s, on the clock of the first camera
  /// For each camera its image nearest in time; null: it has none near `t`.
  std::vector<const DepthFrame*> frames;
  std::vector<bool> is_new;  ///< not the image of the moment before
  double lag{0.0};           ///< s, largest difference of an image's time from `t`
};

/// Moments are the times of the first camera, and those of the others where all before them have no image
/// within kGap. Each camera's image nearest in time belongs to a moment, if it is within 0.6 of the camera's
/// usual step and within kFarthest. Frames are read sequentially, one is stored for each camera. One thread.
class DepthMoments {
 public:
  static constexpr double kGap = 0.1;        ///< s
  static constexpr double kFarthest = 0.05;  ///< s

  explicit DepthMoments(std::span<const ClipCamera> cameras);

  std::size_t size() const { return times_.size(); }
  const std::vector<double>& times() const { return times_; }
  /// Starts again.
  void rewind();
  /// Reads the images of the next moment; false after the last one. Throws ParseError. The result is valid
  /// until the next call.
  bool next(DepthMoment& moment);

 private:
  struct Reader {
    ClipCamera camera;
    std::vector<double> t;  ///< s, on the first camera's clock
    double farthest{0.0};   ///< s
    std::size_t at{kNone};  ///< index of `frame`
    DepthFrame frame;
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::vector<Reader> readers_;
  std::vector<double> times_;
  std::size_t next_{0};
};

}  // namespace abstand::tracking
