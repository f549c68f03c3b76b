// Threads that nobody waits for until the end.
#pragma once

#include <atomic>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace abstand {

/// Keeps threads until their work has ended, so that whoever cancels it need not wait. The destructor waits
/// for all. One thread.
class RetainedThreads {
 public:
  /// `work` must not throw.
  template <class Work>
  void start(Work work) {
    running();
    auto ended = std::make_shared<std::atomic<bool>>(false);
    threads_.emplace_back(ended, std::jthread([ended, work = std::move(work)]() mutable {
                            work();
                            *ended = true;
                          }));
  }

  /// Threads that have not ended; the others are forgotten.
  std::size_t running() {
    std::erase_if(threads_, [](const auto& each) { return each.first->load(); });
    return threads_.size();
  }

 private:
  std::vector<std::pair<std::shared_ptr<std::atomic<bool>>, std::jthread>> threads_;
};

}  // namespace abstand
