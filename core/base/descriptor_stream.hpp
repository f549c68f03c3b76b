// Writes text and bytes to an open file descriptor; every error is reported.
#pragma once

#include <ostream>
#include <streambuf>
#include <string_view>
#include <vector>

namespace abstand {

/// Writes all bytes. Returns 0, or the errno of the first failure. On pipes, sockets and terminals it waits
/// for the reader, and gives up with EINTR one second after an interrupt (interruptRequested). Allocates
/// nothing.
int writeAll(int descriptor, std::string_view bytes) noexcept;

/// Stream buffer of 64 KiB that writes to a descriptor. After the first failure nothing more is written.
class DescriptorBuffer final : public std::streambuf {
 public:
  DescriptorBuffer() : buffer_(kBytes) { setp(buffer_.data(), buffer_.data() + kBytes); }

  /// Does not own the descriptor.
  void open(int descriptor) { descriptor_ = descriptor; }
  /// errno of the first failure; 0 if there was none.
  int error() const { return error_; }
  void setError(int error) {
    if (error_ == 0) error_ = error;
  }
  /// Writes the buffer out; true if nothing has failed so far.
  bool flush() noexcept;

 protected:
  int_type overflow(int_type character) override;
  std::streamsize xsputn(const char* bytes, std::streamsize count) override;
  int sync() override { return flush() ? 0 : -1; }

 private:
  static constexpr std::size_t kBytes = 1 << 16;
  std::vector<char> buffer_;
  int descriptor_{-1};
  int error_{0};
};

}  // namespace abstand
