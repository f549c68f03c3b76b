// Answers the request that was made last, on a thread of its own.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace abstand::studio {

/// What was asked for before, and not begun, is dropped. ask() and take() wait for no answer; destruction
/// waits for the one that is being made.
template <class Request, class Answer>
class LatestRequest {
 public:
  /// Called by the thread alone; must not throw.
  using Make = std::function<Answer(const Request&)>;

  explicit LatestRequest(Make make)
      : make_(std::move(make)), thread_([this](const std::stop_token& stop) { work(stop); }) {}

  void ask(Request request) {
    {
      const std::lock_guard lock(mutex_);
      wanted_ = std::move(request);
    }
    asked_.notify_one();
  }

  /// The newest answer since the last call; false, and `out` untouched: none.
  bool take(Answer& out) {
    const std::lock_guard lock(mutex_);
    if (!ready_) return false;
    out = std::move(*ready_);
    ready_.reset();
    return true;
  }

 private:
  void work(const std::stop_token& stop) {
    while (true) {
      std::optional<Request> wanted;
      {
        std::unique_lock lock(mutex_);
        asked_.wait(lock, stop, [this] { return wanted_.has_value(); });
        if (stop.stop_requested()) return;
        wanted.swap(wanted_);
      }
      Answer answer = make_(*wanted);
      const std::lock_guard lock(mutex_);
      ready_ = std::move(answer);
    }
  }

  Make make_;
  std::mutex mutex_;  // of what follows
  std::condition_variable_any asked_;
  std::optional<Request> wanted_;
  std::optional<Answer> ready_;
  std::jthread thread_;  // last member: joined before the others are destroyed
};

}  // namespace abstand::studio
