// A stretch of a recording with the clearances of all body parts, small enough to keep an hour of it.
#pragma once

#include <memory>
#include <span>

#include "core/margin/clearance_track.hpp"
#include "core/margin/half_float.hpp"
#include "core/margin/packed_column.hpp"
#include "core/margin/store_layout.hpp"

namespace abstand::margin {

/// Up to kFrames frames, of each part the nearest link and those links that are hardly farther. Everything is
/// rounded to the safe side. Constant after construction; every function is safe from any thread.
class ClearanceChunk {
 public:
  static constexpr std::size_t kFrames = 256, kBlock = 16;
  /// m. Links that stay farther than the nearest one by this in all frames of the chunk have no values of
  /// their own, and others are kept in steps of kStep: margins of links that differ by no more than kBeside
  /// are judged as if the links were nearer by less than kStep; those that are equal are judged exactly.
  static constexpr double kStep = 1.0 / 1024.0, kBeside = 255.0 * kStep;

  /// `samples`: of each pair in each frame, frame by frame. `judged`: the first frame from which on all parts
  /// can be judged (firstJudgedFrame).
  ClearanceChunk(const StoreLayout& layout, std::vector<double> t, std::span<const PairSample> samples,
                 std::size_t judged);

  std::size_t frames() const { return t_.size(); }
  double t(std::size_t frame) const { return t_[frame]; }  ///< s
  std::size_t judged() const { return judged_; }
  /// m, certified, to the nearest link; -infinity: not seen.
  double clearance(std::size_t part, std::size_t frame) const { return parts_[part].clearance[frame]; }
  /// Not seen, or the pose is stale or was rejected.
  bool unknown(std::size_t part, std::size_t frame) const { return parts_[part].unknown[frame] != 0; }

  /// Of a part and its nearest link. Lengths in m; what is one-sided errs as in PairSample.
  struct Nearest {
    double clearance, distance, uncertainty, between, braking;
    double closing;  ///< m/s
    std::uint16_t link;
    bool unknown;
  };
  Nearest nearest(std::size_t part, std::size_t frame) const;
  double between(std::size_t part, std::size_t frame) const { return fromHalf(parts_[part].between[frame]); }
  double braking(std::size_t part, std::size_t frame) const { return fromHalf(parts_[part].braking[frame]); }

  /// Certainly not above the clearance (m) of a pair, by its number in StoreLayout::pairs.
  double pairClearance(std::size_t pair, std::size_t frame) const;

  /// Of the whole chunk, m.
  struct Summary {
    double least{kInfinity}, largest{-kInfinity};  ///< clearance
    double between{kInfinity};                     ///< least
    bool unknown{false};                           ///< in some frame
  };
  const Summary& summary(std::size_t part) const { return parts_[part].all; }
  /// m: the least known clearance of the frames of a block; +infinity: none is known.
  double blockMinimum(std::size_t part, std::size_t block) const { return parts_[part].blocks[block]; }

  /// Of all parts together, m.
  double leastClearance(std::size_t frame) const { return clearance_[frame]; }
  double minBetween(std::size_t frame) const { return between_[frame]; }
  double leastBraking(std::size_t frame) const { return braking_[frame]; }
  /// Least clearance, and what is between, of all parts and frames.
  double least() const { return least_; }
  double minBetween() const { return min_between_; }

  std::size_t bytes() const;

 private:
  struct Part {
    std::vector<float> clearance;
    PackedColumn<HalfBits> between, braking, error, uncertainty, closing;
    PackedColumn<std::uint16_t> link;
    PackedColumn<std::uint8_t> unknown;
    std::vector<float> blocks;
    Summary all;
  };
  struct Pair {
    std::uint16_t part{0};
    double least{kInfinity};  ///< m, of the chunk
    /// kStep, at most kBeside, above the part's clearance; null: kBeside everywhere.
    std::unique_ptr<PackedColumn<std::uint8_t>> above;
  };
  Part partOf(const StoreLayout& layout, std::size_t part, std::span<const PairSample> samples) const;
  Pair pairOf(const StoreLayout& layout, std::size_t pair, std::span<const PairSample> samples) const;
  void takeAll(std::span<const PairSample> samples, std::size_t pairs);

  std::vector<double> t_;
  std::size_t judged_{0};
  std::vector<Part> parts_;
  std::vector<Pair> pairs_;
  std::vector<float> clearance_, between_, braking_;
  double least_{kInfinity}, min_between_{kInfinity};
};

/// Gathers frames into chunks. One thread.
class ChunkWriter {
 public:
  /// `limit`: m, MarginOptions::limit.
  ChunkWriter(std::shared_ptr<const StoreLayout> layout, double limit);

  /// The samples of the pairs at `t` (s), which rises. Returns a chunk that became full, or null.
  std::shared_ptr<const ClearanceChunk> add(double t, std::span<const PairSample> samples);
  /// The last chunk, or null.
  std::shared_ptr<const ClearanceChunk> finish();

 private:
  void judge(std::span<const PairSample> samples);

  std::shared_ptr<const StoreLayout> layout_;
  double limit_;
  std::vector<double> t_;
  std::vector<PairSample> samples_;
  std::vector<bool> kind_judged_;
  std::vector<double> kind_braking_;
  bool all_judged_{false};
  std::size_t judged_{0};
};

}  // namespace abstand::margin
