// Index of all results of `tune --out FOLDER`: FOLDER/index.sqlite.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace abstand::results {

/// Version of the index tables (docs/margins.md, "The index").
inline constexpr std::int64_t kIndexFormat = 1;

/// One result.
struct IndexedRun {
  std::string key, file, recording;
  std::int64_t frames{0};
  double seconds{0.0}, not_judged{0.0};  ///< s
  double min_clearance{0.0};             ///< m, certified, over all parts; -infinity: one was not seen
  std::string part, link;                ///< part and link of min_clearance
  double t{0.0};                         ///< s, recording time of min_clearance
  double proposed{0.0};                  ///< m: largest safe margin of the parts; infinite: none suffices
  std::string proposed_part;
};

struct UnreadableResult {
  std::string file, error;
};

struct ResultIndex {
  std::vector<IndexedRun> runs;  ///< sorted by clearance, then by name and key
  std::vector<UnreadableResult> unreadable;
  bool rebuilt{false};
  std::string not_written;  ///< why the folder has no current index; empty: it has
};

/// Results of the folder. Uses its index if that is undamaged, made by this program and from exactly the
/// existing files; otherwise rebuilds it from them, and writes it if the folder is writable. The index
/// contains only data of the result files. Any number of processes may do this concurrently: each writes its
/// version to a temporary file, renames it, and checks again. Throws UsageError for a folder without results.
ResultIndex resultIndex(const std::filesystem::path& folder);

}  // namespace abstand::results
