#include "core/base/standard_output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

#include "core/base/descriptor_stream.hpp"
#include "core/base/interrupt.hpp"
#include "core/base/write_error.hpp"

namespace abstand {
namespace {
std::atomic<bool> claimed{false};
}  // namespace

void writeStandardOutput(std::string_view text) {
  const int error = writeAll(STDOUT_FILENO, text);
  if (error == EINTR) throw Interrupted();
  if (error != 0) throw WriteError("standard output", error);
}

void reserveStandardDescriptors() {
  for (;;) {
    const int d = ::open("/dev/null", O_RDONLY);
    if (d < 0 || d > STDERR_FILENO) {
      if (d >= 0) ::close(d);
      return;
    }
  }
}

void claimStandardOutput() noexcept { claimed.store(true, std::memory_order_relaxed); }
bool isStandardOutputClaimed() noexcept { return claimed.load(std::memory_order_relaxed); }

}  // namespace abstand
