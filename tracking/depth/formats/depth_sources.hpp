// Formats of depth recordings: each one makes a DepthSource.
#pragma once

#include <optional>

#include "tracking/depth/formats/depth_stream.hpp"

namespace abstand::tracking {

/// Hz, frame rate assumed if a recording states none; that of the Kinects.
inline constexpr double kAssumedDepthRate = 30.0;

/// The user's camera file, or `camera.yaml` in `folder`; nullopt if there is neither.
struct GivenCamera {
  DepthCamera camera;
  std::string reason;
};
std::optional<GivenCamera> givenCamera(const DepthStreamOptions& options,
                                       const std::filesystem::path& folder);

/// Sets the camera of a source with images of this size: the given one, or that of a known sensor with such
/// images, or else `usual` (if set) with its reason. Throws ParseError if none applies.
void chooseCamera(DepthSource& source, const std::optional<GivenCamera>& given, int width, int height,
                  const std::string& file, const std::optional<GivenCamera>& usual = {});

/// Throws ParseError if an image and its camera differ in size.
void needSize(const DepthImage& image, const DepthCamera& camera, const std::string& file);

/// Sets times of frames that have none.
void countTimes(DepthSource& source, std::size_t frames, const DepthStreamOptions& options);

/// Kind of a file, by its first bytes.
enum class DepthFileKind : std::uint8_t { kOther, kPng, kColourPng, kTiff, kPcd, kNpy, kMat, kOni };
DepthFileKind depthFileKind(const std::filesystem::path& file);

/// True for a folder with `depth.txt` of a simulated clip (with `camera.yaml`) or of the TUM benchmark, or
/// with `associations.txt`.
bool isListedClip(const std::filesystem::path& folder);
DepthSource openListedClip(const std::filesystem::path& folder, const DepthStreamOptions& options);

/// True for a folder with `INDEX.txt` and the images it lists, as written by libfreenect's `record`.
bool isFreenectRecord(const std::filesystem::path& folder);
DepthSource openFreenectRecord(const std::filesystem::path& folder, const DepthStreamOptions& options);

/// All images, clouds or arrays of a folder in natural order (2 before 10), or a single file. One kind only.
DepthSource openDepthFiles(const std::filesystem::path& path, const DepthStreamOptions& options);

/// First depth stream of a recording of OpenNI 1 or 2.
DepthSource openOni(const std::filesystem::path& file, const DepthStreamOptions& options);

/// UTD-MHAD: a MATLAB file with d_depth, rows x columns x frames, mm.
DepthSource openDepthMat(const std::filesystem::path& file, const DepthStreamOptions& options);

}  // namespace abstand::tracking
