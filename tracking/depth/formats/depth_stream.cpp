// Sequential depth images from any file format.
#include "tracking/depth/formats/depth_stream.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/text_file.hpp"
#include "tracking/depth/formats/depth_sources.hpp"

namespace abstand::tracking {
namespace {

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
    throw ParseError({path.string()}, "found no such file, expected a depth recording");
  if (std::filesystem::is_directory(path, ec)) {
    if (isFreenectRecord(path)) return openFreenectRecord(path, options);
    if (isListedClip(path)) return openListedClip(path, options);
    return openDepthFiles(path, options);
  }
  needRegularFile(path);
  const std::string name = path.filename().string();
  if (name == "INDEX.txt") return openFreenectRecord(path.parent_path(), options);
  if (name == "depth.txt" || name == "associations.txt") return openListedClip(path.parent_path(), options);
  switch (depthFileKind(path)) {
    case DepthFileKind::kMat:
      return openDepthMat(path, options);
    case DepthFileKind::kOni:
      return openOni(path, options);
    case DepthFileKind::kOther:
      throw ParseError({path.string()},
                       "found a file that is no depth recording, expected PNG of 16 bits, TIFF, PCD, NumPy, "
                       "OpenNI or MATLAB",
                       "a folder of images is opened by the folder's name");
    default:
      return openDepthFiles(path, options);
  }
}

}  // namespace

void noteStraightening(DepthFacts& facts, const DepthCamera& camera, bool is_mirrored) {
  if (!camera.distortion.isZero(0.0))
    facts.notes.push_back("the lens distortion is removed by nearest-pixel resampling");
  if (is_mirrored) facts.notes.push_back("the images are mirrored; left and right are swapped back");
}

DepthStream::DepthStream(DepthSource source)
    : source_(std::move(source)), straight_(source_.camera, source_.mirrored) {
  ABSTAND_CHECK(!source_.t.empty() && source_.load);
  source_.facts.rate = medianRate(source_.t);
  noteStraightening(source_.facts, source_.camera, source_.mirrored);
}

bool DepthStream::next(DepthFrame& frame) {
  if (next_ >= source_.t.size()) return false;
  frame.t = source_.t[next_];
  frame.image = source_.load(next_);
  ++next_;
  straight_.straighten(frame.image);
  return true;
}

std::unique_ptr<DepthStream> openDepthStream(const std::filesystem::path& path,
                                             const DepthStreamOptions& options) {
  // The negated form also rejects NaN.
  if (!(options.rate >= 0.0 && options.rate <= 1000.0))
    throw UsageError("a rate of " + formatDouble(options.rate) + ", expected up to 1000 frames per second");
  DepthSource source = openSource(path, options);
  if (options.mirror) source.mirrored = !source.mirrored;
  return std::make_unique<DepthStream>(std::move(source));
}

}  // namespace abstand::tracking
