// What every engine of the benchmarks can be asked.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "tests/bench/bench_scene.hpp"

namespace abstand::bench {

enum class Work {
  kDistance,  ///< the signed distance of every pair
  kContact,   ///< penetration depth, and force or contact points, of every pair; 0 of pairs apart
  kCollide,   ///< whether a pair touches: 1 or 0
  kSmallest   ///< the smallest distance of all pairs, one number
};

/// One number of a frame. `bound`: how much smaller the truth may be, certified; NaN where nobody says.
struct Answer {
  double value{kNaN};
  double bound{kNaN};
};

/// One engine with one scene, used by one thread. Between frames it may remember what it likes.
class Engine {
 public:
  virtual ~Engine() = default;
  /// Takes all poses (of each body, in world), then answers all pairs, or one number for kSmallest.
  /// `answers` has the right size.
  virtual void frame(const Transform* X_WB, Work work, std::span<Answer> answers) = 0;
};

enum class Kind { kAbstand, kFcl, kBullet };
inline constexpr Kind kKinds[] = {Kind::kAbstand, Kind::kFcl, Kind::kBullet};
std::string_view kindName(Kind kind);

std::unique_ptr<Engine> openAbstand(const BenchScene& scene);
/// FCL: triangle trees (OBBRSS) in double, exact on the meshes; with more than one pair its tree of boxes
/// finds the pairs that may touch.
std::unique_ptr<Engine> openFcl(const BenchScene& scene);
/// Bullet: GJK and EPA on the convex hulls of the meshes, which start from the last separating axis; pairs
/// whose boxes are apart are left out where only contact counts.
std::unique_ptr<Engine> openBullet(const BenchScene& scene);

/// The engine of a kind; null for one that this program was built without.
std::unique_ptr<Engine> open(Kind kind, const BenchScene& scene);
bool available(Kind kind);

/// Branch and bound over pairs: `gap(i)` is certain to be no larger than the distance of pair i, `query(i)`
/// is the distance. Pairs are asked in the order of their gaps until a gap says that the rest is farther.
class SmallestSearch {
 public:
  explicit SmallestSearch(std::size_t pairs) : order_(pairs) {}
  template <class Gap, class Query>
  Answer find(Gap&& gap, Query&& query);

 private:
  struct Candidate {
    double gap;
    std::size_t pair;
    bool operator<(const Candidate& other) const { return gap > other.gap; }  // the smallest on top
  };
  std::vector<Candidate> order_;
};

template <class Gap, class Query>
Answer SmallestSearch::find(Gap&& gap, Query&& query) {
  for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = {gap(i), i};
  std::make_heap(order_.begin(), order_.end());
  Answer least{kInfinity, 0.0};
  for (auto end = order_.end(); end != order_.begin() && order_.front().gap < least.value; --end) {
    const Answer a = query(order_.front().pair);
    if (a.value < least.value) least = a;
    std::pop_heap(order_.begin(), end);
  }
  return least;
}

}  // namespace abstand::bench
