// Depth images one after the other, whatever files they came in.
#include "tracking/depth/depth_stream.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "tracking/depth/depth_sources.hpp"

namespace abstand {
namespace {

constexpr float kFarthest = 100.0f;  // m; no depth camera measures beyond

/// Where the pixel (u, v) of a camera without distortion lies in the image of the camera with it; row-major
/// number of the nearest pixel, -1 beside the image.
std::vector<int> pixelsWithDistortion(const DepthCamera& c) {
  std::vector<int> from;
  from.reserve(static_cast<std::size_t>(c.width) * static_cast<std::size_t>(c.height));
  for (int v = 0; v < c.height; ++v) {
    for (int u = 0; u < c.width; ++u) {
      const Eigen::Vector2d with = c.pixelOf(c.at(u, v, 1.0));
      const double ud = std::round(with.x()), vd = std::round(with.y());
      const bool inside = ud >= 0.0 && vd >= 0.0 && ud < c.width && vd < c.height;
      from.push_back(inside ? static_cast<int>(vd) * c.width + static_cast<int>(ud) : -1);
    }
  }
  return from;
}

double medianRate(const std::vector<double>& t) {
  if (t.size() < 2) return 0.0;
  std::vector<double> steps;
  for (std::size_t i = 1; i < t.size(); ++i) steps.push_back(t[i] - t[i - 1]);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return 1.0 / *middle;
}

DepthSource openSource(const std::filesystem::path& path, const DepthStreamOptions& options) {
  std::error_code ec;
  if (!std::filesystem::exists(path, ec))
    throw ParseError({path.string()}, "found nothing there, expected a depth recording");
  if (std::filesystem::is_directory(path, ec)) {
    if (isFreenectRecord(path)) return openFreenectRecord(path, options);
    if (isListedClip(path)) return openListedClip(path, options);
    return openDepthFiles(path, options);
  }
  const std::string name = path.filename().string();
  if (name == "INDEX.txt") return openFreenectRecord(path.parent_path(), options);
  if (name == "depth.txt" || name == "associations.txt") return openListedClip(path.parent_path(), options);
  switch (depthFileKind(path)) {
    case DepthFileKind::kMat:
      return openDepthMat(path, options);
    case DepthFileKind::kOni:
      throw ParseError({path.string()},
                       "found an OpenNI recording, which this program does not read; expected another format",
                       "OpenNI's NiViewer or NiRecordToImages saves it as images");
    case DepthFileKind::kOther:
      throw ParseError(
          {path.string()},
          "found a file that is no depth recording, expected PNG of 16 bits, TIFF, PCD, NumPy or MATLAB",
          "a folder of images is opened by the folder's name");
    default:
      return openDepthFiles(path, options);
  }
}

}  // namespace

DepthStream::DepthStream(DepthSource source) : source_(std::move(source)), camera_(source_.camera) {
  ABSTAND_CHECK(!source_.t.empty() && source_.load);
  source_.facts.rate = medianRate(source_.t);
  if (!camera_.distortion.isZero(0.0)) {
    from_ = pixelsWithDistortion(camera_);
    camera_.distortion.setZero();
    source_.facts.notes.push_back("the camera's distortion is taken out of the images, by the nearest pixel");
  }
  if (source_.mirrored) camera_.cx = camera_.width - 1 - camera_.cx;
}

bool DepthStream::next(DepthFrame& frame) {
  if (next_ >= source_.t.size()) return false;
  frame.t = source_.t[next_];
  frame.image = source_.load(next_);
  ++next_;
  ABSTAND_CHECK(frame.image.width == camera_.width && frame.image.height == camera_.height);
  // Written so that NaN is not measured.
  for (float& z : frame.image.z)
    if (!(z > 0.0f && z <= kFarthest)) z = 0.0f;
  if (!from_.empty()) {
    DepthImage straight(camera_.width, camera_.height);
    for (std::size_t i = 0; i < from_.size(); ++i)
      if (from_[i] >= 0) straight.z[i] = frame.image.z[static_cast<std::size_t>(from_[i])];
    frame.image = std::move(straight);
  }
  if (source_.mirrored)
    for (int v = 0; v < camera_.height; ++v)
      std::reverse(&frame.image.at(0, v), &frame.image.at(0, v) + camera_.width);
  return true;
}

std::unique_ptr<DepthStream> openDepthStream(const std::filesystem::path& path,
                                             const DepthStreamOptions& options) {
  // Written so that NaN fails.
  if (!(options.rate >= 0.0 && options.rate <= 1000.0))
    throw UsageError("a rate of " + formatDouble(options.rate) + ", expected up to 1000 frames a second");
  DepthSource source = openSource(path, options);
  if (options.mirror) source.mirrored = !source.mirrored;
  if (source.mirrored)
    source.facts.notes.push_back("the images are those of a mirror; left and right are exchanged back");
  return std::make_unique<DepthStream>(std::move(source));
}

}  // namespace abstand
