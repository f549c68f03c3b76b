#include "tracking/registry/open_recording.hpp"

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "tracking/registry/recording_format.hpp"

namespace abstand::tracking {

std::vector<std::string> recordingFormats() {
  std::vector<std::string> names;
  for (const auto& format : allRecordingFormats()) names.emplace_back(format.name);
  return names;
}

Recording openRecording(const std::filesystem::path& file, const RecordingOptions& options) {
  std::string names, signs;
  const RecordingFormat* chosen = nullptr;
  for (const auto& format : allRecordingFormats()) {
    names += std::string(", ") + format.name;
    signs += std::string(signs.empty() ? "" : ", ") + format.name + " (" + format.sign + ")";
    if (options.format == format.name) chosen = &format;
  }
  if (!chosen && options.format != "auto")
    throw UsageError("format: found '" + options.format + "', expected auto" + names);
  std::string bytes = readFile(file);
  if (!chosen)
    for (const auto& format : allRecordingFormats())
      if (!chosen && format.looksLike(bytes)) chosen = &format;
  if (!chosen)
    throw ParseError({file.string(), 1, 1},
                     "found no recording of a known format, expected one of: " + signs);
  const std::string_view name = chosen->name;
  if (!options.skeleton.empty() && name != "amc")
    throw UsageError("skeleton: found a recording of the format " + std::string(name) +
                     ", expected amc, the only one with a separate file of bones");
  Recording recording = chosen->read(std::move(bytes), file, options);
  if (!options.repair && name != "bvh")
    recording.report.notes.push_back(
        "--no-repair (repair: false) has no effect: only bvh files are repaired");
  return recording;
}

}  // namespace abstand::tracking
