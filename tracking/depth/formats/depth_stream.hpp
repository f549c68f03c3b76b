// Depth images one after the other, whatever files they came in.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/straight_images.hpp"

namespace abstand::tracking {

struct DepthFrame {
  double t{0.0};  ///< s since the first frame of the file; of a clip of the simulator, of its scene
  DepthImage image;
};

/// What was understood of a depth recording, and why.
struct DepthFacts {
  std::string format;         ///< as in README.md
  double rate{0.0};           ///< Hz, of the median step; 0: one frame alone
  std::string rate_reason;    ///< where the times come from
  std::string camera_reason;  ///< where the intrinsics come from
  bool camera_known{false};   ///< the intrinsics are those of a file; else they were guessed or fitted
  bool pose_known{false};     ///< camera().X_WC is of a file; else it is the identity and says nothing
  std::vector<std::string> notes;
};

/// What a user may say instead of letting the reader guess.
struct DepthStreamOptions {
  std::filesystem::path
      camera;        ///< a camera file; its depth_scale counts where a format does not say its own
  double rate{0.0};  ///< Hz; 0: what the files say; else frame i lies at i / rate
  bool mirror{
      false};  ///< the images are those of a mirror, as some drivers make them: exchange left and right
};

/// What a format hands over: times that rise, and how to read the frame of each.
struct DepthSource {
  DepthCamera camera;
  DepthFacts facts;
  bool mirrored{false};   ///< the format's images are known to be a mirror's
  std::vector<double> t;  ///< s
  /// Reads frame i. Throws ParseError.
  std::function<DepthImage(std::size_t)> load;
};

/// Notes what StraightImages does to the images of such a camera.
void noteStraightening(DepthFacts& facts, const DepthCamera& camera, bool is_mirrored);

/// Reads frame by frame, and holds one. Not shared between threads.
class DepthStream {
 public:
  explicit DepthStream(DepthSource source);

  /// Without distortion: where the file's camera has one, next() takes it out of the images. Of mirrored
  /// images: after they were turned back.
  const DepthCamera& camera() const { return straight_.camera(); }
  const DepthFacts& facts() const { return source_.facts; }
  std::size_t size() const { return source_.t.size(); }
  const std::vector<double>& times() const { return source_.t; }
  /// The next frame into `frame`, of the camera's size, depths from 0 (not measured) to 100 m; false after
  /// the last one. Throws ParseError.
  bool next(DepthFrame& frame);
  /// The next frame will be number `frame`.
  void seek(std::size_t frame) { next_ = frame; }

 private:
  DepthSource source_;
  StraightImages straight_;
  std::size_t next_{0};
};

/// Opens a folder or a file; the format is found by content. Throws ParseError, in one true sentence, for
/// what is no depth recording, and UsageError for the options.
std::unique_ptr<DepthStream> openDepthStream(const std::filesystem::path& path,
                                             const DepthStreamOptions& options = {});

}  // namespace abstand::tracking
