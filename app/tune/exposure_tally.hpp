// Accumulates exposure while a recording is run.
#pragma once

#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "app/tune/approach.hpp"
#include "app/tune/exposure.hpp"

namespace abstand::tune {

/// Receives every frame of a pass. Memory does not grow with the recording's length. One thread.
class ExposureTally {
 public:
  /// Names of a watched pair: indices in PassResult::parts and links.
  struct Names {
    std::uint16_t part, link;
  };
  /// `names`: of each pair; `near`: m, PassOptions::near. Session and pairs must outlive this object.
  ExposureTally(const session::Session& session, const std::vector<WatchedPair>& pairs,
                std::span<const Names> names, double near);

  /// Adds a frame that represents `duration` (s), until the next one. `motions`: of the pairs; `nearest`: for
  /// each part the pair with the smallest clearance.
  void frame(const WindowFrame& frame, double duration, std::span<const ClosingMotion> motions,
             std::span<const std::size_t> nearest);
  PassExposure finish();

 private:
  void noteClosing(const WindowFrame& frame, std::span<const ClosingMotion> motions);
  void takeClearances(const WindowFrame& frame, double duration, std::span<const std::size_t> nearest);
  void takeCells(const WindowFrame& frame, double duration, std::span<const std::size_t> nearest);
  void drawOutlines(const WindowFrame& frame);

  /// Sort key of floor cells.
  using FloorKey = std::tuple<FloorLayer, int, int>;
  struct Least {
    double clearance{kInfinity};
    std::uint16_t part{0}, link{0};
    bool seen{true};
  };
  void take(Least& least, const WindowFrame& frame, std::size_t pair) const;

  const session::Session& session_;
  const std::vector<WatchedPair>& pairs_;
  double near_;
  std::vector<Names> slots_;                 ///< all parts and links with a pair
  std::vector<std::size_t> slot_of_;         ///< of each watched pair; equal for the same part of two people
  std::vector<Vector3d> half_extent_;        ///< m, of each pair's part
  std::vector<std::size_t> min_of_slot_;     ///< pair with the smallest clearance in this frame
  std::vector<Least> min_of_link_;           ///< in this frame
  std::vector<margin::ExposureTime> cells_;  ///< kCellCount for each part
  std::map<FloorKey, margin::ExposureTime> floor_;
  std::vector<std::pair<FloorKey, double>> in_frame_;  ///< floor cells of this frame with their clearance
  PassExposure result_;
};

}  // namespace abstand::tune
