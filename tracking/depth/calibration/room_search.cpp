// Search for all poses in which two cameras see the same room.
#include "tracking/depth/calibration/room_search.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "tracking/depth/calibration/cloud_registration.hpp"

namespace abstand::tracking {
namespace {

constexpr double kRoomFurtherTurn = unit::deg(15.0);  // of further starts
constexpr std::size_t kRoomStartPoints = 1500;        // of each camera, until a pose is found
constexpr double kRoomFirstGate = 0.15;               // m
// Of acceptable poses, before the last steps with all points.
constexpr double kRoomHardly = kRoomMinAgreeing - 0.05;
// m, between displaced starts, about half of the shortest period that is found: along the weakest direction,
// and in the plane.
constexpr double kRoomShift = 0.1, kRoomSideShift = 0.2;

class RoomSearch {
 public:
  RoomSearch(const RoomView& known, const RoomView& camera)
      : rows_{known, camera}, middle_C_{camera.middle()} {}

  /// A start near which the pose may be, also a bad one.
  void add(const Transform& X_WC) {
    const Transform end = rows_.from(X_WC, kRoomFirstGate, kRoomStartPoints);
    const double cost = rows_.cost(end);
    if (cost < smallest_cost_) {
      smallest_cost_ = cost;
      cheapest_ = end;
    }
    keep(end);
  }

  /// A start in whose neighbourhood parts of the room may be repeated.
  void addDisplaced(const Transform& X_WC) { keep(rows_.from(X_WC, kRoomFirstGate, kRoomStartPoints)); }

  const RoomCandidate* best() const {
    const RoomCandidate* best = nullptr;
    for (const RoomCandidate& c : found_)
      if (isAcceptable(c) && (!best || unexplained(c.agreement) < unexplained(best->agreement))) best = &c;
    return best;
  }

  /// Two unit vectors (world): the translations that the matched surfaces determine least, weakest first.
  std::array<Vector3d, 2> weakDirections(const Transform& X_WC) const {
    const SurfaceSum sum = rows_.at(X_WC, RoomRows::kLastGate, RoomRows::kSomePoints);
    const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(Matrix3d(sum.JTJ.topLeftCorner<3, 3>()));
    return {axes.eigenvectors().col(0), axes.eigenvectors().col(1)};
  }

  std::vector<RoomCandidate> candidates() const {
    std::vector<RoomCandidate> all = found_;
    if (all.empty()) all.push_back(settled(cheapest_));
    return all;
  }

 private:
  void keep(const Transform& X_WC) {
    if (isKnown(X_WC) || rows_.agreement(X_WC, kRoomStartPoints).agreeing < kRoomHardly) return;
    const RoomCandidate c = settled(X_WC);
    if (!isKnown(c.X_WC)) found_.push_back(c);
  }

  bool isKnown(const Transform& X_WC) const {
    return std::any_of(found_.begin(), found_.end(), [&](const RoomCandidate& c) {
      return apart(c.X_WC, X_WC, middle_C_) < 0.5 * kRoomElsewhere;
    });
  }

  RoomCandidate settled(const Transform& X_WC) const {
    return judgeRoomPose(rows_, rows_.from(X_WC, RoomRows::kLastGate, RoomRows::kSomePoints));
  }

  RoomRows rows_;
  Vector3d middle_C_;
  std::vector<RoomCandidate> found_;
  Transform cheapest_{Transform::Identity()};
  double smallest_cost_{kInfinity};
};

std::vector<Vector3d> positionsOf(const RoomView& view) {
  std::vector<Vector3d> points;
  for (const RoomPoint& point : view.points()) points.push_back(point.p_C);
  return points;
}

/// The start, and the start rotated to both sides about each axis of the camera.
std::vector<Transform> startsAround(const Transform& X_WC) {
  std::vector<Transform> starts{X_WC};
  for (int axis = 0; axis < 3; ++axis)
    for (const double turn : {kRoomFurtherTurn, -kRoomFurtherTurn})
      starts.push_back(X_WC * Eigen::AngleAxisd(turn, Vector3d::Unit(axis)));
  return starts;
}

/// Displacements (m) in a plane: a line along its first axis, and a square.
std::vector<Vector3d> shiftsIn(const std::array<Vector3d, 2>& axes) {
  std::vector<Vector3d> shifts;
  const auto add = [&](double reach, double beside, double step) {
    const int last = static_cast<int>(std::lround(reach / step));
    for (int i = -last; i <= last; ++i)
      if (i != 0 || beside != 0.0) shifts.push_back(i * step * axes[0] + beside * axes[1]);
  };
  add(kRoomAlong, 0.0, kRoomShift);
  for (const int side : {-2, -1, 1, 2}) add(kRoomBeside, side * kRoomSideShift, kRoomSideShift);
  return shifts;
}

}  // namespace

std::vector<RoomCandidate> searchRoom(const RoomView& known, const RoomView& camera) {
  RoomSearch search(known, camera);
  const Transform &start = camera.camera().X_WC, &X_WK = known.camera().X_WC;
  const CloudRegistration clouds(positionsOf(camera), positionsOf(known));
  for (const Transform& X_WC : startsAround(start)) search.add(X_WK * clouds.align(X_WK.inverse() * X_WC));
  search.add(start);
  const RoomCandidate* found = search.best();
  if (!found) return search.candidates();
  const Transform X_WC = found->X_WC;
  for (const Vector3d& shift : shiftsIn(search.weakDirections(X_WC))) {
    Transform shifted = X_WC;
    shifted.translation() += shift;
    search.addDisplaced(shifted);
  }
  return search.candidates();
}

}  // namespace abstand::tracking
