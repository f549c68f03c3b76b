// The last moments of a served scene, for going back.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace abstand::viewer {

struct RingLimits {
  double seconds{600.0};                      ///< older moments are dropped
  std::size_t bytes{std::size_t{512} << 20};  ///< of the frames; beyond it, the oldest are dropped
};

/// Frames by time, each as it was received. Not shared between threads.
class MomentRing {
 public:
  explicit MomentRing(const RingLimits& limits = {}) : limits_(limits) {}

  /// Rate (Hz) at which moments of at most `frame_bytes` fit into the limits, at most `wanted`.
  static double rateFor(const RingLimits& limits, std::size_t frame_bytes, double wanted);

  /// `t`: s. A moment that is not later than the newest is passed over (false).
  bool add(double t, std::span<const std::byte> frame);
  void clear();

  bool empty() const { return kept_.empty(); }
  std::size_t size() const { return kept_.size(); }
  /// Of the frames.
  std::size_t bytes() const { return bytes_; }
  /// Number of the oldest one that is kept, and one more than the newest; numbers stay with their moment.
  std::size_t begin() const { return dropped_; }
  std::size_t end() const { return dropped_ + kept_.size(); }
  double time(std::size_t number) const { return kept_[number - dropped_].t; }
  std::span<const std::byte> frame(std::size_t number) const { return kept_[number - dropped_].bytes; }
  /// Number of the latest moment at or before `t`, or of the oldest one; nothing if it is empty.
  std::optional<std::size_t> at(double t) const;

 private:
  struct Kept {
    double t;
    std::vector<std::byte> bytes;
  };
  RingLimits limits_;
  std::deque<Kept> kept_;
  std::size_t bytes_{0}, dropped_{0};
};

}  // namespace abstand::viewer
