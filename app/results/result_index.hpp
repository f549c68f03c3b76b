// FOLDER/index.sqlite: a table of all results of `tune --out FOLDER`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace abstand::results {

/// Of the tables of the index (docs/margins.md, "The index").
inline constexpr std::int64_t kIndexFormat = 1;

/// A result.
struct IndexedRun {
  std::string key, file, recording;
  std::int64_t frames{0};
  double seconds{0.0}, not_judged{0.0};  ///< s
  double min_clearance{0.0};             ///< m, certified, of all parts; -infinity: one was not seen
  std::string part, link;                ///< where that was
  double t{0.0};                         ///< s, of the recording: when
  double proposed{0.0};  ///< m: the largest of what the parts need; infinite: no margin would do
  std::string proposed_part;
};

struct UnreadableResult {
  std::string file, error;
};

struct ResultIndex {
  std::vector<IndexedRun> runs;  ///< least clearance first, then by name and key
  std::vector<UnreadableResult> unreadable;
  bool rebuilt{false};
  std::string not_written;  ///< why the folder has no current index now; empty: it has
};

/// What the folder's results are. Its index is read where it is undamaged, of this program, and of the very
/// files that are there; else it is made again from them, and written where the folder can be written. It
/// holds nothing that the result files do not, and any number of processes may do this at once: each writes
/// all that it sees beside the index and renames it, and looks again. Throws UsageError for a folder without
/// results.
ResultIndex resultIndex(const std::filesystem::path& folder);

}  // namespace abstand::results
