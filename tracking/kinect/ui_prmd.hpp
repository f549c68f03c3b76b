// Kinect v2 skeletons in the format of UI-PRMD: relative positions in one file, angles in another.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "tracking/recording/point_reader.hpp"
#include "tracking/table/cells.hpp"

namespace abstand::tracking {

/// True if the first line is 66 numbers separated by commas.
bool looksLikeUiPrmd(std::string_view text);

/// The other file of the pair: `..positions..` for `..angles..` and vice versa. Throws ParseError if the name
/// has neither word or the other file does not exist.
std::filesystem::path uiPrmdPartner(const std::filesystem::path& file);

/// Positions: the first joint's is absolute, the others' are in the axes of their parent. Angles: degrees
/// about x, y, z of R = Rz Rx Ry (rotations about the parent's y, x, z in this order): of 36 possible
/// conventions this one keeps the feet of the person in m05 fixed within 4 cm; with the next best they slide
/// by 8 cm. Without rotations the person stands with the arms to the sides. Centimetres; 30 Hz, as
/// documented; no tracking states.
class UiPrmdReader : public PointReader {
 public:
  /// The texts must outlive this object.
  UiPrmdReader(std::string_view positions, std::string positions_file, std::string_view angles,
               std::string angles_file);

  const PointFacts& facts() const override { return facts_; }
  std::span<const std::string> names() const override;
  bool next(PointFrame& frame) override;
  std::vector<Vector3d> turnRest() const override;
  std::vector<int> parents() const override;

 private:
  void keepRest();

  std::string positions_file_, angles_file_;
  Lines positions_, angles_;
  PointFacts facts_;
  std::size_t frames_{0};
  std::vector<Vector3d> rest_;  ///< with the bones of the first frame
  std::vector<double> p_, a_;
};

}  // namespace abstand::tracking
