// Acclaim skeleton and motion as named points.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tracking/acclaim/amc_reader.hpp"
#include "tracking/acclaim/asf_skeleton.hpp"
#include "tracking/recording/point_reader.hpp"

namespace abstand::tracking {

/// Selects the skeleton of an AMC: the user's choice; otherwise the ASF in the same folder whose name is the
/// longest prefix of the AMC's, as 11.asf of 11_01.amc; otherwise the only ASF there. Throws ParseError if
/// there is none.
std::filesystem::path findAsf(const std::filesystem::path& amc, const std::filesystem::path& wanted);

/// Point names: every bone at its start, and `NAME/end` for bones without children. A bone's rotation is R =
/// R_parent C M C^-1 with its own axes C and the rotation M of the channels, and it ends at p + R offset
/// (Acclaim file description in Meredith and Maddock, "Motion Capture File Formats Explained", 2001, section
/// 3).
class AcclaimPoints : public PointReader {
 public:
  /// Without an AMC there is one frame, the rest pose. The texts must outlive this object.
  AcclaimPoints(std::string_view asf, std::string asf_file, std::string_view amc, std::string amc_file);

  const PointFacts& facts() const override { return facts_; }
  std::span<const std::string> names() const override { return names_; }
  std::vector<Vector3d> rest() const override;
  std::vector<int> parents() const override;
  bool next(PointFrame& frame) override;
  std::vector<FileWarning> warnings() const override;

 private:
  void place(const std::vector<double>& values, std::vector<Vector3d>& p, std::vector<Matrix3d>& R) const;

  AsfSkeleton skeleton_;
  std::optional<AmcReader> motion_;
  PointFacts facts_;
  std::vector<std::string> names_;
  std::vector<std::size_t> leaves_;  ///< bones without children, in the order of their `/end`
  std::vector<double> values_;
  std::size_t channels_{0}, frames_{0};
};

}  // namespace abstand::tracking
