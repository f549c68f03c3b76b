#include "app/tune/job_pool.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/base/error.hpp"
#include "core/base/interrupt.hpp"

namespace abstand::tune {
namespace {

constexpr int kPollMs = 100;
constexpr std::uint32_t kMaxMessage = 4000;

/// Precedes every answer of a process.
struct Answer {
  std::uint64_t job;
  std::int32_t answered, answer;
  std::uint32_t length;
};

bool writeAll(int fd, const void* bytes, std::size_t count) {
  const char* p = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t n = ::write(fd, p, count);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    p += n;
    count -= static_cast<std::size_t>(n);
  }
  return true;
}

bool readAll(int fd, void* bytes, std::size_t count) {
  char* p = static_cast<char*>(bytes);
  while (count > 0) {
    const ssize_t n = ::read(fd, p, count);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    p += n;
    count -= static_cast<std::size_t>(n);
  }
  return true;
}

/// A forked process that runs jobs by number.
struct Worker {
  pid_t pid{-1};
  int orders{-1}, answers{-1};
  std::size_t job{0};
  bool busy{false};
};

/// Never returns.
[[noreturn]] void serveOrders(int orders, int answers, const std::function<int(std::size_t)>& work) {
  std::uint64_t job = 0;
  while (readAll(orders, &job, sizeof job)) {
    std::string message;
    Answer answer{job, 0, 0, 0};
    try {
      answer.answer = work(static_cast<std::size_t>(job));
      answer.answered = 1;
    } catch (const std::exception& e) {
      message = e.what();
    }
    message.resize(std::min<std::size_t>(message.size(), kMaxMessage));
    answer.length = static_cast<std::uint32_t>(message.size());
    if (!writeAll(answers, &answer, sizeof answer) || !writeAll(answers, message.data(), message.size()))
      break;
  }
  // Without flushing or closing the parent's files.
  ::_exit(0);
}

class Pool {
 public:
  Pool(std::size_t count, int jobs, const std::function<int(std::size_t)>& work,
       const std::function<void(const JobEnd&)>& ended)
      : count_(count), work_(work), ended_(ended) {
    workers_.resize(std::min(count, static_cast<std::size_t>(std::max(1, jobs))));
  }
  ~Pool() {
    for (Worker& w : workers_) end(w);
  }

  bool run() {
    for (;;) {
      const bool stop = interruptRequested();
      bool busy = false;
      for (Worker& w : workers_) {
        if (!w.busy && next_ < count_ && !stop) order(w);
        busy = busy || w.busy;
      }
      if (!busy) return next_ == count_;
      listen();
    }
  }

 private:
  void start(Worker& w) {
    int orders[2], answers[2];
    if (::pipe2(orders, O_CLOEXEC) != 0) throw UsageError("cannot create a pipe for a job: " + reason());
    if (::pipe2(answers, O_CLOEXEC) != 0) {
      close(orders[0]), close(orders[1]);
      throw UsageError("cannot create a pipe for a job: " + reason());
    }
    w.pid = ::fork();
    if (w.pid < 0) {
      for (const int fd : {orders[0], orders[1], answers[0], answers[1]}) close(fd);
      throw UsageError("cannot create a process for a job: " + reason());
    }
    if (w.pid == 0) {
      close(orders[1]), close(answers[0]);
      for (const Worker& other : workers_) {
        if (other.orders >= 0) close(other.orders);
        if (other.answers >= 0) close(other.answers);
      }
      serveOrders(orders[0], answers[1], work_);
    }
    close(orders[0]), close(answers[1]);
    w.orders = orders[1];
    w.answers = answers[0];
  }
  void order(Worker& w) {
    if (w.pid < 0) start(w);
    w.job = next_++;
    w.busy = true;
    const std::uint64_t job = w.job;
    // A dead process is detected by its missing answer.
    (void)writeAll(w.orders, &job, sizeof job);
  }
  void listen() {
    std::vector<pollfd> waits;
    for (const Worker& w : workers_) waits.push_back({w.busy ? w.answers : -1, POLLIN, 0});
    if (::poll(waits.data(), waits.size(), kPollMs) <= 0) return;
    for (std::size_t i = 0; i < workers_.size(); ++i)
      if (waits[i].revents != 0) hear(workers_[i]);
  }
  void hear(Worker& w) {
    Answer answer{};
    std::string message;
    const bool answered = readAll(w.answers, &answer, sizeof answer) && answer.job == w.job &&
                          answer.length <= kMaxMessage &&
                          (message.resize(answer.length), readAll(w.answers, message.data(), message.size()));
    w.busy = false;
    if (answered) {
      ended_({w.job, answer.answered != 0 ? std::optional<int>(answer.answer) : std::nullopt, message});
      return;
    }
    const std::size_t job = w.job;
    ended_({job, std::nullopt, end(w)});
  }
  /// Text for how the process ended.
  static std::string end(Worker& w) {
    if (w.pid < 0) return {};
    close(w.orders), close(w.answers);
    int status = 0;
    while (::waitpid(w.pid, &status, 0) < 0 && errno == EINTR) {
    }
    w = {};
    return WIFSIGNALED(status) ? "ended by signal " + std::to_string(WTERMSIG(status))
                               : "ended with code " + std::to_string(WEXITSTATUS(status));
  }
  static std::string reason() { return std::strerror(errno); }

  std::size_t count_, next_{0};
  const std::function<int(std::size_t)>& work_;
  const std::function<void(const JobEnd&)>& ended_;
  std::vector<Worker> workers_;
};

}  // namespace

bool runJobs(std::size_t count, int jobs, const std::function<int(std::size_t)>& work,
             const std::function<void(const JobEnd&)>& ended) {
  if (count == 0) return true;
  return Pool(count, jobs, work, ended).run();
}

}  // namespace abstand::tune
