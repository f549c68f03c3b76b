// Fuzzes the reader of OpenNI's recordings, and what unpacks their images.
#include <cstddef>
#include <cstdint>
#include <sstream>

#include "core/base/error.hpp"
#include "tracking/depth/formats/oni_recording.hpp"

using abstand::tracking::OniPacking;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  constexpr std::size_t kPixels = 60;
  for (const OniPacking packing : {OniPacking::kNone, OniPacking::k16z, OniPacking::kTable}) {
    try {
      ABSTAND_CHECK(abstand::tracking::unpackOni(bytes, packing, kPixels, "fuzz").size() == kPixels);
    } catch (const abstand::ParseError&) {
    }
  }
  try {
    std::istringstream in(bytes);
    const abstand::tracking::OniDepth depth = abstand::tracking::readOni(in, "fuzz");
    ABSTAND_CHECK(!depth.frames.empty() && depth.width > 0 && depth.height > 0);
    double last = -1.0;
    for (const abstand::tracking::OniFrame& frame : depth.frames) {
      ABSTAND_CHECK(frame.t > last);
      last = frame.t;
      try {
        for (const float z : abstand::tracking::readOniImage(in, depth, frame, "fuzz").z)
          ABSTAND_CHECK(z >= 0.0f && z < 66.0f);
      } catch (const abstand::ParseError&) {
      }
    }
  } catch (const abstand::ParseError&) {
  }
  return 0;
}
