// Made-up recordings of several parts and links whose numbers a store keeps exactly.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "core/margin/clearance_store.hpp"

namespace abstand::margin {

struct StoredPairs {
  std::shared_ptr<StoreLayout> layout = std::make_shared<StoreLayout>();
  std::vector<double> t;
  std::vector<PairSample> samples;  ///< frame by frame

  std::size_t pairs() const { return layout->pairs.size(); }
  const PairSample& at(std::size_t frame, std::size_t pair) const { return samples[frame * pairs() + pair]; }
  /// The frames of one part, with the nearest of its links.
  ClearanceTrack track(std::size_t part) const {
    ClearanceTrack track;
    track.t = t;
    for (std::size_t i = 0; i < t.size(); ++i) {
      double least[3] = {kInfinity, kInfinity, kInfinity};
      for (std::size_t p = 0; p < pairs(); ++p) {
        if (layout->pairs[p].part != part) continue;
        const double of[3] = {at(i, p).clearance, at(i, p).between, at(i, p).braking};
        for (int k = 0; k < 3; ++k) least[k] = std::min(least[k], of[k]);
      }
      track.clearance.push_back(least[0]);
      track.between.push_back(least[1]);
      track.braking.push_back(least[2]);
    }
    return track;
  }
  ClearanceStore store(double limit = 0.0) const {
    ClearanceStore store(layout);
    ChunkWriter writer(layout, limit);
    for (std::size_t i = 0; i < t.size(); ++i)
      if (auto chunk = writer.add(t[i], std::span(samples).subspan(i * pairs(), pairs()))) store.add(chunk);
    if (auto chunk = writer.finish()) store.add(chunk);
    return store;
  }
};

/// Objects 0 to parts - 1 are parts, the others links. Lengths are multiples of 2^-10 m.
inline StoredPairs storedPairs(std::uint32_t seed, std::size_t parts, std::size_t links, std::size_t frames) {
  StoredPairs pairs;
  for (std::size_t k = 0; k < parts; ++k)
    pairs.layout->parts.push_back({"person/part" + std::to_string(k), k, k});
  for (std::size_t l = 0; l < links; ++l)
    pairs.layout->links.push_back({"arm/link" + std::to_string(l), parts + l, 0});
  for (std::size_t k = 0; k < parts; ++k)
    for (std::size_t l = 0; l < links; ++l)
      pairs.layout->pairs.push_back({static_cast<std::uint16_t>(k), static_cast<std::uint16_t>(l)});
  std::mt19937 random(seed);
  std::normal_distribution<double> step(0.0, 0.03);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto exact = [](double value) { return std::ldexp(std::round(std::ldexp(value, 10)), -10); };
  std::vector<double> base(parts, 0.6), beside(parts * links);
  for (double& b : beside) b = 0.5 * uniform(random);
  std::vector<int> unseen(parts, 0);
  for (std::size_t i = 0; i < frames; ++i) {
    pairs.t.push_back(0.01 * static_cast<double>(i));
    for (std::size_t k = 0; k < parts; ++k) {
      base[k] = std::clamp(base[k] + step(random), -0.1, 1.2);
      if (uniform(random) < 0.002) unseen[k] = static_cast<int>(40.0 * uniform(random));
      const bool lost = unseen[k] > 0 && unseen[k]-- > 20;
      const bool seen = unseen[k] == 0 || lost;
      for (std::size_t l = 0; l < links; ++l) {
        double& b = beside[k * links + l];
        b = std::clamp(b + 0.5 * step(random), 0.0, 0.7);
        PairSample s;
        s.clearance = seen ? exact(base[k] + b) : -kInfinity;
        s.uncertainty = seen ? 0.0078125 : kInfinity;
        s.distance = exact(base[k] + b) + 0.015625;
        s.between = uniform(random) < 0.002 ? exact(base[k] - 0.5) : s.clearance - 0.0048828125;
        s.braking = uniform(random) < 0.05 ? exact(base[k] - 0.3) : kInfinity;
        s.closing = 0.25;
        s.lost = lost;
        if (i + 1 == frames) s.between = kInfinity;
        pairs.samples.push_back(s);
      }
    }
  }
  return pairs;
}

}  // namespace abstand::margin
