// Kinect v1 skeletons in the format of UTD-MHAD: a MATLAB file with the variable d_skel.
#pragma once

#include <string>
#include <string_view>

#include "tracking/recording/point_reader.hpp"

namespace abstand::tracking {

/// True if the bytes begin like a MATLAB file.
bool looksLikeMat(std::string_view bytes);

/// d_skel, 20 joints x 3 x frames, metres; x to the right of a person who faces the camera, y up, z away from
/// it. Times are not stored: 30 Hz, as documented.
class UtdMhadReader : public PointReader {
 public:
  /// Throws ParseError if it is not a MATLAB file, or has no such variable.
  UtdMhadReader(std::string_view bytes, const std::string& file);

  const PointFacts& facts() const override { return facts_; }
  std::span<const std::string> names() const override;
  bool next(PointFrame& frame) override;

 private:
  PointFacts facts_;
  std::vector<double> values_;  ///< column-major, as in MATLAB
  std::size_t frames_{0}, next_{0};
};

}  // namespace abstand::tracking
