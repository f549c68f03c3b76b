// Depth images as 16-bit PNG. Wraps OpenCV's image files.
#include "tracking/depth/formats/depth_png.hpp"

#include <cmath>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"
#include "tracking/depth/formats/depth_decode.hpp"
#include "tracking/depth/formats/png_header.hpp"

namespace abstand::tracking {
namespace {

constexpr double kMax = 65535.0;
constexpr std::uintmax_t kMaxDepthPngBytes = std::uintmax_t{256} << 20;
/// Checks the header before the decoder allocates memory for untrusted sizes.
void checkHeader(const std::string& bytes, const std::string& file) {
  const PngHeader header = readPngHeader(bytes, file, "a depth image (grey, 16 bits)");
  if (header.bits != 16 || header.colour != 0)
    throw ParseError({file}, "found a PNG of " + std::to_string(header.bits) + " bits and colour type " +
                                 std::to_string(header.colour) + ", expected 16 bits of grey (type 0)");
}

}  // namespace

void saveDepthPng(const DepthImage& image, double scale, const std::filesystem::path& file) {
  cv::Mat grey(image.height, image.width, CV_16UC1);
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      const double units = std::round(image.at(u, v) * scale);
      // The comparisons turn NaN into 0.
      grey.at<std::uint16_t>(v, u) =
          units >= 1.0 && units <= kMax ? static_cast<std::uint16_t>(units) : std::uint16_t{0};
    }
  }
  std::vector<unsigned char> bytes;
  ABSTAND_CHECK(cv::imencode(".png", grey, bytes));
  OutputFile out(file);
  out.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.commit();
}

DepthImage loadDepthPng(const std::filesystem::path& file, double scale) {
  const std::string bytes = readFile(file, kMaxDepthPngBytes);
  checkHeader(bytes, file.string());
  return decodeGrey16(bytes, scale, file.string(), "PNG");
}

DepthImage decodeGrey16(const std::string& bytes, double scale, const std::string& file, const char* kind) {
  cv::Mat grey;
  try {
    grey = cv::imdecode(std::vector<unsigned char>(bytes.begin(), bytes.end()), cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    grey.release();
  }
  if (grey.empty() || grey.type() != CV_16UC1)
    throw ParseError(SourcePos{file},
                     std::string("found a damaged ") + kind + ", expected a depth image (grey, 16 bits)");
  DepthImage image(grey.cols, grey.rows);
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u)
      image.at(u, v) = static_cast<float>(grey.at<std::uint16_t>(v, u) / scale);
  return image;
}

}  // namespace abstand::tracking
