// Fuzzes the readers of depth files that are ours: clouds, arrays, dumps, and the headers of TIFF.
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/base/error.hpp"
#include "tracking/depth/formats/depth_tiff.hpp"
#include "tracking/depth/formats/freenect_depth.hpp"
#include "tracking/depth/formats/npy_array.hpp"
#include "tracking/depth/formats/pcd_cloud.hpp"

namespace {

/// Only ParseError may come out.
template <class Read>
void tryTo(const Read& read) {
  try {
    read();
  } catch (const abstand::ParseError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  tryTo([&] {
    const abstand::tracking::PcdCloud cloud = abstand::tracking::parsePcd(bytes, "fuzz");
    ABSTAND_CHECK(cloud.points.size() ==
                  static_cast<std::size_t>(cloud.width) * static_cast<std::size_t>(cloud.height));
    const abstand::tracking::FittedCamera fit = abstand::tracking::fitCamera(cloud, "fuzz");
    ABSTAND_CHECK(fit.residual <= 0.5 && fit.camera.fx > 0.0);
  });
  tryTo([&] {
    const abstand::tracking::NpyArray array = abstand::tracking::parseNpy(bytes, "fuzz");
    std::size_t count = 1;
    for (const std::size_t n : array.size) count *= n;
    array.at(0);
    array.at(count - 1);
  });
  tryTo([&] {
    for (const float z : abstand::tracking::parseFreenectDepth(bytes, "fuzz").image.z)
      ABSTAND_CHECK(z >= 0.0f && z < 66.0f);
  });
  tryTo([&] {
    const abstand::tracking::TiffSize size = abstand::tracking::checkDepthTiff(bytes, "fuzz");
    ABSTAND_CHECK(size.width > 0 && size.height > 0);
  });
  return 0;
}
