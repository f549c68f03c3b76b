// Elements of any number come back in order, with and without full blocks.
#include "core/base/block_list.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace abstand {
namespace block_list_test {

TEST(BlockList, GivesBackEveryElementInOrder) {
  constexpr std::size_t kBlock = 8;  // elements
  for (const std::size_t count : {0u, 1u, 7u, 8u, 9u, 16u, 17u, 100u}) {
    BlockList<int> list(kBlock * sizeof(int));
    for (std::size_t i = 0; i < count; ++i) list.add(static_cast<int>(i));
    EXPECT_EQ(list.size(), count);
    std::vector<int> expected(count);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(list.take(), expected);
    EXPECT_EQ(list.size(), 0u);
  }
}

TEST(BlockList, IsUsableAfterwards) {
  BlockList<int> list(sizeof(int));
  list.add(1);
  list.take();
  list.add(2);
  list.add(3);
  EXPECT_EQ(list.take(), (std::vector<int>{2, 3}));
}

}  // namespace block_list_test
}  // namespace abstand
