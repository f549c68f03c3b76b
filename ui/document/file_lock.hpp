// A lock that ends with its process.
#pragma once

#include <QString>
#include <optional>

namespace abstand::ui {

/// Holds a lock file; the system releases it when the process ends, however it ends.
class FileLock {
 public:
  /// None where somebody holds it, or where the file cannot be made.
  static std::optional<FileLock> tryLock(const QString& file);
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

  /// Removes the file and lets go.
  void remove();

 private:
  FileLock(const QString& file, int descriptor) : file_(file), descriptor_(descriptor) {}

  QString file_;
  int descriptor_{-1};
};

}  // namespace abstand::ui
