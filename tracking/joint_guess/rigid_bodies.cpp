#include "tracking/joint_guess/rigid_bodies.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {

PointDistances::PointDistances(std::span<const PointFrame> frames, std::span<const int> points)
    : n_{points.size()}, mean_(n_ * n_, kInfinity), deviation_(n_ * n_, kInfinity) {
  for (std::size_t a = 0; a < n_; ++a)
    for (std::size_t b = a + 1; b < n_; ++b) {
      double mean = 0.0, squares = 0.0;  // as in Welford 1962
      int count = 0;
      for (const PointFrame& f : frames) {
        const double d =
            (f.p[static_cast<std::size_t>(points[a])] - f.p[static_cast<std::size_t>(points[b])]).norm();
        if (!std::isfinite(d)) continue;
        ++count;
        const double off = d - mean;
        mean += off / count;
        squares += off * (d - mean);
      }
      if (count == 0) continue;
      mean_[a * n_ + b] = mean_[b * n_ + a] = mean;
      deviation_[a * n_ + b] = deviation_[b * n_ + a] = std::sqrt(squares / count);
    }
}

double PointDistances::extent() const {
  double extent = 0.0;
  for (const double d : mean_)
    if (std::isfinite(d)) extent = std::max(extent, d);
  return extent;
}

std::vector<std::vector<int>> rigidBodies(const PointDistances& distances, double tolerance) {
  const std::size_t n = distances.size();
  struct Pair {
    std::size_t a, b;
  };
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      if (distances.deviation(a, b) <= tolerance) pairs.push_back({a, b});
  std::stable_sort(pairs.begin(), pairs.end(), [&](const Pair& p, const Pair& q) {
    return distances.mean(p.a, p.b) < distances.mean(q.a, q.b);
  });
  std::vector<char> covered(n * n, 0);
  std::vector<std::vector<int>> bodies;
  for (const Pair& pair : pairs) {
    if (covered[pair.a * n + pair.b]) continue;
    std::vector<int> body{static_cast<int>(pair.a), static_cast<int>(pair.b)};
    // The nearest points first, which most likely belong to the same body.
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < n; ++i)
      if (i != pair.a && i != pair.b) others.push_back(i);
    const auto away = [&](std::size_t i) { return distances.mean(i, pair.a) + distances.mean(i, pair.b); };
    std::stable_sort(others.begin(), others.end(),
                     [&](std::size_t i, std::size_t k) { return away(i) < away(k); });
    for (const std::size_t i : others)
      if (std::all_of(body.begin(), body.end(), [&](int k) {
            return distances.deviation(i, static_cast<std::size_t>(k)) <= tolerance;
          }))
        body.push_back(static_cast<int>(i));
    for (const int a : body)
      for (const int b : body) covered[static_cast<std::size_t>(a) * n + static_cast<std::size_t>(b)] = 1;
    bodies.push_back(std::move(body));
  }
  return bodies;
}

}  // namespace abstand::tracking
