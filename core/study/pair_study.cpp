#include "core/study/pair_study.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/parallel.hpp"
#include "core/study/pair_postures.hpp"

namespace abstand::study {
namespace {

constexpr std::size_t kBlock = 32;  // samples in one unit of work of a thread
constexpr std::size_t kFirstRound =
    256;  // samples; each round is this many times larger than the one before:
constexpr std::size_t kRoundGrowth = 4;
constexpr long kMaxSamples = 100000000;

// Steps of the search, in rad or m of the joint that moves most.
constexpr double kFirstStep = 0.2, kMinStep = 1e-4;
constexpr double kFirstProbe = 0.1, kMinProbe = 1e-3;
constexpr int kMaxQueries = 400;
constexpr double kGain = 1e-9;  // m; smaller decreases do not count

/// A posture and the pair's distance in it.
struct Near {
  double distance{kInfinity}, bound{0.0};
  std::vector<double> q;
};

/// Result of a block of samples for one pair.
struct BlockPair {
  long hits{0}, overlaps{0};
  Near nearest;
};

/// State of one pair in the study.
struct Work {
  StudiedPair pair;
  long overlaps{0};
  bool searched{false};       ///< searched from all of `nearest`, or until the first collision
  std::vector<Near> nearest;  ///< the best posture of each block, nearest first; at most `searches`
};

bool isOver(const Work& w) { return w.pair.hits > 0 && w.overlaps < w.pair.samples; }

class PairStudy {
 public:
  PairStudy(const StudyModel& model, const std::vector<std::pair<int, int>>& pairs,
            const StudyOptions& options)
      : model_(model), options_(options) {
    for (const auto& [a, b] : pairs) {
      ABSTAND_CHECK(a >= 0 && a < b && b < static_cast<int>(model.bodies().size()));
      Work w;
      w.pair.a = a;
      w.pair.b = b;
      w.pair.dofs = model.dofsBetween(a, b);
      work_.push_back(std::move(w));
    }
  }

  std::vector<StudiedPair> run() {
    for (std::size_t done = 0, round = kFirstRound; done < static_cast<std::size_t>(options_.samples);
         round *= kRoundGrowth) {
      const std::size_t count = std::min(round, static_cast<std::size_t>(options_.samples) - done);
      sample(done, count);
      done += count;
      if (stopped()) break;
    }
    search();
    std::vector<StudiedPair> out;
    for (auto& w : work_) {
      w.pair.verdict = verdictOf(w);
      out.push_back(std::move(w.pair));
    }
    return out;
  }

 private:
  PairVerdict verdictOf(const Work& w) const {
    if (isOver(w) || w.pair.by_search) return PairVerdict::kSometimes;
    const bool moves = !w.pair.dofs.empty();
    const bool sampled = w.pair.samples >= (moves ? options_.samples : 1);
    const bool searched = !moves || w.pair.hits > 0 || options_.searches == 0 || w.searched;
    if (!sampled || !searched) return PairVerdict::kUndecided;
    return w.pair.hits == 0 ? PairVerdict::kNever : PairVerdict::kAlways;
  }

  bool stopped() const { return options_.interrupted && options_.interrupted(); }

  /// Takes samples `first` to first + count - 1 of all undecided pairs. A block uses only results of earlier
  /// rounds and its own, so the result does not depend on the assignment to threads.
  void sample(std::size_t first, std::size_t count) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < work_.size(); ++i)
      // Bodies that do not move relative to each other need one posture.
      if (!isOver(work_[i]) && !(work_[i].pair.dofs.empty() && work_[i].pair.samples > 0)) open.push_back(i);
    if (open.empty()) return;
    const std::size_t blocks = (count + kBlock - 1) / kBlock;
    std::vector<std::vector<BlockPair>> found(blocks);
    std::atomic<std::size_t> done{0};
    parallelFor(options_.threads, blocks, [&](std::size_t block) {
      if (stopped()) return;
      const std::size_t begin = first + block * kBlock, end = std::min(begin + kBlock, first + count);
      found[block] = sampleBlock(begin, end, open);
      if (options_.progress) {
        done += end - begin;
        const std::scoped_lock lock(progress_mutex_);
        options_.progress(first + done, static_cast<std::size_t>(options_.samples));
      }
    });
    for (std::size_t i = 0; i < open.size(); ++i) {
      Work& w = work_[open[i]];
      for (std::size_t b = 0; b < blocks; ++b) {
        auto& block = found[b];
        if (block.empty()) continue;  // interrupted before this block
        w.pair.samples += static_cast<long>(std::min(kBlock, count - b * kBlock));
        w.pair.hits += block[i].hits;
        w.overlaps += block[i].overlaps;
        if (!block[i].nearest.q.empty()) insertNearest(std::move(block[i].nearest), w);
      }
    }
  }

  std::vector<BlockPair> sampleBlock(std::size_t begin, std::size_t end,
                                     const std::vector<std::size_t>& open) const {
    std::vector<BlockPair> found(open.size());
    StudyPosture posture(model_);
    std::vector<double> q(model_.dof());
    for (std::size_t s = begin; s < end; ++s) {
      Random random(options_.seed, s);
      mechanism::randomPosture(model_.ranges(), random, q);
      posture.set(q);
      for (std::size_t i = 0; i < open.size(); ++i) {
        const StudiedPair& pair = work_[open[i]].pair;
        BlockPair& best = found[i];
        // Farther than the nearest so far and no collision: skips the query.
        const double gap = posture.gap(pair.a, pair.b);
        if (gap > options_.clearance && gap > std::min(best.nearest.distance, worstStored(work_[open[i]])))
          continue;
        const query::PairResult& r = posture.query(pair.a, pair.b);
        if (r.distance - r.bound <= options_.clearance) ++best.hits;
        if (r.distance <= 0.0) ++best.overlaps;
        if (r.distance < best.nearest.distance) best.nearest = {r.distance, r.bound, q};
      }
    }
    return found;
  }

  /// Distances not below this are not kept.
  double worstStored(const Work& w) const {
    const bool full = w.nearest.size() >= static_cast<std::size_t>(std::max(options_.searches, 1));
    return full ? w.nearest.back().distance : kInfinity;
  }

  void insertNearest(Near near, Work& w) const {
    if (near.distance < w.pair.distance) {
      w.pair.distance = near.distance;
      w.pair.bound = near.bound;
      w.pair.posture = near.q;
    }
    const std::size_t max_count = static_cast<std::size_t>(std::max(options_.searches, 1));
    const auto at = std::upper_bound(w.nearest.begin(), w.nearest.end(), near.distance,
                                     [](double d, const Near& n) { return d < n.distance; });
    if (at == w.nearest.end() && w.nearest.size() >= max_count) return;
    w.nearest.insert(at, std::move(near));
    if (w.nearest.size() > max_count) w.nearest.pop_back();
  }

  /// Searches counter-examples for the pairs without a collision.
  void search() {
    if (options_.searches == 0 || stopped()) return;
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < work_.size(); ++i)
      if (work_[i].pair.hits == 0 && !work_[i].pair.dofs.empty()) open.push_back(i);
    std::atomic<std::size_t> done{0};
    parallelFor(options_.threads, open.size(), [&](std::size_t i) {
      Work& w = work_[open[i]];
      StudyPosture posture(model_);
      for (const Near& start : w.nearest) {
        if (stopped()) return;
        if (w.pair.by_search) break;
        const Near end = descend(w.pair, start, posture);
        if (end.distance < w.pair.distance) {
          w.pair.distance = end.distance;
          w.pair.bound = end.bound;
          w.pair.posture = end.q;
        }
        w.pair.by_search = isHit(end);
      }
      w.searched = true;
      if (options_.progress) {
        const std::scoped_lock lock(progress_mutex_);
        options_.progress(++done, open.size());
      }
    });
  }

  bool isHit(const Near& n) const { return n.distance - n.bound <= options_.clearance; }

  /// Replaces `best` by the posture `q` if the pair is nearer in it.
  bool acceptIfNearer(const StudiedPair& pair, std::vector<double> q, StudyPosture& posture,
                      Near& best) const {
    posture.set(q);
    const query::PairResult& r = posture.query(pair.a, pair.b);
    if (!(r.distance < best.distance - kGain)) return false;
    best = {r.distance, r.bound, std::move(q)};
    return true;
  }

  double clamped(int dof, double value) const {
    const mechanism::JointRange& range = model_.ranges()[static_cast<std::size_t>(dof)];
    return std::clamp(value, range.lower, range.upper);
  }

  Near descend(const StudiedPair& pair, const Near& start, StudyPosture& posture) const {
    Near best = start;
    int queries = 0;
    double probe = kFirstProbe;
    while (queries < kMaxQueries && !isHit(best) && probe >= kMinProbe) {
      queries += followGradient(pair, posture, best);
      if (isHit(best)) break;
      bool nearer = false;
      for (const int dof : pair.dofs)
        for (const double step : {probe, -probe}) {
          auto q = best.q;
          double& value = q[static_cast<std::size_t>(dof)];
          const double moved = clamped(dof, value + step);
          if (moved == value) continue;
          value = moved;
          ++queries;
          if (acceptIfNearer(pair, std::move(q), posture, best)) {
            nearer = true;
            break;
          }
        }
      if (!nearer) probe *= 0.3;
    }
    return best;
  }

  /// Gradient descent. Returns the number of queries.
  int followGradient(const StudiedPair& pair, StudyPosture& posture, Near& best) const {
    std::vector<double> gradient(model_.dof());
    double step = kFirstStep;
    int queries = 0;
    while (step >= kMinStep && queries < kMaxQueries && !isHit(best)) {
      std::fill(gradient.begin(), gradient.end(), 0.0);
      posture.set(best.q);
      posture.query(pair.a, pair.b);
      ++queries;
      if (!posture.addGradient(pair.a, pair.b, gradient)) return queries;
      // Joints held by a limit do not contribute to the direction.
      double steepest = 0.0;
      for (const int dof : pair.dofs) {
        double& g = gradient[static_cast<std::size_t>(dof)];
        const double value = best.q[static_cast<std::size_t>(dof)];
        if (clamped(dof, value - g) == value) g = 0.0;
        steepest = std::max(steepest, std::abs(g));
      }
      if (steepest < 1e-9) return queries;
      bool nearer = false;
      for (; step >= kMinStep && !nearer; step *= 0.5) {
        auto q = best.q;
        for (const int dof : pair.dofs) {
          const auto i = static_cast<std::size_t>(dof);
          q[i] = clamped(dof, q[i] - step / steepest * gradient[i]);
        }
        ++queries;
        nearer = acceptIfNearer(pair, std::move(q), posture, best);
      }
      if (nearer) step *= 4.0;  // undoes the last halving of the loop
    }
    return queries;
  }

  const StudyModel& model_;
  const StudyOptions& options_;
  std::vector<Work> work_;
  std::mutex progress_mutex_;
};

}  // namespace

void StudyOptions::validate() const {
  if (samples < 1 || samples > kMaxSamples)
    throw UsageError("samples " + std::to_string(samples) + ": expected 1 to " + std::to_string(kMaxSamples));
  if (searches < 0 || searches > 1000)
    throw UsageError("searches " + std::to_string(searches) + ": expected 0 to 1000");
  if (!std::isfinite(clearance) || clearance < 0.0 || clearance > 10.0)
    throw UsageError("clearance " + formatDouble(clearance) + ": expected 0 to 10 m");
}

std::vector<StudiedPair> studyPairs(const std::vector<StudyMechanism>& mechanisms,
                                    const std::vector<StudyBody>& bodies,
                                    const std::vector<std::pair<int, int>>& pairs,
                                    const StudyOptions& options) {
  options.validate();
  const StudyModel model(mechanisms, bodies);
  return PairStudy(model, pairs, options).run();
}

}  // namespace abstand::study
