#include "app/report/child_program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <sstream>

#include "core/base/error.hpp"
#include "core/base/interrupt.hpp"

namespace abstand::report {
namespace {

constexpr std::size_t kKeptBytes = 400;
constexpr int kWaitMs = 50;

/// Runs between fork and exec: nothing that may lock or allocate.
[[noreturn]] void becomeProgram(const char* program, char* const* arguments, int output) {
  ::setpgid(0, 0);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  ::execv(program, arguments);
  ::_exit(127);
}

/// The last non-empty line.
std::string lastLine(const std::string& text) {
  std::string line, last;
  for (std::istringstream in(text); std::getline(in, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  return last;
}

/// Output of a running program, as far as it is kept.
class ProgramOutput {
 public:
  explicit ProgramOutput(int descriptor) : descriptor_(descriptor) {}
  ~ProgramOutput() { ::close(descriptor_); }
  ProgramOutput(const ProgramOutput&) = delete;
  ProgramOutput& operator=(const ProgramOutput&) = delete;

  /// Waits briefly for more; false at its end.
  bool listen() {
    pollfd wait{descriptor_, POLLIN, 0};
    if (::poll(&wait, 1, kWaitMs) <= 0) return true;
    char block[4096];
    const ssize_t n = ::read(descriptor_, block, sizeof block);
    if (n < 0) return errno == EINTR;
    text_.append(block, static_cast<std::size_t>(n));
    if (text_.size() > kKeptBytes) text_.erase(0, text_.size() - kKeptBytes);
    return n > 0;
  }
  const std::string& text() const { return text_; }

 private:
  int descriptor_;
  std::string text_;
};

int waitFor(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

std::optional<std::filesystem::path> findProgram(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path file = std::filesystem::path(folder.empty() ? "." : folder) / name;
    std::error_code ec;
    if (std::filesystem::is_regular_file(file, ec) && ::access(file.c_str(), X_OK) == 0) return file;
  }
  return std::nullopt;
}

ProgramEnd runProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                      double max_seconds) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw UsageError("no pipe can be made for " + program.string());
  const pid_t child = ::fork();
  if (child == 0) becomeProgram(pointers.front(), pointers.data(), ends[1]);
  ::close(ends[1]);
  ProgramOutput output(ends[0]);
  if (child < 0) throw UsageError("no process can be made for " + program.string());
  ::setpgid(child, child);  // called by both processes, whichever is first
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(max_seconds);
  ProgramEnd result;
  bool interrupted = false;
  while (output.listen()) {
    interrupted = interruptRequested();
    result.timed_out = std::chrono::steady_clock::now() > end;
    if (!interrupted && !result.timed_out) continue;
    ::kill(-child, SIGKILL);
    break;
  }
  // It may have closed its output and still run.
  int status = 0;
  for (pid_t ended = 0; !interrupted && !result.timed_out;) {
    ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child || (ended < 0 && errno != EINTR)) break;
    interrupted = interruptRequested();
    result.timed_out = std::chrono::steady_clock::now() > end;
    if (interrupted || result.timed_out)
      ::kill(-child, SIGKILL);
    else
      ::usleep(kWaitMs * 1000);
  }
  if (interrupted || result.timed_out) status = waitFor(child);
  if (interrupted) throw Interrupted();
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  result.last_words = lastLine(output.text());
  return result;
}

}  // namespace abstand::report
