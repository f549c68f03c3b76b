#include "core/physics/box_lcp.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::physics {
namespace {

// Share of a row's diagonal entry: a smaller pivot is the rounding of a row that depends on others (mimic
// joints at their stops). Such rows share the solution, and contradicting rows end at their bounds.
constexpr double kDependent = 1e-13;

/// Solves for the rows between their bounds, with the others fixed: L L^T = A of these rows.
void solveFree(BoxLcp& p, Eigen::Index n) {
  p.free.clear();
  for (Eigen::Index i = 0; i < n; ++i) {
    const int side = p.side[static_cast<std::size_t>(i)];
    if (side == 0)
      p.free.push_back(i);
    else
      p.x[i] = side < 0 ? p.lower[i] : p.upper[i];
  }
  const auto m = static_cast<Eigen::Index>(p.free.size());
  const auto row = [&](Eigen::Index r) { return p.free[static_cast<std::size_t>(r)]; };
  for (Eigen::Index r = 0; r < m; ++r) {
    double rest = p.b[row(r)];
    for (Eigen::Index i = 0; i < n; ++i)
      if (p.side[static_cast<std::size_t>(i)] != 0) rest -= p.A(row(r), i) * p.x[i];
    for (Eigen::Index c = 0; c <= r; ++c) {
      double sum = p.A(row(r), row(c));
      for (Eigen::Index k = 0; k < c; ++k) sum -= p.L(r, k) * p.L(c, k);
      p.L(r, c) =
          r == c ? std::sqrt(std::max({sum, kDependent * p.A(row(r), row(r)), 1e-300})) : sum / p.L(c, c);
      if (c < r) rest -= p.L(r, c) * p.y[c];
    }
    p.y[r] = rest / p.L(r, r);
  }
  for (Eigen::Index r = m; r-- > 0;) {
    double sum = p.y[r];
    for (Eigen::Index k = r + 1; k < m; ++k) sum -= p.L(k, r) * p.x[row(k)];
    p.x[row(r)] = sum / p.L(r, r);
  }
}

/// Side of row i for the present x.
int wantedSide(const BoxLcp& p, Eigen::Index n, Eigen::Index i) {
  const int side = p.side[static_cast<std::size_t>(i)];
  if (side == 0) return p.x[i] < p.lower[i] ? -1 : p.x[i] > p.upper[i] ? 1 : 0;
  double w = -p.b[i], size = std::abs(p.b[i]);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double term = p.A(i, k) * p.x[k];
    w += term;
    size += std::abs(term);
  }
  // Prevents a row at rest at its bound from changing sides forever by rounding.
  const double rounding = 1e-14 * size;
  return (side < 0 ? w < -rounding : w > rounding) ? 0 : side;
}

}  // namespace

void BoxLcp::reserve(Eigen::Index max_size) {
  A.setZero(max_size, max_size);
  L.setZero(max_size, max_size);
  for (Eigen::VectorXd* v : {&b, &lower, &upper, &x, &y}) v->setZero(max_size);
  side.assign(static_cast<std::size_t>(max_size), 0);
  free.reserve(static_cast<std::size_t>(max_size));
}

bool solveBoxLcp(BoxLcp& p, Eigen::Index n) {
  ABSTAND_CHECK(n <= p.b.size());
  std::fill(p.side.begin(), p.side.begin() + n, 0);
  constexpr Eigen::Index kBlockRounds = 10;
  for (Eigen::Index round = 0; round < 50 + 20 * n; ++round) {
    solveFree(p, n);
    bool right = true;
    for (Eigen::Index i = n; i-- > 0;) {
      const int wanted = wantedSide(p, n, i);
      int& side = p.side[static_cast<std::size_t>(i)];
      if (wanted == side) continue;
      right = false;
      side = wanted;
      if (round >= kBlockRounds) break;
    }
    if (right) return true;
  }
  for (Eigen::Index i = 0; i < n; ++i) p.x[i] = std::clamp(p.x[i], p.lower[i], p.upper[i]);
  return false;
}

}  // namespace abstand::physics
