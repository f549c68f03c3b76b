// Simulated depth camera clips of a scene.
#pragma once

#include <functional>
#include <optional>

#include "app/session/session.hpp"
#include "core/base/output_folder.hpp"
#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/simulator/kinect_noise.hpp"
#include "tracking/depth/simulator/skin_body.hpp"

namespace abstand::depth {

/// File format of a clip's images.
enum class ClipFormat : std::uint8_t {
  kPng,      ///< `depth.txt` and 16-bit PNGs in the camera's units
  kFreenect  ///< as libfreenect's `record` of a Kinect: 11-bit disparities; 640 x 480 pixels
};

struct DepthClipOptions {
  ClipFormat format{ClipFormat::kPng};
  tracking::DepthCamera camera;
  std::optional<tracking::SkinOptions> skin;   ///< people have skin bodies; nullopt: their parts in the scene
  std::vector<tracking::DepthCamera> room;     ///< all cameras in it (roomOf); empty: no room
  std::optional<tracking::KinectNoise> noise;  ///< nullopt: an ideal camera
  std::uint64_t seed{1};
  double rate{30.0};                 ///< Hz
  std::optional<double> start, end;  ///< s
  /// Frames done, and total; may be empty.
  std::function<void(std::size_t, std::size_t)> progress;
  std::function<bool()> interrupted;
};

struct DepthClipSummary {
  std::size_t frames{0};
  double measured{0.0};  ///< share of all pixels
  bool interrupted{false};
};

/// Writes to `folder`: `camera.yaml`; `depth_000000.png` and so on (16 bits, in the
/// camera's units) with `depth.txt`, a line `TIME FILE` for each (s, scene time), or for libfreenect
/// `INDEX.txt` and `d-TIME-STAMP.pgm` (scene time in s and in us); and `truth.csv`, a table of the joints of
/// the first person (world, m), `truth_2.csv` and so on for the others. After an interrupt those of the
/// images so far. They appear when the caller commits the folder. Throws UsageError and WriteError.
DepthClipSummary writeDepthClip(session::Session& session, const DepthClipOptions& options,
                                OutputFolder& folder);

/// Default camera pose: 2.8 m in front of the first person (without people: of the centre of all objects), at
/// the height of its centre, along world x; bodies at the session's first frame.
Transform usualView(session::Session& session);

}  // namespace abstand::depth
