// Builds and reads the tables of the result index. Internal to this module.
#pragma once

#include <string>
#include <vector>

#include "app/results/result_index.hpp"
#include "app/results/sqlite_database.hpp"

namespace abstand::results {

/// A result file on disk.
struct FileStamp {
  std::string name;
  std::int64_t bytes{0}, modified{0};  ///< ns since 1970

  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// All results of FOLDER/results, sorted by name. Throws UsageError for a folder without results.
std::vector<FileStamp> stampsOf(const std::filesystem::path& folder);

/// Builds all tables from these files of FOLDER/results.
void fillIndex(SqliteDatabase& database, const std::filesystem::path& folder,
               const std::vector<FileStamp>& stamps);

/// True for an undamaged index built by this program from exactly these files. Throws SqliteError if it is
/// not an index.
bool isCurrent(const SqliteDatabase& database, const std::vector<FileStamp>& stamps);

ResultIndex readIndex(const SqliteDatabase& database);

}  // namespace abstand::results
