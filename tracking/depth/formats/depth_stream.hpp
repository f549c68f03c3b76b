// Sequential depth images from any file format.
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
  double t{0.0};  ///< s since the first frame of the file; for a simulated clip, time of its scene
  DepthImage image;
};

/// Interpretation of a depth recording, with reasons.
struct DepthFacts {
  std::string format;         ///< as in README.md
  double rate{0.0};           ///< Hz, from the median step; 0: a single frame
  std::string rate_reason;    ///< source of the times
  double clock_start{kNaN};   ///< s since 1970 UTC at t = 0; NaN: not known
  std::string camera_reason;  ///< source of the intrinsics
  bool camera_known{false};   ///< the intrinsics are from a file; otherwise guessed or fitted
  bool pose_known{false};     ///< camera().X_WC is from a file; otherwise the identity, without meaning
  std::vector<std::string> notes;
};

/// User options that override the reader's guesses.
struct DepthStreamOptions {
  std::filesystem::path camera;  ///< camera file; its depth_scale is used if a format has none
  double rate{0.0};              ///< Hz, time of frame i is i / rate; 0: as in the files
  bool mirror{false};            ///< the images are mirrored, as by some drivers: exchange left and right
};

/// Content of a format: increasing times, and a function that reads the frame of each.
struct DepthSource {
  DepthCamera camera;
  DepthFacts facts;
  bool mirrored{false};   ///< the format's images are known to be mirrored
  std::vector<double> t;  ///< s
  /// Reads frame i. Throws ParseError.
  std::function<DepthImage(std::size_t)> load;
};

/// Adds to `facts` what StraightImages does to the images of this camera.
void noteStraightening(DepthFacts& facts, const DepthCamera& camera, bool is_mirrored);

/// Reads frames sequentially and stores one. Not shared between threads.
class DepthStream {
 public:
  explicit DepthStream(DepthSource source);

  /// Camera of the images of next(): distortion and mirroring are removed from them.
  const DepthCamera& camera() const { return straight_.camera(); }
  const DepthFacts& facts() const { return source_.facts; }
  std::size_t size() const { return source_.t.size(); }
  const std::vector<double>& times() const { return source_.t; }
  /// Reads the next frame, of the camera's size, depths from 0 (no measurement) to 100 m; false after the
  /// last one. Throws ParseError.
  bool next(DepthFrame& frame);
  /// Sets the index of the next frame.
  void seek(std::size_t frame) { next_ = frame; }

 private:
  DepthSource source_;
  StraightImages straight_;
  std::size_t next_{0};
};

/// Opens a folder or a file; the format is detected by content. Throws ParseError with one sentence if it is
/// not a depth recording, and UsageError for invalid options.
std::unique_ptr<DepthStream> openDepthStream(const std::filesystem::path& path,
                                             const DepthStreamOptions& options = {});

}  // namespace abstand::tracking
