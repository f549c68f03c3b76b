// The formats of depth recordings: each makes a source.
#pragma once

#include <optional>

#include "tracking/depth/formats/depth_stream.hpp"

namespace abstand::tracking {

/// Frames a second where a recording does not say; that of the Kinects.
inline constexpr double kAssumedDepthRate = 30.0;

/// The camera that a user gave, or `camera.yaml` in `folder`; nothing where there is neither.
struct GivenCamera {
  DepthCamera camera;
  std::string reason;
};
std::optional<GivenCamera> givenCamera(const DepthStreamOptions& options,
                                       const std::filesystem::path& folder);

/// The camera of a source of images of this size: the given one, or that of a known sensor with such images,
/// or (where `usual` is set) that one, with its reason. Throws ParseError where nobody knows.
void chooseCamera(DepthSource& source, const std::optional<GivenCamera>& given, int width, int height,
                  const std::string& file, const std::optional<GivenCamera>& usual = {});

/// Throws ParseError where an image has another size than its camera.
void needSize(const DepthImage& image, const DepthCamera& camera, const std::string& file);

/// Times of frames without a time of their own.
void countTimes(DepthSource& source, std::size_t frames, const DepthStreamOptions& options);

/// What a file is, by its first bytes.
enum class DepthFileKind : std::uint8_t { kOther, kPng, kColourPng, kTiff, kPcd, kNpy, kMat, kOni };
DepthFileKind depthFileKind(const std::filesystem::path& file);

/// `depth.txt` of a clip of the simulator (with `camera.yaml` beside) or of the TUM benchmark, or
/// `associations.txt`.
bool isListedClip(const std::filesystem::path& folder);
DepthSource openListedClip(const std::filesystem::path& folder, const DepthStreamOptions& options);

/// `INDEX.txt` and the images that it names, as libfreenect's `record` writes them.
bool isFreenectRecord(const std::filesystem::path& folder);
DepthSource openFreenectRecord(const std::filesystem::path& folder, const DepthStreamOptions& options);

/// All images, clouds or arrays of a folder in natural order (2 before 10), or one file alone. One kind only.
DepthSource openDepthFiles(const std::filesystem::path& path, const DepthStreamOptions& options);

/// A recording of OpenNI 1 or 2, its first stream of depth.
DepthSource openOni(const std::filesystem::path& file, const DepthStreamOptions& options);

/// UTD-MHAD: a MATLAB file with d_depth, rows x columns x frames, mm.
DepthSource openDepthMat(const std::filesystem::path& file, const DepthStreamOptions& options);

}  // namespace abstand::tracking
