#include "core/scene/pair_workers.hpp"

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"

namespace abstand::scene {
namespace pair_workers_test {

TEST(PairWorkers, EveryIndexRunsOncePerCycle) {
  for (const int helpers : {0, 1, 2, 6}) {
    PairWorkers workers(helpers);
    std::vector<int> done(97, 0);
    const auto task = [](void* context, std::size_t i, std::size_t) {
      ++(*static_cast<std::vector<int>*>(context))[i];
    };
    long cycles = 0;
    const testing::NoAlloc guard;
    // Short and long cycles in turn, so that helpers wake up late and see a cycle that is over.
    for (int cycle = 0; cycle < 3000; ++cycle) {
      workers.run(cycle % 3 == 0 ? 1 : done.size(), task, &done);
      if (cycle % 3 != 0) ++cycles;
      ASSERT_EQ(done[0], cycle + 1) << helpers << " helpers";
      ASSERT_EQ(done[96], cycles) << helpers << " helpers";
    }
    EXPECT_EQ(guard.count(), 0);
    for (std::size_t i = 1; i < done.size(); ++i) EXPECT_EQ(done[i], cycles) << i;
    workers.run(0, task, &done);
  }
}

TEST(PairWorkers, StartAndStopWithoutWork) {
  for (int i = 0; i < 50; ++i) PairWorkers workers(i % 5);
}

}  // namespace pair_workers_test
}  // namespace abstand::scene
