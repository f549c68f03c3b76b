// Depth recordings in a folder of files, or in one file: images, clouds, arrays.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "core/text/message_text.hpp"
#include "tracking/depth/formats/depth_png.hpp"
#include "tracking/depth/formats/depth_sources.hpp"
#include "tracking/depth/formats/depth_tiff.hpp"
#include "tracking/depth/formats/npy_array.hpp"
#include "tracking/depth/formats/pcd_cloud.hpp"
#include "tracking/kinect/mat_variable.hpp"

namespace abstand::tracking {
namespace {

using Path = std::filesystem::path;

constexpr std::uintmax_t kMaxBytes = std::uintmax_t{256} << 20;
constexpr double kMillimetres = 1000.0;  // units per metre without a camera file

/// Natural order: image2 before image10.
bool naturallyBefore(const std::string& a, const std::string& b) {
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!isDigit(a[i]) || !isDigit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    const auto digits = [&](const std::string& s, std::size_t& at) {
      while (at < s.size() && s[at] == '0') ++at;
      const std::size_t from = at;
      while (at < s.size() && isDigit(s[at])) ++at;
      return s.substr(from, at - from);
    };
    const std::string x = digits(a, i), y = digits(b, j);
    if (x.size() != y.size()) return x.size() < y.size();
    if (x != y) return x < y;
  }
  if (i < a.size() || j < b.size()) return j < b.size() && i == a.size();
  return a < b;  // 01 and 1
}

struct Found {
  DepthFileKind kind{DepthFileKind::kOther};
  std::vector<Path> files;
  std::size_t colour{0};  ///< number of PNGs in the folder that are not depth images
};

const char* nameOf(DepthFileKind kind) {
  switch (kind) {
    case DepthFileKind::kPng:
    case DepthFileKind::kColourPng:
      return "png";
    case DepthFileKind::kTiff:
      return "tiff";
    case DepthFileKind::kPcd:
      return "pcd";
    case DepthFileKind::kNpy:
      return "npy";
    default:
      return "other";
  }
}

Found findFiles(const Path& path) {
  std::error_code ec;
  if (!std::filesystem::is_directory(path, ec)) {
    const DepthFileKind kind = depthFileKind(path);
    // Its reader reports a PNG with another bit depth.
    return {kind == DepthFileKind::kColourPng ? DepthFileKind::kPng : kind, {path}};
  }
  std::map<DepthFileKind, std::vector<Path>> by_kind;
  for (const auto& entry : std::filesystem::directory_iterator(path, ec))
    if (entry.is_regular_file(ec)) by_kind[depthFileKind(entry.path())].push_back(entry.path());
  Found found;
  for (auto& [kind, files] : by_kind) {
    if (kind == DepthFileKind::kColourPng) found.colour = files.size();
    if (kind != DepthFileKind::kPng && kind != DepthFileKind::kTiff && kind != DepthFileKind::kPcd &&
        kind != DepthFileKind::kNpy)
      continue;
    if (!found.files.empty())
      throw ParseError({path.string()}, std::string("found depth as ") + nameOf(found.kind) + " and as " +
                                            nameOf(kind) + " in one folder, expected one kind");
    found.kind = kind;
    found.files = std::move(files);
  }
  if (found.files.empty())
    throw ParseError(
        {path.string()},
        found.colour > 0
            ? "found " + std::to_string(found.colour) + " PNG without depth, expected PNG of 16 bits of grey"
            : std::string("found no depth image in the folder, expected PNG of 16 bits, TIFF, PCD or NumPy"));
  std::sort(found.files.begin(), found.files.end(), [](const Path& a, const Path& b) {
    return naturallyBefore(a.filename().string(), b.filename().string());
  });
  return found;
}

DepthImage imageOf(const PcdCloud& cloud) {
  DepthImage image(cloud.width, cloud.height);
  for (std::size_t i = 0; i < image.z.size(); ++i) image.z[i] = cloud.points[i].z();
  return image;
}

/// Frame `frame` of an array rows x columns or frames x rows x columns. Integers are in the camera's units,
/// floating point in metres.
DepthImage imageOf(const NpyArray& array, std::size_t frame, double scale) {
  const std::size_t columns = array.size.back(), rows = array.size[array.size.size() - 2];
  DepthImage image(static_cast<int>(columns), static_cast<int>(rows));
  const double unit = array.kind == 'f' ? 1.0 : 1.0 / scale;
  for (std::size_t i = 0; i < image.z.size(); ++i)
    image.z[i] = static_cast<float>(array.at(frame * rows * columns + i) * unit);
  return image;
}

NpyArray parseDepthNpy(const std::string& bytes, const std::string& file) {
  NpyArray array = parseNpy(bytes, file);
  const std::size_t axes = array.size.size();
  if (axes != 2 && axes != 3)
    throw ParseError({file}, "found an array of " + std::to_string(axes) +
                                 " axes, expected rows and columns, or frames before them");
  for (std::size_t i = axes - 2; i < axes; ++i)
    if (array.size[i] > DepthCamera::kMaxPixels)
      throw ParseError({file}, "found " + std::to_string(array.size[i]) +
                                   " pixels along a side, expected at most " +
                                   std::to_string(DepthCamera::kMaxPixels));
  return array;
}

/// The camera of the ITOP data set (Haque et al. 2016).
GivenCamera itopCamera() {
  DepthCamera camera;
  camera.width = 320;
  camera.height = 240;
  camera.fx = camera.fy = 285.7143;
  camera.cx = 160.0;
  camera.cy = 120.0;
  return {camera, "no camera file; 320 x 240 pixels of an array, so that of ITOP"};
}

DepthImage loadOne(const Path& file, DepthFileKind kind, double scale) {
  switch (kind) {
    case DepthFileKind::kPng:
      return loadDepthPng(file, scale);
    case DepthFileKind::kTiff:
      return decodeDepthTiff(readFile(file, kMaxBytes), scale, file.string());
    case DepthFileKind::kPcd:
      return imageOf(parsePcd(readFile(file, kMaxBytes), file.string()));
    default: {
      const std::string bytes = readFile(file, kMaxBytes);
      const NpyArray array = parseDepthNpy(bytes, file.string());
      if (array.size.size() == 3 && array.size[0] != 1)
        throw ParseError({file.string()},
                         "found an array of several frames in a folder of arrays, expected one a file");
      return imageOf(array, 0, scale);
    }
  }
}

/// An array of several frames, stored in memory.
DepthSource openNpyStack(const Path& file, const DepthStreamOptions& options) {
  const auto bytes = std::make_shared<const std::string>(readFile(file, kMaxBytes));
  const NpyArray array = parseDepthNpy(*bytes, file.string());
  DepthSource source;
  source.facts.format = "npy";
  chooseCamera(source, givenCamera(options, file.parent_path()), static_cast<int>(array.size.back()),
               static_cast<int>(array.size[array.size.size() - 2]), file.string(), itopCamera());
  countTimes(source, array.size.size() == 3 ? array.size[0] : 1, options);
  source.load = [bytes, array, scale = source.camera.depth_scale](std::size_t i) {
    return imageOf(array, i, scale);
  };
  return source;
}

}  // namespace

DepthSource openDepthFiles(const Path& path, const DepthStreamOptions& options) {
  const Found found = findFiles(path);
  const Path& first = found.files.front();
  if (found.kind == DepthFileKind::kNpy && found.files.size() == 1) return openNpyStack(first, options);
  DepthSource source;
  source.facts.format = nameOf(found.kind);
  const auto given = givenCamera(options, first.parent_path());
  if (found.kind == DepthFileKind::kPcd) {
    const PcdCloud cloud = parsePcd(readFile(first, kMaxBytes), first.string());
    std::optional<GivenCamera> fitted;
    if (!given) {
      const FittedCamera fit = fitCamera(cloud, first.string());
      fitted = GivenCamera{fit.camera, "fitted to the points of the first cloud, " +
                                           text::rounded(fit.residual, 3) + " pixels median error"};
    }
    chooseCamera(source, given, cloud.width, cloud.height, first.string(), fitted);
  } else {
    const DepthImage image = loadOne(first, found.kind, kMillimetres);
    const auto usual = found.kind == DepthFileKind::kNpy ? std::optional(itopCamera()) : std::nullopt;
    chooseCamera(source, given, image.width, image.height, first.string(), usual);
  }
  countTimes(source, found.files.size(), options);
  if (found.colour > 0)
    source.facts.notes.push_back(std::to_string(found.colour) +
                                 " PNG files that are not 16-bit grey are ignored");
  source.load = [found, camera = source.camera](std::size_t i) {
    DepthImage image = loadOne(found.files[i], found.kind, camera.depth_scale);
    needSize(image, camera, found.files[i].string());
    return image;
  };
  return source;
}

DepthSource openDepthMat(const Path& file, const DepthStreamOptions& options) {
  const auto depth = std::make_shared<const MatVariable>(
      readMatVariable(readFile(file, kMaxBytes), "d_depth", file.string()));
  const auto& size = depth->size;
  if ((size.size() != 2 && size.size() != 3) || depth->values.empty() || size[0] > DepthCamera::kMaxPixels ||
      size[1] > DepthCamera::kMaxPixels)
    throw ParseError({file.string()}, "found d_depth of " + std::to_string(depth->values.size()) +
                                          " numbers in another form, expected rows x columns x frames");
  DepthSource source;
  source.facts.format = "utd-mhad";
  const std::size_t rows = size[0], columns = size[1];
  chooseCamera(source, givenCamera(options, file.parent_path()), static_cast<int>(columns),
               static_cast<int>(rows), file.string());
  countTimes(source, depth->values.size() / (rows * columns), options);
  source.facts.notes.push_back("the people in this set are already segmented: there is no background");
  // The images are mirrored: the set's own skeletons project with the left hand on the left.
  source.mirrored = true;
  source.load = [depth, rows, columns, scale = source.camera.depth_scale](std::size_t frame) {
    DepthImage image(static_cast<int>(columns), static_cast<int>(rows));
    const double* first = depth->values.data() + frame * rows * columns;
    for (std::size_t v = 0; v < rows; ++v)
      for (std::size_t u = 0; u < columns; ++u)
        image.z[v * columns + u] = static_cast<float>(first[u * rows + v] / scale);
    return image;
  };
  return source;
}

}  // namespace abstand::tracking
