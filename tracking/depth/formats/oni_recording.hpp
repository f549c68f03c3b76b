// Container format of OpenNI recordings (.oni).
#pragma once

#include <istream>
#include <optional>

#include "tracking/depth/camera/depth_image.hpp"
#include "tracking/depth/formats/oni_packing.hpp"

namespace abstand::tracking {

/// Location of an image in the file.
struct OniFrame {
  double t{0.0};  ///< s, of the recorder
  std::uint64_t begin{0};
  std::uint32_t bytes{0};
};

/// The first depth stream of a recording.
struct OniDepth {
  int width{0}, height{0};
  double metres{0.001};          ///< metres for each unit of the images
  double rate{0.0};              ///< Hz, nominal; 0: not stated
  std::optional<double> across;  ///< rad, horizontal field of view, if stated
  std::optional<double> down;    ///< rad, vertical
  bool is_mirrored{false};
  OniPacking packing{OniPacking::kTable};
  std::vector<OniFrame> frames;  ///< with increasing times
  bool is_cut{false};            ///< the file ends without its end record
};

/// Reads the records of a file of OpenNI 1 or 2, without the images. `file` is used in errors. Source of the
/// format: OpenNI2, Source/Drivers/OniFile/DataRecords.h (Apache 2). A file is `NI10`, a version, and records
/// with headers of 28 bytes (24 before version 1.0.1.0): magic, type, stream, size of the record without its
/// data, size of its data, position of the record that it replaces. Throws ParseError.
OniDepth readOni(std::istream& in, const std::string& file);

/// Reads one image. Throws ParseError.
DepthImage readOniImage(std::istream& in, const OniDepth& depth, const OniFrame& frame,
                        const std::string& file);

}  // namespace abstand::tracking
