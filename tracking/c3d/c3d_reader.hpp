// Reads markers of C3D files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tracking/c3d/c3d_bytes.hpp"
#include "tracking/c3d/c3d_parameters.hpp"
#include "tracking/recording/point_reader.hpp"

namespace abstand::tracking {

/// True if the bytes begin with the number of the parameter block and the key 0x50.
bool looksLikeC3d(std::string_view bytes);

/// Supports Intel, DEC and MIPS; integers (POINT:SCALE above 0) and floats (below). Analog samples are
/// skipped. A point with a negative residual is a gap, and so is one at the origin; if all residuals of a
/// file are negative, they are ignored. The header states the locations; frames are those present in the
/// file, and a differing stated number is a warning.
class C3dReader : public PointReader {
 public:
  /// `bytes` must outlive this object. Throws ParseError with the offset.
  C3dReader(std::string_view bytes, std::string file);

  const PointFacts& facts() const override { return facts_; }
  std::span<const std::string> names() const override { return names_; }
  bool next(PointFrame& frame) override;
  std::vector<FileWarning> warnings() const override { return warnings_; }

 private:
  struct Point {
    Vector3d p;
    bool is_measured;  ///< finite, and not a gap by its residual
    double residual;   ///< in units of the file; negative: not measured
    /// Programs write gaps as points at the origin, too.
    bool isSeen() const { return is_measured && !p.isZero(0.0); }
  };
  /// -1 if the parameter does not exist.
  double numberOf(const std::string& name, std::size_t i = 0) const;
  void readHead();
  void nameMarkers();
  void describe();
  std::size_t claimedFrames() const;
  Point point(std::size_t frame, std::size_t i) const;
  void checkResiduals();

  C3dBytes bytes_;
  C3dParameters parameters_;
  std::vector<FileWarning> warnings_;
  PointFacts facts_;
  std::vector<std::string> names_;
  std::size_t points_{0}, frames_{0}, data_{0}, frame_bytes_{0}, next_{0}, first_frame_{1};
  double scale_{1.0};
  bool is_float_{false}, trust_residuals_{true};
};

}  // namespace abstand::tracking
