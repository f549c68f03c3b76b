#include "core/study/pairs_file.hpp"

#include <array>
#include <span>
#include <string_view>

#include "core/base/text_file.hpp"
#include "core/base/utf8.hpp"

namespace abstand::study {
namespace {

constexpr std::uintmax_t kMaxBytes = 256u << 20;
/// In the order of PairVerdict; a file never has the last one.
constexpr std::array<const char*, 6> kNames{"adjacent", "never", "always", "user", "sometimes", "undecided"};
constexpr std::span kVerdicts(kNames.data(), kNames.size() - 1);

/// The text up to the next comma; both are removed.
std::string_view nextField(std::string_view& rest) {
  const auto end = std::min(rest.find(','), rest.size());
  const auto field = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return field;
}

}  // namespace

std::string verdictName(PairVerdict verdict) { return kNames[static_cast<std::size_t>(verdict)]; }

std::vector<PairRow> parsePairs(const std::string& text, const std::string& file) {
  std::vector<PairRow> rows;
  bool has_header = false;
  int number = 0;
  for (std::string_view rest = text; !rest.empty();) {
    ++number;
    const auto end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.starts_with('#')) continue;
    if (!isPlainText(line))
      throw ParseError({file, number, 1}, "found bytes that are no text, expected UTF-8");
    if (!has_header) {
      if (line != "verdict,a,b" && !line.starts_with("verdict,a,b,"))
        throw ParseError({file, number, 1},
                         "found another header, expected verdict,a,b,...: a file of `abstand pairs`");
      has_header = true;
      continue;
    }
    PairRow row;
    row.pos = {file, number, 1};
    const std::string verdict(nextField(line));
    std::size_t v = 0;
    while (v < kVerdicts.size() && verdict != kVerdicts[v]) ++v;
    if (v == kVerdicts.size()) {
      const std::string near = nearestName(verdict, {kVerdicts.begin(), kVerdicts.end()});
      throw ParseError(row.pos,
                       "found the verdict '" + verdict.substr(0, 40) +
                           "', expected adjacent, never, always, user or sometimes",
                       near.empty() ? "" : "did you mean " + near + "?");
    }
    row.verdict = static_cast<PairVerdict>(v);
    row.a = nextField(line);
    row.b = nextField(line);
    if (row.a.empty() || row.b.empty() || row.a == row.b)
      throw ParseError(row.pos, "found no two bodies in the row, expected verdict,a,b");
    row.evidence = line;
    rows.push_back(std::move(row));
  }
  if (!has_header)
    throw ParseError({file}, "found no header, expected verdict,a,b,...: a file of `abstand pairs`");
  return rows;
}

std::vector<PairRow> loadPairs(const std::filesystem::path& file) {
  return parsePairs(readFile(file, kMaxBytes), file.string());
}

}  // namespace abstand::study
