// Depth images as 16-bit PNG. The fence around OpenCV's image files.
#include "tracking/depth/depth_png.hpp"

#include <cmath>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"
#include "tracking/depth/depth_camera.hpp"
#include "tracking/depth/depth_decode.hpp"

namespace abstand {
namespace {

constexpr double kMost = 65535.0;
constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20;
// Signature, length and name of the first chunk, width, height, bits, colour type.
constexpr std::size_t kHeader = 26;

std::uint32_t bigEndian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// Before the decoder reserves memory for what a stranger says.
void checkHeader(const std::string& bytes, const std::string& file) {
  const SourcePos place{file};
  if (bytes.size() < kHeader || bytes.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0 ||
      bytes.compare(12, 4, "IHDR") != 0)
    throw ParseError(place, "found no PNG, expected a depth image (grey, 16 bits)");
  const std::uint32_t width = bigEndian(bytes, 16), height = bigEndian(bytes, 20);
  const auto bits = static_cast<unsigned>(static_cast<unsigned char>(bytes[24]));
  const auto colour = static_cast<unsigned>(static_cast<unsigned char>(bytes[25]));
  if (bits != 16 || colour != 0)
    throw ParseError(place, "found a PNG of " + std::to_string(bits) + " bits and colour type " +
                                std::to_string(colour) + ", expected 16 bits of grey (type 0)");
  if (width == 0 || height == 0 || width > DepthCamera::kMostPixels || height > DepthCamera::kMostPixels)
    throw ParseError(place, "found " + std::to_string(width) + " x " + std::to_string(height) +
                                " pixels, expected 1 to " + std::to_string(DepthCamera::kMostPixels) +
                                " along a side");
}

}  // namespace

void saveDepthPng(const DepthImage& image, double scale, const std::filesystem::path& file) {
  cv::Mat grey(image.height, image.width, CV_16UC1);
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      const double units = std::round(image.at(u, v) * scale);
      // Written so that NaN is not measured.
      grey.at<std::uint16_t>(v, u) =
          units >= 1.0 && units <= kMost ? static_cast<std::uint16_t>(units) : std::uint16_t{0};
    }
  }
  std::vector<unsigned char> bytes;
  ABSTAND_CHECK(cv::imencode(".png", grey, bytes));
  OutputFile out(file);
  out.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.commit();
}

DepthImage loadDepthPng(const std::filesystem::path& file, double scale) {
  const std::string bytes = readFile(file, kMostBytes);
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

}  // namespace abstand
