#include "ui/document/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QFile>
#include <utility>

namespace abstand::ui {

namespace {

/// False where somebody has removed the file before it was locked.
bool isStill(const QString& file, int descriptor) {
  struct stat named {
  }, locked{};
  return ::stat(QFile::encodeName(file).constData(), &named) == 0 && ::fstat(descriptor, &locked) == 0 &&
         named.st_dev == locked.st_dev && named.st_ino == locked.st_ino;
}

}  // namespace

std::optional<FileLock> FileLock::tryLock(const QString& file) {
  const int descriptor = ::open(QFile::encodeName(file).constData(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) return std::nullopt;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && isStill(file, descriptor))
    return FileLock(file, descriptor);
  ::close(descriptor);
  return std::nullopt;
}

FileLock::FileLock(FileLock&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void FileLock::remove() {
  if (descriptor_ >= 0) QFile::remove(file_);
}

}  // namespace abstand::ui
