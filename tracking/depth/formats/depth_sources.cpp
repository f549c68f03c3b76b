// Common parts of depth recording formats: cameras, times, kinds of files.
#include "tracking/depth/formats/depth_sources.hpp"

#include <array>
#include <fstream>
#include <string_view>

#include "core/base/error.hpp"

namespace abstand::tracking {
namespace {

/// Nominal intrinsics of known sensors, by image size.
struct Sensor {
  int width, height;
  double focal, cx, cy;
  const char* name;
};
// Kinect v1: NUI_CAMERA_DEPTH_NOMINAL_FOCAL_LENGTH_IN_PIXELS of Microsoft's SDK, 285.63 at 320 x 240.
// Kinect v2: 365.5 pixels, a typical value reported by devices.
constexpr std::array kSensors{Sensor{320, 240, 285.63, 159.5, 119.5, "Kinect v1"},
                              Sensor{640, 480, 571.26, 319.5, 239.5, "Kinect v1"},
                              Sensor{512, 424, 365.5, 255.5, 211.5, "Kinect v2"}};

}  // namespace

std::optional<GivenCamera> givenCamera(const DepthStreamOptions& options,
                                       const std::filesystem::path& folder) {
  if (!options.camera.empty()) return GivenCamera{loadDepthCamera(options.camera), "the file that was given"};
  const auto beside = folder / "camera.yaml";
  std::error_code ec;
  if (!std::filesystem::exists(beside, ec)) return std::nullopt;
  return GivenCamera{loadDepthCamera(beside), "camera.yaml next to the images"};
}

void chooseCamera(DepthSource& source, const std::optional<GivenCamera>& given, int width, int height,
                  const std::string& file, const std::optional<GivenCamera>& usual) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (given) {
    const DepthCamera& c = given->camera;
    if (c.width != width || c.height != height)
      throw ParseError({file}, "found " + size + ", expected " + std::to_string(c.width) + " x " +
                                   std::to_string(c.height) + " as in its camera file");
    source.camera = c;
    source.facts.camera_reason = given->reason;
    source.facts.camera_known = true;
    source.facts.pose_known = !c.X_WC.matrix().isIdentity(0.0);
    return;
  }
  if (usual && usual->camera.width == width && usual->camera.height == height) {
    source.camera = usual->camera;
    source.facts.camera_reason = usual->reason;
    return;
  }
  for (const Sensor& s : kSensors) {
    if (s.width != width || s.height != height) continue;
    DepthCamera& c = source.camera;
    c = {};
    c.width = width;
    c.height = height;
    c.fx = c.fy = s.focal;
    c.cx = s.cx;
    c.cy = s.cy;
    source.facts.camera_reason =
        std::string("no camera file; ") + size + ", so the nominal numbers of a " + s.name;
    return;
  }
  throw ParseError({file},
                   "found " + size + " and no camera file, expected one, as no known sensor has that size",
                   "give --camera FILE: width, height, fx, fy, cx, cy, depth_scale");
}

void needSize(const DepthImage& image, const DepthCamera& camera, const std::string& file) {
  if (image.width == camera.width && image.height == camera.height) return;
  throw ParseError({file}, "found " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                               " pixels, expected " + std::to_string(camera.width) + " x " +
                               std::to_string(camera.height) + " as in the first image");
}

void countTimes(DepthSource& source, std::size_t frames, const DepthStreamOptions& options) {
  const double rate = options.rate > 0.0 ? options.rate : kAssumedDepthRate;
  source.facts.rate_reason =
      options.rate > 0.0 ? "the rate that was given" : "no times in the files; 30 Hz assumed";
  source.t.clear();
  for (std::size_t i = 0; i < frames; ++i) source.t.push_back(static_cast<double>(i) / rate);
}

DepthFileKind depthFileKind(const std::filesystem::path& file) {
  std::array<char, 32> first{};
  // Reading a pipe would block forever.
  std::error_code ec;
  if (!std::filesystem::is_regular_file(file, ec)) return DepthFileKind::kOther;
  std::ifstream in(file, std::ios::binary);
  in.read(first.data(), first.size());
  const std::string_view head(first.data(), static_cast<std::size_t>(in.gcount()));
  const auto begins = [&](std::string_view s) { return head.starts_with(s); };
  using enum DepthFileKind;
  if (begins("\x89PNG\r\n\x1a\n"))
    return head.size() > 25 && head[24] == 16 && head[25] == 0 ? kPng : kColourPng;
  if (begins(std::string_view("II*\0", 4)) || begins(std::string_view("MM\0*", 4))) return kTiff;
  if (begins("# .PCD") || begins("VERSION") || begins("FIELDS")) return kPcd;
  if (begins("\x93NUMPY")) return kNpy;
  if (begins("MATLAB ")) return kMat;
  if (begins("NI10")) return kOni;
  return kOther;
}

}  // namespace abstand::tracking
