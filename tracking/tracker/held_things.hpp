// Things in a person's hands.
#pragma once

#include <vector>

#include "tracking/tracker/depth_fit.hpp"

namespace abstand::tracking {

/// Things larger than a fist that a person holds: surfaces assigned to the person that no segment explains,
/// connected to a hand. A surface that stands on the floor, such as a chair, is held only if it has moved
/// with the hand. The camera sees its front alone; it is assumed to be as deep as the smaller of its two
/// visible extents.
///
/// Noticed in kNoticed of the last kWindow images in which the hand or the thing was seen, or in kKept if the
/// other hand holds something, which may be the same thing. Forgotten after kMemory images in which none, or
/// always fewer than kKept of the window, showed it. Its extent is the largest one of the last kMemory
/// images: where an arm is fitted to a part of the thing, only the rest of it is left. Not shared between
/// threads. see() does not allocate after the first image, and does not throw.
class HeldThings {
 public:
  /// m, by which the thing in the left and the right hand extends beyond the hand in any direction; 0: none.
  using Extents = std::array<double, 2>;

  HeldThings() = default;
  /// Starts with what is known of the first images.
  explicit HeldThings(const Extents& at_start);

  /// Learns from a body that was fitted to the observation; `visible`: share of each segment that is seen.
  void see(const BodyObservation& seen, const DepthFit& fit, const RigPlacement& X_WS,
           const std::array<double, kRigSegments>& visible);
  /// After see(): the largest extents in the memory.
  const Extents& extent() const { return extent_; }
  /// Extents of the things that were noticed in the first kFirst images.
  const Extents& atStart() const { return at_start_; }

  static constexpr int kWindow = 16, kNoticed = 10, kKept = 3, kMemory = 60, kFirst = 60;
  static constexpr double kFist = 0.09;  ///< m beyond the hand; smaller things are part of it

 private:
  /// Unexplained surface that is connected to a hand.
  struct Surface {
    std::size_t points{0};  ///< clearly not on the body
    Vector3d middle{Vector3d::Zero()};
    double lowest{kInfinity};  ///< m, z
    double extent{0.0};        ///< m
  };
  struct Hand {
    std::array<float, kMemory> extents{};  ///< m, of the last images; 0: no thing
    int next{0};
    bool holds{false}, moved{false};
    int without{0};     ///< images in a row that hardly showed it
    int shown() const;  ///< number of the last kWindow images that showed a thing
    Vector3d hand_from{Vector3d::Constant(kNaN)}, thing_from{hand_from};  ///< where the surface appeared
  };
  void connect(const BodyObservation& seen, const DepthFit& fit, const RigPlacement& X_WS, RigSegment hand);
  Surface measure(const BodyObservation& seen, const Vector3d& middle, double thickness) const;
  static bool isHeld(const Surface& surface, const Vector3d& p_hand, Hand& hand);

  std::array<Hand, 2> hands_;
  Extents extent_{}, at_start_{};
  int images_{0};
  std::vector<float> score_;
  std::vector<std::size_t> apart_, joined_;  ///< indices of points: unexplained; connected to the hand
};

}  // namespace abstand::tracking
