// Comparison of the surfaces that two cameras see.
#pragma once

#include "tracking/depth/calibration/room_view.hpp"
#include "tracking/depth/calibration/surface_rows.hpp"

namespace abstand::tracking {

/// How well one pose of a camera explains what both cameras see.
struct RoomAgreement {
  double shared{0.0};        ///< share of the camera's surface that the known camera sees, too
  double agreeing{0.0};      ///< share of the surface in free view of both cameras on which both agree
  double seen_through{0.0};  ///< share of the surface of either camera that the other one clearly sees past
  /// weakestConstraint() of the matched points by the product of the normals that both cameras measured:
  /// their noise is independent, so it does not seem to determine what the surfaces leave undetermined.
  double weakest{0.0};
};

/// Points of two cameras, each compared with the surface in the pixel of the other camera. The views must
/// outlive this object.
class RoomRows {
 public:
  RoomRows(const RoomView& known, const RoomView& camera) : known_{known}, camera_{camera} {}

  /// Rows of at most about `points` points of each camera that agree within `gate` (m).
  SurfaceSum at(const Transform& X_WC, double gate, std::size_t points) const;
  /// Gauss-Newton result, with a gate (m) that shrinks to kLastGate.
  Transform from(Transform X_WC, double gate, std::size_t points) const;
  /// m, mean distance of the points of both cameras that the other one sees, truncated.
  double cost(const Transform& X_WC) const;
  RoomAgreement agreement(const Transform& X_WC, std::size_t points) const {
    return agreement(X_WC, points, at(X_WC, kLastGate, points));
  }
  /// The same; `sum`: that of at() with kLastGate.
  RoomAgreement agreement(const Transform& X_WC, std::size_t points, const SurfaceSum& sum) const;

  static constexpr double kLastGate = 0.05;            // m
  static constexpr std::size_t kAllPoints = 1u << 30;  // of each camera
  static constexpr std::size_t kSomePoints = 6000;     // of each camera, to compare poses

 private:
  enum class Seen { kNot, kAgrees, kHidden, kThrough };
  struct PlacedView {
    const RoomView& view;
    const Transform& X_WC;
  };
  struct Tally;
  static Seen compare(const RoomPoint& p, const PlacedView& from, const PlacedView& to, double gate,
                      SurfaceRow& row);
  static bool seesPast(const Vector3d& p_W, const PlacedView& to);
  static void collect(const PlacedView& from, const PlacedView& to, double gate, std::size_t points,
                      double side, std::vector<SurfaceRow>& rows);
  static void count(const PlacedView& from, const PlacedView& to, std::size_t points, Tally& tally);

  const RoomView &known_, &camera_;
};

}  // namespace abstand::tracking
