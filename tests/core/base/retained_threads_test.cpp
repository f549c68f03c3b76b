#include "core/base/retained_threads.hpp"

#include <gtest/gtest.h>

#include <semaphore>

namespace abstand {
namespace retained_threads_test {

TEST(RetainedThreads, StartDoesNotWaitAndEndedOnesAreForgotten) {
  RetainedThreads threads;
  std::binary_semaphore first{0}, second{0};
  threads.start([&] { first.acquire(); });
  threads.start([&] { second.acquire(); });
  EXPECT_EQ(threads.running(), 2u);
  first.release();
  while (threads.running() > 1) std::this_thread::yield();
  second.release();
  while (threads.running() > 0) std::this_thread::yield();
}

TEST(RetainedThreads, DestructorWaits) {
  std::atomic<bool> done{false};
  std::binary_semaphore go{0};
  {
    RetainedThreads threads;
    threads.start([&] {
      go.acquire();
      done = true;
    });
    go.release();
  }
  EXPECT_TRUE(done);
}

}  // namespace retained_threads_test
}  // namespace abstand
