#include "core/base/output_file.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <locale>
#include <system_error>

#include "core/base/error.hpp"
#include "core/base/input_log.hpp"
#include "core/base/interrupt.hpp"
#include "core/base/standard_output.hpp"
#include "core/base/write_error.hpp"

namespace abstand {

namespace {
// Two threads may write the same file at the same time; the last commit wins.
std::atomic<unsigned> files_made{0};

constexpr std::size_t kMaxStem = 200;  // bytes of the temporary file's name; the system allows 255
constexpr unsigned kLookForReaderUs = 20'000;

std::string partEnding() {
  return ".part" + std::to_string(::getpid()) + "." + std::to_string(files_made.fetch_add(1));
}

/// The name as the user gave it: without the temporary folder and suffix of a set being written.
std::string shown(const std::filesystem::path& name) {
  const std::string text = name.string(), own = ".part" + std::to_string(::getpid()) + ".";
  const auto begin = text.find(own);
  if (begin == text.npos) return text;
  auto end = text.find_first_not_of("0123456789", begin + own.size());
  end = std::min(end, text.size());
  if (begin > 0 && text[begin - 1] == '/' && end < text.size() && text[end] == '/') ++end;
  return text.substr(0, begin) + text.substr(end);
}

/// Errors that the user can fix are UsageErrors, all others WriteErrors.
[[noreturn]] void failToOpen(const std::filesystem::path& name, int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EIO:
    case EMFILE:
    case ENFILE:
    case ENOMEM:
      throw WriteError(shown(name), error);
    default:
      throw UsageError(shown(name) + ": cannot be written: " + std::generic_category().message(error));
  }
}

/// Connects to a socket of the file system; -1 with errno.
int connectTo(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string text = path.string();
  if (text.size() >= sizeof address.sun_path) {
    errno = ENAMETOOLONG;
    return -1;
  }
  std::memcpy(address.sun_path, text.c_str(), text.size() + 1);
  const int s = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (s < 0 || ::connect(s, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return s;
  const int error = errno;
  ::close(s);
  errno = error;
  return -1;
}

/// Waits until a pipe has a reader.
int openForReader(const std::filesystem::path& path) {
  for (;;) {
    const int d = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (d >= 0 || errno != ENXIO) return d;
    if (interruptRequested()) throw Interrupted();
    ::usleep(kLookForReaderUs);
  }
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path file)
    : name_(std::move(file)), place_(placeOfOutput(name_)), out_(&buffer_) {
  if (isInput(place_.path))
    throw UsageError(name_.string() + ": found a file that is also an input, expected a different output");
  out_.imbue(std::locale::classic());
  if (place_.kind == OutputPlace::Kind::kFile)
    openPart();
  else
    openSpecial();
  buffer_.open(descriptor_);
  if (isStandardOutput(place_)) claimStandardOutput();
}

void OutputFile::openPart() {
  struct stat old {};
  const bool has_old = place_.exists && ::stat(place_.path.c_str(), &old) == 0;
  if (has_old && ::access(place_.path.c_str(), W_OK) != 0) failToOpen(name_, errno);
  part_ = place_.path.parent_path() / (place_.path.filename().string().substr(0, kMaxStem) + partEnding());
  descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0) failToOpen(name_, errno);
  if (!has_old) return;
  // The new file gets the old one's owner, as far as the system allows.
  if (::fchown(descriptor_, old.st_uid, old.st_gid) != 0) errno = 0;
  ::fchmod(descriptor_, old.st_mode & 0777);
}

void OutputFile::openSpecial() {
  if (place_.kind == OutputPlace::Kind::kDescriptor) {
    descriptor_ = ::fcntl(place_.descriptor, F_DUPFD_CLOEXEC, 3);
  } else {
    const auto type = std::filesystem::status(place_.path).type();
    using Type = std::filesystem::file_type;
    descriptor_ = type == Type::socket ? connectTo(place_.path)
                  : type == Type::fifo ? openForReader(place_.path)
                                       : ::open(place_.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  }
  if (descriptor_ < 0) failToOpen(name_, errno);
}

OutputFile::~OutputFile() {
  closeDescriptor();
  std::error_code ignored;
  if (!part_.empty() && !committed_) std::filesystem::remove(part_, ignored);
  if (!named_.empty() && named_ != part_) std::filesystem::remove(named_, ignored);
}

void OutputFile::closeDescriptor() {
  if (descriptor_ >= 0 && ::close(descriptor_) != 0 && errno != EINTR) buffer_.setError(errno);
  descriptor_ = -1;
}

const std::filesystem::path& OutputFile::named() {
  if (!named_.empty()) return named_;
  if (!part_.empty()) {
    named_ = part_;
    return named_;
  }
  std::error_code ec;
  const auto folder = std::filesystem::temp_directory_path(ec);
  named_ = (ec ? std::filesystem::path("/tmp") : folder) / ("abstand" + partEnding());
  const int d = ::open(named_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (d < 0) throw WriteError(named_.string(), errno);
  ::close(d);
  return named_;
}

void OutputFile::copyNamed() {
  std::ifstream in(named_, std::ios::binary);
  std::vector<char> block(1 << 16);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0)
    out_.write(block.data(), in.gcount());
}

void OutputFile::finish() {
  if (finished_) return;
  if (!named_.empty() && named_ != part_) copyNamed();
  buffer_.flush();
  closeDescriptor();
  if (buffer_.error() == EINTR) throw Interrupted();
  if (buffer_.error() != 0) throw WriteError(shown(name_), buffer_.error());
  // The stream failed without a system error: a failed conversion.
  if (out_.bad()) throw WriteError(shown(name_), 0);
  // Inputs may have been opened after the constructor.
  if (!part_.empty() && isInput(place_.path))
    throw UsageError(name_.string() + ": found a file that is also an input, expected a different output");
  finished_ = true;
}

void OutputFile::commit() {
  finish();
  if (!part_.empty()) {
    std::error_code ec;
    std::filesystem::rename(part_, place_.path, ec);
    if (ec) throw WriteError(shown(name_), ec.value());
  }
  committed_ = true;
}

void writeFile(const std::filesystem::path& file, std::string_view text) {
  OutputFile out(file);
  out.stream() << text;
  out.commit();
}

void appendToFile(const std::filesystem::path& file, std::string_view text) {
  const OutputPlace place = placeOfOutput(file);
  if (place.kind != OutputPlace::Kind::kFile) return writeFile(file, text);
  if (isInput(place.path))
    throw UsageError(file.string() + ": found a file that is also an input, expected a different output");
  const int d = ::open(place.path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (d < 0) failToOpen(file, errno);
  struct stat before {};
  const bool known = ::fstat(d, &before) == 0;
  int error = writeAll(d, text);
  // A partial text is removed.
  if (error != 0 && known && ::ftruncate(d, before.st_size) != 0) error = errno;
  if (::close(d) != 0 && error == 0) error = errno;
  if (error == 0) return;
  std::error_code ignored;
  if (!place.exists) std::filesystem::remove(place.path, ignored);
  throw WriteError(file.string(), error);
}

}  // namespace abstand
