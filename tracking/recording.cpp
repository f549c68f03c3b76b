#include "tracking/recording.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "tracking/bvh_recording.hpp"
#include "tracking/skeleton_csv.hpp"

namespace abstand {

const SkeletonFrame& Recording::at(double t) const {
  ABSTAND_CHECK(!frames.empty());
  auto after = std::upper_bound(frames.begin(), frames.end(), t,
                                [](double value, const SkeletonFrame& f) { return value < f.t; });
  return after == frames.begin() ? *after : *(after - 1);
}

Recording openRecording(const std::filesystem::path& file, const RecordingOptions& options) {
  if (options.format != "auto" && options.format != "bvh" && options.format != "csv")
    throw UsageError("format: found '" + options.format + "', expected auto, bvh or csv");
  std::string text = readFile(file);
  const std::string name = file.string();
  if (options.format == "bvh" || (options.format == "auto" && looksLikeBvh(text)))
    return readBvhRecording(std::move(text), name, options);
  if (options.format == "csv" || looksLikeSkeletonCsv(text)) return readSkeletonCsv(text, name, options);
  throw ParseError({name, 1, 1},
                   "found no recording of a known format, expected bvh (begins with HIERARCHY) or csv "
                   "(begins with 't,JOINT.x,')");
}

}  // namespace abstand
