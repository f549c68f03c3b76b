// Acclaim skeleton and motion as points.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tracking/acclaim/amc_reader.hpp"
#include "tracking/acclaim/asf_skeleton.hpp"
#include "tracking/recording/point_reader.hpp"

namespace abstand::tracking {

/// The skeleton of an AMC: what the user says; else the ASF beside it whose name is the longest begin of its
/// own, as 11.asf of 11_01.amc; else the only ASF there. Throws ParseError where there is none.
std::filesystem::path findAsf(const std::filesystem::path& amc, const std::filesystem::path& wanted);

/// Names: every bone where it begins, and `NAME/end` of those that nothing hangs on. A bone's turn is
/// R = R_parent C M C^-1 with its own axes C and M of the channels, and it ends at p + R offset (Acclaim file
/// description in Meredith and Maddock, "Motion Capture File Formats Explained", 2001, section 3).
class AcclaimPoints : public PointReader {
 public:
  /// Without an AMC there is one frame: the rest pose. The texts must outlive this.
  AcclaimPoints(std::string_view asf, std::string asf_file, std::string_view amc, std::string amc_file);

  const PointFacts& facts() const override { return facts_; }
  std::span<const std::string> names() const override { return names_; }
  std::vector<Vector3d> rest() const override;
  bool next(PointFrame& frame) override;
  std::vector<FileWarning> warnings() const override;

 private:
  void place(const std::vector<double>& values, std::vector<Vector3d>& p) const;

  AsfSkeleton skeleton_;
  std::optional<AmcReader> motion_;
  PointFacts facts_;
  std::vector<std::string> names_;
  std::vector<std::size_t> leaves_;  ///< bones, in the order of their `/end`
  std::vector<double> values_;
  std::size_t channels_{0}, frames_{0};
};

}  // namespace abstand::tracking
