// Grey images of infrared and colour cameras. Wraps OpenCV's image files, like depth_png.
#include "tracking/depth/formats/grey_png.hpp"

#include <opencv2/imgcodecs.hpp>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "tracking/depth/formats/png_header.hpp"

namespace abstand::tracking {
namespace {

constexpr std::uintmax_t kMaxGreyPngBytes = std::uintmax_t{256} << 20;

}  // namespace

GreyImage loadGreyPng(const std::filesystem::path& file) {
  const std::string bytes = readFile(file, kMaxGreyPngBytes);
  readPngHeader(bytes, file.string(), "an image of grey or colour");
  cv::Mat grey;
  try {
    grey = cv::imdecode(std::vector<unsigned char>(bytes.begin(), bytes.end()),
                        cv::IMREAD_GRAYSCALE | cv::IMREAD_ANYDEPTH);
    double brightest = 0.0;
    if (grey.type() == CV_16UC1) {
      cv::minMaxLoc(grey, nullptr, &brightest);
      cv::Mat stretched;
      grey.convertTo(stretched, CV_8U, brightest > 0.0 ? 255.0 / brightest : 1.0);
      grey = stretched;
    }
  } catch (const cv::Exception&) {
    grey.release();
  }
  if (grey.empty() || grey.type() != CV_8UC1)
    throw ParseError({file.string()}, "found a damaged PNG, expected an image of grey or colour");
  GreyImage image(grey.cols, grey.rows);
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) image.at(u, v) = grey.at<std::uint8_t>(v, u);
  return image;
}

}  // namespace abstand::tracking
