// Clips with a list of times and files: simulated ones, and those of the TUM RGB-D benchmark.
#include <string_view>

#include "core/base/clock_range.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/text_file.hpp"
#include "core/text/message_text.hpp"
#include "tracking/depth/formats/depth_png.hpp"
#include "tracking/depth/formats/depth_sources.hpp"
#include "tracking/table/cells.hpp"

namespace abstand::tracking {
namespace {

constexpr std::uintmax_t kMaxClipListBytes = std::uintmax_t{64} << 20;

struct Listed {
  double t{0.0};
  std::filesystem::path file;
};

struct Word {
  std::string_view text;
  int column{0};
};

std::vector<Word> wordsOf(std::string_view line) {
  std::vector<Word> words;
  line = line.substr(0, line.find('#'));
  for (std::size_t i = 0; i < line.size();) {
    while (i < line.size() && (line[i] == ' ' || line[i] == '\t' || line[i] == ',')) ++i;
    const std::size_t from = i;
    while (i < line.size() && line[i] != ' ' && line[i] != '\t' && line[i] != ',') ++i;
    if (i > from) words.push_back({line.substr(from, i - from), static_cast<int>(from) + 1});
  }
  return words;
}

/// Resolves a name of a list, which must be inside of the list's folder.
std::filesystem::path within(const std::filesystem::path& folder, const Word& word, const SourcePos& pos) {
  const std::filesystem::path name(word.text);
  bool leaves = name.is_absolute();
  for (const auto& part : name) leaves |= part == "..";
  if (leaves)
    throw ParseError(pos, "found " + text::inQuotes(word.text) + ", expected a file within the folder");
  return folder / name;
}

/// The column of `words` (0 or 2) with a time followed by the name of a depth image.
std::size_t depthColumn(const std::vector<Word>& words, const std::filesystem::path& folder) {
  if (words.size() < 4) return 0;
  return depthFileKind(folder / words[1].text) == DepthFileKind::kPng ? 0 : 2;
}

std::vector<Listed> readList(const std::filesystem::path& file, std::size_t& repeated) {
  const std::string text = readFile(file, kMaxClipListBytes);
  Lines lines(text);
  std::vector<Listed> listed;
  std::string_view line;
  std::size_t column = 0, words_a_line = 0;
  while (lines.next(line)) {
    const std::vector<Word> words = wordsOf(line);
    if (words.empty()) continue;
    const SourcePos start{file.string(), lines.number(), words.front().column};
    if (words_a_line == 0) {
      if (words.size() != 2 && words.size() != 4)
        throw ParseError(start, "found " + std::to_string(words.size()) +
                                    " words, expected a time and a file, or two of each");
      words_a_line = words.size();
      column = depthColumn(words, file.parent_path());
    }
    if (words.size() != words_a_line)
      throw ParseError(start, "found " + std::to_string(words.size()) + " words, expected " +
                                  std::to_string(words_a_line) + " as before");
    const Word &time = words[column], &name = words[column + 1];
    const SourcePos pos{file.string(), lines.number(), time.column};
    const auto t = parseDouble(time.text);
    if (!t) throw ParseError(pos, "found " + text::inQuotes(time.text) + ", expected a time in seconds");
    // One depth image may belong to two colour images.
    if (!listed.empty() && *t == listed.back().t) {
      ++repeated;
      continue;
    }
    if (!listed.empty() && *t < listed.back().t)
      throw ParseError(pos, "found the time " + formatDouble(*t) + " after " + formatDouble(listed.back().t) +
                                ", expected increasing times");
    listed.push_back({*t, within(file.parent_path(), name, {file.string(), lines.number(), name.column})});
  }
  if (listed.empty()) throw ParseError({file.string()}, "found no image in the list, expected at least one");
  return listed;
}

/// Intrinsics that the benchmark's authors recommend for its depth images, and its scale.
GivenCamera tumCamera() {
  DepthCamera camera;
  camera.fx = camera.fy = 525.0;
  camera.depth_scale = 5000.0;
  return {camera, "no camera file; that of the TUM benchmark: 525 pixels, 5000 units per metre"};
}

}  // namespace

bool isListedClip(const std::filesystem::path& folder) {
  std::error_code ec;
  return std::filesystem::exists(folder / "depth.txt", ec) ||
         std::filesystem::exists(folder / "associations.txt", ec);
}

DepthSource openListedClip(const std::filesystem::path& folder, const DepthStreamOptions& options) {
  std::error_code ec;
  const bool is_plain = std::filesystem::exists(folder / "depth.txt", ec);
  const std::filesystem::path list = folder / (is_plain ? "depth.txt" : "associations.txt");
  const bool is_own = is_plain && std::filesystem::exists(folder / "camera.yaml", ec);
  std::size_t repeated = 0;
  const std::vector<Listed> listed = readList(list, repeated);

  DepthSource source;
  source.facts.format = is_own ? "clip" : "tum";
  const DepthImage first = loadDepthPng(listed.front().file, 1.0);
  chooseCamera(source, givenCamera(options, folder), first.width, first.height, listed.front().file.string(),
               tumCamera());
  if (options.rate > 0.0) {
    countTimes(source, listed.size(), options);
  } else {
    const double start = is_own ? 0.0 : listed.front().t;
    for (const Listed& l : listed) source.t.push_back(l.t - start);
    source.facts.rate_reason = "the times of " + list.filename().string();
    if (start >= kEarliestClock && start < kLatestClock) source.facts.clock_start = start;
  }
  if (repeated > 0)
    source.facts.notes.push_back(std::to_string(repeated) +
                                 " lines repeat the previous image and are ignored");
  source.load = [listed, camera = source.camera](std::size_t i) {
    const std::filesystem::path& file = listed[i].file;
    DepthImage image = loadDepthPng(file, camera.depth_scale);
    needSize(image, camera, file.string());
    return image;
  };
  return source;
}

}  // namespace abstand::tracking
