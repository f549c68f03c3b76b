// Skeletons as JSON, one object on each line; the input format of `abstand serve`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tracking/recording/point_reader.hpp"
#include "tracking/table/cells.hpp"

namespace abstand::tracking {

/// True if the first line begins with an object that has "joints".
bool looksLikeSkeletonJson(std::string_view text);

/// `{"t": 0.01, "joints": {"pelvis": [x, y, z], "neck": [x, y, z, "inferred"], "spine": null}}`; or `time_us`
/// instead of `t`. The fourth value is "tracked", "inferred" or a confidence. The joints of the first line
/// are those of the recording: any may be missing later, none may be added. Canonical names: metres, z up.
class SkeletonJsonReader : public PointReader {
 public:
  /// `text` must outlive this object. Throws ParseError for the first line.
  SkeletonJsonReader(std::string_view text, std::string file);

  const PointFacts& facts() const override { return facts_; }
  std::span<const std::string> names() const override { return names_; }
  bool next(PointFrame& frame) override;

 private:
  bool nextLine();

  std::string file_;
  Lines lines_;
  std::string_view line_;
  bool has_line_{false};
  PointFacts facts_;
  std::vector<std::string> names_;
  std::size_t frames_{0};
  double last_t_{0.0};
};

}  // namespace abstand::tracking
