// Recordings of libfreenect's `record`: INDEX.txt and one PGM for each depth frame.
#include <algorithm>
#include <string_view>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/text_file.hpp"
#include "core/text/message_text.hpp"
#include "tracking/depth/formats/depth_sources.hpp"
#include "tracking/depth/formats/freenect_depth.hpp"
#include "tracking/table/cells.hpp"

namespace abstand::tracking {
namespace {

constexpr std::uintmax_t kMaxListBytes = std::uintmax_t{64} << 20;
constexpr std::uintmax_t kMaxImageBytes = std::uintmax_t{64} << 20;

struct Dumped {
  double t{0.0};
  std::filesystem::path file;
};

/// Depth frames of the index: `d-TIME-TIMESTAMP.pgm`.
std::vector<Dumped> readIndex(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "INDEX.txt";
  const std::string text = readFile(file, kMaxListBytes);
  Lines lines(text);
  std::vector<Dumped> frames;
  std::string_view line;
  while (lines.next(line)) {
    if (!line.starts_with("d-")) continue;
    const SourcePos pos{file.string(), lines.number(), 1};
    const std::size_t end = line.find('-', 2);
    const auto t = end == std::string_view::npos ? std::nullopt : parseDouble(line.substr(2, end - 2));
    if (!t || line.find('/') != std::string_view::npos)
      throw ParseError(pos, "found " + text::inQuotes(line) + ", expected d-TIME-TIMESTAMP.pgm");
    // Frames may have the same time within the resolution of the name; the later one is dropped.
    if (!frames.empty() && *t <= frames.back().t) {
      if (*t < frames.back().t)
        throw ParseError(pos, "found the time " + formatDouble(*t) + " after " +
                                  formatDouble(frames.back().t) + ", expected increasing times");
      continue;
    }
    frames.push_back({*t, folder / line});
  }
  if (frames.empty())
    throw ParseError({file.string()}, "found no depth frame (d-...pgm), expected at least one");
  return frames;
}

}  // namespace

bool isFreenectRecord(const std::filesystem::path& folder) {
  std::error_code ec;
  return std::filesystem::exists(folder / "INDEX.txt", ec);
}

DepthSource openFreenectRecord(const std::filesystem::path& folder, const DepthStreamOptions& options) {
  const std::vector<Dumped> frames = readIndex(folder);
  const auto load = [](const std::filesystem::path& file, const std::optional<FreenectUnits>& units) {
    return parseFreenectDepth(readFile(file, kMaxImageBytes), file.string(), units);
  };
  DepthSource source;
  source.facts.format = "freenect";
  const FreenectImage first = load(frames.front().file, std::nullopt);
  source.facts.notes.push_back(first.units.reason);
  chooseCamera(source, givenCamera(options, folder), first.image.width, first.image.height,
               frames.front().file.string());
  if (options.rate > 0.0) {
    countTimes(source, frames.size(), options);
  } else {
    for (const Dumped& f : frames) source.t.push_back(f.t - frames.front().t);
    source.facts.rate_reason = "the times in the names of INDEX.txt";
  }
  source.load = [frames, load, units = first.units, camera = source.camera](std::size_t i) {
    DepthImage image = load(frames[i].file, units).image;
    needSize(image, camera, frames[i].file.string());
    return image;
  };
  return source;
}

}  // namespace abstand::tracking
