#include "core/base/descriptor_stream.hpp"

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "core/base/interrupt.hpp"

namespace abstand {
namespace {

constexpr int kWaitMs = 100;
constexpr int kMaxWaits = 10;  // after an interrupt
// A pipe that is ready takes this many bytes without blocking (PIPE_BUF of Linux).
constexpr std::size_t kPipeBytes = 4096;

/// Waits until the reader accepts data; false after an interrupt while the reader accepts nothing.
bool waitForReader(int descriptor) noexcept {
  for (int waits = 0; waits < kMaxWaits;) {
    pollfd p{descriptor, POLLOUT, 0};
    if (::poll(&p, 1, kWaitMs) > 0) return true;
    if (interruptRequested()) ++waits;
  }
  return false;
}

}  // namespace

int writeAll(int descriptor, std::string_view bytes) noexcept {
  struct stat kind {};
  if (::fstat(descriptor, &kind) != 0) return errno;
  const bool waits = !S_ISREG(kind.st_mode) && !S_ISBLK(kind.st_mode);
  while (!bytes.empty()) {
    if (waits && !waitForReader(descriptor)) return EINTR;
    const ssize_t n =
        ::write(descriptor, bytes.data(), waits ? std::min(bytes.size(), kPipeBytes) : bytes.size());
    if (n >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(n));
    else if (errno != EINTR && errno != EAGAIN)
      return errno;
  }
  return 0;
}

bool DescriptorBuffer::flush() noexcept {
  if (error_ == 0) error_ = writeAll(descriptor_, {pbase(), static_cast<std::size_t>(pptr() - pbase())});
  setp(buffer_.data(), buffer_.data() + buffer_.size());
  return error_ == 0;
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type character) {
  if (!flush()) return traits_type::eof();
  if (!traits_type::eq_int_type(character, traits_type::eof())) {
    *pptr() = traits_type::to_char_type(character);
    pbump(1);
  }
  return traits_type::not_eof(character);
}

std::streamsize DescriptorBuffer::xsputn(const char* bytes, std::streamsize count) {
  if (count <= 0) return 0;
  const auto n = static_cast<std::size_t>(count);
  if (n > static_cast<std::size_t>(epptr() - pptr()) && !flush()) return 0;
  if (n >= buffer_.size()) {
    error_ = writeAll(descriptor_, {bytes, n});
    return error_ == 0 ? count : 0;
  }
  std::copy(bytes, bytes + count, pptr());
  pbump(static_cast<int>(count));
  return count;
}

}  // namespace abstand
