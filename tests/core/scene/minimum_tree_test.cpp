#include "core/scene/minimum_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random_pose.hpp"

namespace abstand::scene {
namespace minimum_tree_test {

TEST(MinimumTree, MatchesLinearSearch) {
  for (const std::size_t count : {1u, 2u, 3u, 17u, 64u, 1000u}) {
    MinimumTree tree;
    tree.resize(count);
    std::vector<double> values(count, kInfinity);
    EXPECT_FALSE(tree.smallest());
    for (std::uint64_t k = 0; k < 3000; ++k) {
      const auto i = static_cast<std::size_t>(testing::randomUnit(k, 1) * static_cast<double>(count));
      // Few different values, so that equal ones are common; some not there.
      const double v = std::floor(8.0 * testing::randomUnit(k, 2)) - 3.0;
      values[i] = v > 3.0 ? kInfinity : v;
      tree.set(i, v > 3.0 ? kNaN : v);
      const auto first = std::min_element(values.begin(), values.end());
      const auto found = tree.smallest();
      ASSERT_EQ(found.has_value(), *first < kInfinity) << count << " " << k;
      if (found) {
        ASSERT_EQ(*found, static_cast<std::size_t>(first - values.begin())) << count << " " << k;
      }
    }
  }
}

TEST(MinimumTree, EmptyHasNoMinimum) {
  MinimumTree tree;
  EXPECT_FALSE(tree.smallest());
  tree.resize(0);
  EXPECT_FALSE(tree.smallest());
}

}  // namespace minimum_tree_test
}  // namespace abstand::scene
