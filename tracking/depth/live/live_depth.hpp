// Live depth images of a camera.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <semaphore>
#include <thread>

#include "core/base/triple_buffer.hpp"
#include "tracking/depth/formats/depth_stream.hpp"
#include "tracking/depth/live/freenect_camera.hpp"

namespace abstand::tracking {

/// True for a camera name such as kKinectSource, i.e. anything with the prefix `live:`; false for a file.
bool isLiveSource(const std::string& name);

/// One image and its arrival time.
struct LiveFrame {
  DepthFrame frame;                            ///< t: s since the arrival of the first image
  std::chrono::steady_clock::time_point came;  ///< arrival time of the image from the driver
};

/// Images arrive on a thread of the driver; the newest one is delivered, and images never read are counted.
/// One reader thread. The end of the stream is reported by ended(), not thrown.
class LiveDepth {
 public:
  enum class Outcome : std::uint8_t { kFrame, kNothingYet, kEnded };

  /// `name`: see kinectOf(); of `options`, the camera file and the mirror are used, a rate is refused. Throws
  /// ParseError if there is no such camera, and UsageError.
  LiveDepth(const std::string& name, const DepthStreamOptions& options);
  ~LiveDepth();
  LiveDepth(const LiveDepth&) = delete;
  LiveDepth& operator=(const LiveDepth&) = delete;

  const DepthCamera& camera() const { return straight_->camera(); }
  const DepthFacts& facts() const { return facts_; }
  /// The newest image not read yet; waits at most `wait` seconds for it.
  Outcome next(LiveFrame& frame, double wait);
  /// Images replaced by newer ones before they were read.
  std::size_t dropped() const { return dropped_; }
  /// Reason why there are no more images, one sentence; empty while there may be more.
  std::string ended() const;

 private:
  struct Image {
    std::size_t number{0};  ///< of this image, from 1
    LiveFrame live;
  };

  void storeImage(const std::uint16_t* numbers);
  void watch();
  void end(const std::string& why);

  DepthFacts facts_;
  std::array<float, 65536> depth_of_{};  ///< m, of each value that the camera may send
  TripleBuffer<Image> images_;
  std::optional<StraightImages> straight_;
  std::counting_semaphore<> news_{0};
  std::atomic<bool> stop_{false}, has_ended_{false};
  std::string why_;  ///< written before has_ended_ is set, read after

  // The driver's thread:
  std::size_t came_{0};
  std::chrono::steady_clock::time_point first_, last_;
  // The reader's:
  std::size_t taken_{0}, dropped_{0};

  std::unique_ptr<FreenectCamera> driver_;
  std::thread thread_;
};

}  // namespace abstand::tracking
