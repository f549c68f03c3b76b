// Furniture and walls in plan view: flat surfaces that are larger than any of a person.
#pragma once

#include <vector>

#include "core/math/random.hpp"
#include "tracking/depth/people/plan_view.hpp"

namespace abstand::tracking {

/// Three kinds of things are furniture: sheer surfaces below 0.75 m, straight in plan view and at least 0.6 m
/// broad without a gap, or 0.44 m if they end at one height between 0.7 and 1 m (benches and their ends,
/// cupboards; if higher than 1 m: walls, with all that continues them if they are higher than 1.9 m or the
/// image cuts them off; if higher than 0.7 m, with what continues them at the same height within 1 m, as
/// behind somebody), level ones between 0.3 and 1.2 m of at least 0.3 m^2 (tables), and pillars, which are at
/// least 1 m high and as broad and deep at the floor as at the top (sheerShare). Legs are no such front,
/// since there is a gap between them, and a bowed back is smaller. Chairs are smaller, too, and not found
/// (ChairSpace, ThingsBeside).
///
/// Not shared between threads. find() does not allocate or throw.
class Furniture {
 public:
  Furniture();
  /// Adds what is found to what the last ten images had; returns whether there is any. After plan.join().
  /// What was found in six images stays while its top is seen at the same height, or furniture or its
  /// background lies within 0.3 m, as below a hand that rests on a bench. So does a cell that lasting
  /// furniture surrounds.
  bool find(const PlanView& plan);
  bool any() const { return !marked_.empty(); }
  /// Before find(): learned background lies in this cell at `height` (m above the floor).
  void noteBackground(int cell, float height);
  /// m above the floor: surface of this cell below that height is furniture; 0: none is.
  float topOf(int cell) const { return top_[static_cast<std::size_t>(cell)]; }

 private:
  void findFronts(const PlanView& plan, std::span<const int> component);
  struct FrontLine;
  FrontLine longestFront(const PlanView& plan, Random& random);
  void markWall(const PlanView& plan, const FrontLine& line);
  void markLevel(const PlanView& plan, const FrontLine& line, float top);
  void findLevels(const PlanView& plan, std::span<const int> component);
  void mark(int cell, float top);
  bool isKept(int cell) const;
  void fillHoles();

  std::vector<float> top_;           ///< m, of every cell
  std::vector<std::uint8_t> age_;    ///< images since a cell was last found to be furniture
  std::vector<std::uint8_t> found_;  ///< images in which it was, up to 255
  std::vector<std::uint32_t> seen_;  ///< image in which it was last found, or was background
  std::uint32_t image_{1};
  std::vector<int> marked_, filled_, sheer_, chosen_;
  std::vector<std::uint8_t> beside_;  ///< lasting neighbours of each cell
  std::vector<float> tops_;
  std::vector<std::array<float, 3>> line_;  ///< m^2 in the lowest slabs, by cells along a line
};

}  // namespace abstand::tracking
