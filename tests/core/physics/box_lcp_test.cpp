// Forces within bounds, against trying every side of every row.
#include "core/physics/box_lcp.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "tests/support/robots.hpp"

namespace abstand::physics {
namespace box_lcp_test {

using testing::randomValues;

// Rounding, amplified by the condition of A (below a thousand).
constexpr double kExact = 1e-9;

BoxLcp randomProblem(Eigen::Index n, std::uint64_t seed) {
  BoxLcp p;
  p.reserve(n);
  const auto v = randomValues(static_cast<int>(n * n + 4 * n), seed, 0, 1.0);
  const Eigen::MatrixXd B = Eigen::Map<const Eigen::MatrixXd>(v.data(), n, n);
  p.A = B * B.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double* mine = v.data() + n * n + 4 * i;
    p.b[i] = 3.0 * mine[0];
    p.lower[i] = mine[1] > 0.3 ? -kInfinity : -std::abs(mine[2]);
    p.upper[i] = mine[1] < -0.3 ? kInfinity : std::abs(mine[3]);
  }
  return p;
}

void expectSolution(const BoxLcp& p, Eigen::Index n) {
  const Eigen::VectorXd w = p.A.topLeftCorner(n, n) * p.x.head(n) - p.b.head(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    EXPECT_GE(p.x[i], p.lower[i] - kExact);
    EXPECT_LE(p.x[i], p.upper[i] + kExact);
    EXPECT_TRUE(p.x[i] <= p.lower[i] + kExact || w[i] <= kExact) << w[i];
    EXPECT_TRUE(p.x[i] >= p.upper[i] - kExact || w[i] >= -kExact) << w[i];
  }
}

TEST(BoxLcp, IsSolvedAtAnySize) {
  for (const Eigen::Index n : {1, 2, 3, 7, 20, 60})
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      SCOPED_TRACE(::testing::Message() << n << " " << seed);
      BoxLcp p = randomProblem(n, seed);
      EXPECT_TRUE(solveBoxLcp(p, n));
      expectSolution(p, n);
    }
}

TEST(BoxLcp, MatchesExhaustiveSearch) {
  constexpr Eigen::Index kRows = 4;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    BoxLcp p = randomProblem(kRows, seed);
    ASSERT_TRUE(solveBoxLcp(p, kRows));
    int found = 0;
    for (int sides = 0; sides < 81; ++sides) {
      // Digit 0: at the lower bound, 1: between, 2: at the upper.
      Eigen::MatrixXd A = p.A;
      Eigen::VectorXd b = p.b;
      int rest = sides;
      std::array<int, kRows> side{};
      bool possible = true;
      for (Eigen::Index i = 0; i < kRows; ++i, rest /= 3) {
        side[static_cast<std::size_t>(i)] = rest % 3;
        if (rest % 3 == 1) continue;
        A.row(i).setZero();
        A(i, i) = 1.0;
        b[i] = rest % 3 == 0 ? p.lower[i] : p.upper[i];
        possible = possible && std::isfinite(b[i]);
      }
      if (!possible) continue;
      const Eigen::VectorXd x = A.partialPivLu().solve(b), w = p.A * x - p.b;
      for (Eigen::Index i = 0; i < kRows; ++i) {
        const int s = side[static_cast<std::size_t>(i)];
        possible = possible && x[i] >= p.lower[i] - kExact && x[i] <= p.upper[i] + kExact &&
                   (s != 0 || w[i] >= -kExact) && (s != 2 || w[i] <= kExact);
      }
      if (!possible) continue;
      ++found;
      EXPECT_LT((x - p.x).norm(), 1e-6);
    }
    EXPECT_GE(found, 1);
  }
}

TEST(BoxLcp, EqualRowsShareSolution) {
  // Two joints that mimic each other, at their stops at once; of equal and of different urgency.
  for (const double second : {1.0, 0.5}) {
    BoxLcp p;
    p.reserve(2);
    p.A.setOnes();
    p.b << 1.0, second;
    p.lower.setZero();
    p.upper.setConstant(kInfinity);
    EXPECT_TRUE(solveBoxLcp(p, 2));
    EXPECT_NEAR(p.x.sum(), 1.0, kExact) << second;
    EXPECT_GE(p.x.minCoeff(), 0.0);
  }
}

}  // namespace box_lcp_test
}  // namespace abstand::physics
