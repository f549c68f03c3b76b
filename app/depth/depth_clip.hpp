// What a depth camera would see of a scene, as a clip on disk.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/session/session.hpp"
#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/simulator/kinect_noise.hpp"
#include "tracking/depth/simulator/skin_body.hpp"

namespace abstand::depth {

/// How the images of a clip lie on disk.
enum class ClipFormat : std::uint8_t {
  kPng,      ///< `depth.txt` and PNG of 16 bits in the camera's units
  kFreenect  ///< what libfreenect's `record` writes of a Kinect, disparities of 11 bits; 640 x 480 pixels
};

struct DepthClipOptions {
  ClipFormat format{ClipFormat::kPng};
  tracking::DepthCamera camera;
  std::optional<tracking::SkinOptions>
      skin;          ///< people are bodies of smooth skin; none: their parts in the scene
  bool room{false};  ///< a floor at z = 0, and a wall 1.5 m behind the person farthest away
  std::optional<tracking::KinectNoise> noise;  ///< none: an ideal camera
  std::uint64_t seed{1};
  double rate{30.0};                 ///< frames a second
  std::optional<double> start, end;  ///< s
  /// Done and all frames; may be empty.
  std::function<void(std::size_t, std::size_t)> progress;
  std::function<bool()> interrupted;
};

struct DepthClipSummary {
  std::size_t frames{0};
  double measured{0.0};  ///< part of all pixels
  bool interrupted{false};
};

/// Writes into `folder`, which it makes: `camera.yaml`, `depth_000000.png` and so on (16 bits, in the
/// camera's units), `depth.txt`, a line `TIME FILE` for each (s, of the scene), or for libfreenect
/// `INDEX.txt` and `d-TIME-STAMP.pgm` (both of the scene, in s and in us); and of the first person
/// `truth.csv`, a table of the joints that were shown (world, m); of the others `truth_2.csv` and so on.
/// They appear together: of an interrupted clip those of the images so far, after an error none. Throws
/// UsageError and WriteError.
DepthClipSummary writeDepthClip(session::Session& session, const DepthClipOptions& options,
                                const std::filesystem::path& folder);

/// A camera 2.8 m before the first person (of a scene without one: the middle of all objects), level with its
/// middle, along world x; the bodies are where they are at the session's first frame.
Transform usualView(session::Session& session);

}  // namespace abstand::depth
