#include "core/mesh_file/mesh_file_child.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

namespace abstand::mesh_file {
namespace {

constexpr char kEnd = '.';  // last byte of a complete answer

// The sanitizers reserve terabytes of address space.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitMemory = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kLimitMemory = false;
#else
constexpr bool kLimitMemory = true;
#endif
#else
constexpr bool kLimitMemory = true;
#endif

void limit(int what, rlim_t value) {
  const rlimit both{value, value};
  ::setrlimit(static_cast<__rlimit_resource>(what), &both);
}

void writeAll(int fd, const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t n = ::write(fd, bytes.data() + at, bytes.size() - at);
    if (n < 0 && errno != EINTR) ::_exit(1);
    if (n > 0) at += static_cast<std::size_t>(n);
  }
}

[[noreturn]] void beChild(const std::function<std::string()>& work, int out, unsigned max_seconds,
                          std::size_t max_bytes) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, max_seconds);
  if (kLimitMemory) limit(RLIMIT_AS, max_bytes);
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  try {
    writeAll(out, work() + kEnd);
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(0);
}

}  // namespace

ChildAnswer runInChild(const std::function<std::string()>& work, unsigned max_seconds,
                       std::size_t max_bytes) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to read a mesh through");
  const pid_t child = ::fork();
  if (child < 0) {
    ::close(ends[0]);
    ::close(ends[1]);
    throw std::runtime_error("no process to read a mesh in");
  }
  if (child == 0) beChild(work, ends[1], max_seconds, max_bytes);
  ::close(ends[1]);

  ChildAnswer answer;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t n = ::read(ends[0], buffer, sizeof buffer);
    if (n > 0) answer.bytes.append(buffer, static_cast<std::size_t>(n));
    if (n == 0 || (n < 0 && errno != EINTR)) break;
  }
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  answer.finished =
      WIFEXITED(status) && WEXITSTATUS(status) == 0 && !answer.bytes.empty() && answer.bytes.back() == kEnd;
  if (answer.finished) answer.bytes.pop_back();
  if (WIFSIGNALED(status)) answer.signal = WTERMSIG(status);
  return answer;
}

}  // namespace abstand::mesh_file
