#include "tracking/depth/formats/colour_png.hpp"

#include <opencv2/imgcodecs.hpp>

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"

namespace abstand::tracking {

void saveColourPng(const ColourImage& image, const std::filesystem::path& file) {
  cv::Mat mat(image.height, image.width, CV_8UC3);
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      const auto& [red, green, blue] = image.pixels[static_cast<std::size_t>(v * image.width + u)];
      mat.at<cv::Vec3b>(v, u) = {blue, green, red};
    }
  }
  std::vector<unsigned char> bytes;
  ABSTAND_CHECK(cv::imencode(".png", mat, bytes));
  OutputFile out(file);
  out.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.commit();
}

}  // namespace abstand::tracking
