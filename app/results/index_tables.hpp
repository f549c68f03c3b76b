// The tables of the index, made from result files and read back. Internal to this module.
#pragma once

#include <string>
#include <vector>

#include "app/results/result_index.hpp"
#include "app/results/sqlite_database.hpp"

namespace abstand::results {

/// A result file as it is on the disk.
struct FileStamp {
  std::string name;
  std::int64_t bytes{0}, modified{0};  ///< ns since 1970

  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// All results of FOLDER/results in the order of their names. Throws UsageError for a folder without any.
std::vector<FileStamp> stampsOf(const std::filesystem::path& folder);

/// Makes all tables from these files of FOLDER/results.
void fillIndex(SqliteDatabase& database, const std::filesystem::path& folder,
               const std::vector<FileStamp>& stamps);

/// An undamaged index that this program made of exactly these files. Throws SqliteError for what is no index.
bool isCurrent(const SqliteDatabase& database, const std::vector<FileStamp>& stamps);

ResultIndex readIndex(const SqliteDatabase& database);

}  // namespace abstand::results
