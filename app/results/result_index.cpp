#include "app/results/result_index.hpp"

#include <fstream>
#include <optional>

#include "app/results/index_tables.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/write_error.hpp"

namespace abstand::results {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxIndexBytes = std::uintmax_t{1} << 30;
// After this many rebuilds by concurrent changes the index is left to the other processes.
constexpr int kMaxRebuilds = 20;

/// Bytes of a regular file; nullopt if there is none. Not recorded as an input of this run.
std::optional<std::string> bytesOf(const fs::path& file) {
  std::error_code ec;
  if (!fs::is_regular_file(file, ec) || fs::file_size(file, ec) > kMaxIndexBytes || ec) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), {});
  if (bytes.empty()) return std::nullopt;
  return bytes;
}

/// The index on disk, if it is valid.
std::optional<ResultIndex> kept(const fs::path& file, const std::vector<FileStamp>& stamps) {
  std::optional<std::string> bytes = bytesOf(file);
  if (!bytes) return std::nullopt;
  try {
    const SqliteDatabase database(std::move(*bytes));
    if (isCurrent(database, stamps)) return readIndex(database);
  } catch (const SqliteError&) {
    // Damaged or not written by this program.
  }
  return std::nullopt;
}

}  // namespace

ResultIndex resultIndex(const fs::path& folder) {
  const fs::path file = folder / "index.sqlite";
  std::vector<FileStamp> stamps = stampsOf(folder);
  if (std::optional<ResultIndex> index = kept(file, stamps)) return *index;
  for (int i = 0;; ++i) {
    SqliteDatabase database;
    fillIndex(database, folder, stamps);
    ResultIndex index = readIndex(database);
    index.rebuilt = true;
    try {
      writeFile(file, database.bytes());
    } catch (const UsageError& e) {
      index.not_written = e.what();
      return index;
    } catch (const WriteError& e) {
      index.not_written = e.what();
      return index;
    }
    // A result that another process has made in the meantime may be missing in the index just written.
    std::vector<FileStamp> now = stampsOf(folder);
    if (now == stamps || i + 1 == kMaxRebuilds) return index;
    stamps = std::move(now);
  }
}

}  // namespace abstand::results
