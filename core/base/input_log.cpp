#include "core/base/input_log.hpp"

#include <sys/stat.h>

#include <mutex>
#include <optional>
#include <set>
#include <utility>

namespace abstand {
namespace {

using FileKey = std::pair<dev_t, ino_t>;

struct Log {
  std::mutex mutex;
  bool kept{false};
  int pauses{0};
  std::set<FileKey> files;
};

Log& theLog() {
  static Log log;
  return log;
}

/// Of regular files only: a device may be read and written.
std::optional<FileKey> keyOf(const std::filesystem::path& file) {
  struct stat s {};
  if (::stat(file.c_str(), &s) != 0 || !S_ISREG(s.st_mode)) return std::nullopt;
  return FileKey{s.st_dev, s.st_ino};
}

}  // namespace

void keepInputLog() {
  const std::scoped_lock lock(theLog().mutex);
  theLog().kept = true;
}

void noteInput(const std::filesystem::path& file) {
  Log& log = theLog();
  const std::scoped_lock lock(log.mutex);
  if (!log.kept || log.pauses > 0) return;
  if (const auto key = keyOf(file)) log.files.insert(*key);
}

bool isInput(const std::filesystem::path& file) {
  Log& log = theLog();
  const std::scoped_lock lock(log.mutex);
  if (log.files.empty()) return false;
  const auto key = keyOf(file);
  return key && log.files.contains(*key);
}

InputLogPause::InputLogPause() {
  const std::scoped_lock lock(theLog().mutex);
  ++theLog().pauses;
}

InputLogPause::~InputLogPause() {
  const std::scoped_lock lock(theLog().mutex);
  --theLog().pauses;
}

}  // namespace abstand
