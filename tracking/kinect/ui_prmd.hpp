// Kinect v2 skeletons as UI-PRMD stores them: relative places in one file, angles in another.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "tracking/recording/point_reader.hpp"
#include "tracking/table/cells.hpp"

namespace abstand::tracking {

/// True where the first line is 66 numbers with commas between them.
bool looksLikeUiPrmd(std::string_view text);

/// The other file of the pair: `..positions..` for `..angles..` and the reverse. Throws ParseError where the
/// name has neither word or the other file is not there.
std::filesystem::path uiPrmdPartner(const std::filesystem::path& file);

/// Places: the first joint's is absolute, the others' are in the axes of their parent. Angles: degrees about
/// x, y, z of R = Rz Rx Ry (turns about y, x, z of the parent, one after the other): of the 36 orders and
/// readings it is the one that keeps the feet still while the person of m05 gets up, to 4 cm; the next best
/// lets them slide by 8 cm. Centimetres; 30 Hz, as the set says; no state of tracking.
class UiPrmdReader : public PointReader {
 public:
  /// The texts must outlive this.
  UiPrmdReader(std::string_view positions, std::string positions_file, std::string_view angles,
               std::string angles_file);

  const PointFacts& facts() const override { return facts_; }
  std::span<const std::string> names() const override;
  bool next(PointFrame& frame) override;

 private:
  std::string positions_file_, angles_file_;
  Lines positions_, angles_;
  PointFacts facts_;
  std::size_t frames_{0};
  std::vector<double> p_, a_;
};

}  // namespace abstand::tracking
