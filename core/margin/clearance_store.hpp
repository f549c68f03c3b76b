// The clearances of a recording, as far as they are there.
#pragma once

#include "core/margin/clearance_chunk.hpp"

namespace abstand::margin {

/// Chunks in order of time. One thread; chunks may be shared with others.
class ClearanceStore {
 public:
  explicit ClearanceStore(std::shared_ptr<const StoreLayout> layout) : layout_(std::move(layout)) {}

  const StoreLayout& layout() const { return *layout_; }
  /// Every chunk but the last one is full.
  void add(std::shared_ptr<const ClearanceChunk> chunk);

  bool empty() const { return chunks_.empty(); }
  std::size_t frames() const { return frames_; }
  const std::vector<std::shared_ptr<const ClearanceChunk>>& chunks() const { return chunks_; }
  double t(std::size_t frame) const;  ///< s
  /// The last frame at or before `t` (s); the first one for earlier times.
  std::size_t frameAt(double t) const;
  ClearanceChunk::Nearest nearest(std::size_t part, std::size_t frame) const;

  /// A part in the frames [begin, end).
  struct Look {
    double least{kInfinity};  ///< m, of the known clearances; +infinity: there is none
    bool unknown{false};      ///< in some of them it is not known, or they are not there yet
  };
  Look look(std::size_t part, std::size_t begin, std::size_t end) const;
  /// The frame of [begin, end) with the least clearance; the first of equal ones.
  std::size_t leastFrame(std::size_t part, std::size_t begin, std::size_t end) const;
  std::size_t bytes() const;

 private:
  std::shared_ptr<const StoreLayout> layout_;
  std::vector<std::shared_ptr<const ClearanceChunk>> chunks_;
  std::size_t frames_{0};
};

}  // namespace abstand::margin
