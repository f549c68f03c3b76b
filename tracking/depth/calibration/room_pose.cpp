// Camera pose from the room that a camera with known pose sees, too.
#include "tracking/depth/calibration/room_pose.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "tracking/depth/calibration/cloud_registration.hpp"
#include "tracking/depth/calibration/depth_noise.hpp"
#include "tracking/depth/calibration/refuse.hpp"
#include "tracking/depth/calibration/surface_rows.hpp"

namespace abstand::tracking {
namespace {

constexpr double kRoomStartTurn = unit::deg(15.0);  // of further starts
constexpr std::size_t kRoomStartPoints = 1500;      // of each camera, until the best start is known
constexpr std::size_t kRoomCostPoints = 6000;       // of each camera
constexpr std::size_t kRoomAllPoints = 1u << 30;
constexpr double kRoomCostTolerance = 0.03;                    // m
constexpr double kRoomFirstGate = 0.15, kRoomLastGate = 0.05;  // m
constexpr double kRoomAgree = 0.8;  // smallest cosine between the normals of both cameras
constexpr int kRoomSteps = 40;
constexpr double kSmallRoomStep = 1e-6;
constexpr std::size_t kRoomMinPoints = 1000;
constexpr double kRoomMinAgreeing = 0.85;
constexpr double kRoomMaxRms = 0.02;  // m
// Smallest weakestConstraint(). Measured: a floor, a wall or both up to 0.013 in single images, in which
// noisy normals seem to determine what they do not; rooms with a floor and two walls 0.047 and more.
constexpr double kRoomMinConstraint = 0.015;

/// Comparison of a point with the surface of the other camera at its pixel.
enum class Seen { kNot, kAgrees, kHidden, kThrough };

class RoomRows {
 public:
  RoomRows(const RoomView& known, const RoomView& camera) : known_{known}, camera_{camera} {}

  /// Compares point `p` of `from`, at X_WF, with the surface of `to`, at X_WT. The row: moves of `from`
  /// against `to`.
  static Seen compare(const RoomPoint& p, const Transform& X_WF, const RoomView& to, const Transform& X_WT,
                      double gate, SurfaceRow& row) {
    row.p_W = X_WF * p.p_C;
    const RoomPoint* q = to.at(X_WT.inverse() * row.p_W);
    if (!q || !q->smooth()) return Seen::kNot;
    const Vector3d n_p = X_WF.linear() * p.n_C;
    row.n_W = X_WT.linear() * q->n_C;
    const Vector3d d = row.p_W - X_WT * q->p_C;
    row.distance = row.n_W.dot(d);
    const double noise = std::max(depthNoiseAt(p.p_C.z()), depthNoiseAt(q->p_C.z()));
    row.weight = std::pow(depthNoiseAt(1.0) / std::max(noise, depthNoiseAt(1.0)), 2);
    if (std::abs(row.distance) < gate && n_p.dot(row.n_W) > kRoomAgree) return Seen::kAgrees;
    return row.distance > 0.0 ? Seen::kThrough : Seen::kHidden;
  }

  SurfaceSum at(const Transform& X_WC, double gate, std::size_t points) const {
    std::vector<SurfaceRow> rows;
    const PlacedView camera{camera_, X_WC}, known{known_, known_.camera().X_WC};
    collect(camera, known, gate, points, 1.0, rows);
    collect(known, camera, gate, points, -1.0, rows);
    return sumOf(rows);
  }

  Transform from(Transform X_WC, double gate, std::size_t points) const {
    for (int i = 0; i < kRoomSteps; ++i) {
      const double part = std::min(1.0, static_cast<double>(i) / (0.5 * kRoomSteps));
      const SurfaceSum sum = at(X_WC, gate * std::pow(kRoomLastGate / gate, part), points);
      if (sum.rows <= 6) return X_WC;
      const std::optional<Vector6d> step = stepOf(sum);
      if (!step) return X_WC;
      X_WC = movedAbout(sum.middle, X_WC, *step);
      if (part == 1.0 && step->norm() < kSmallRoomStep) break;
    }
    return X_WC;
  }

  /// Mean distance (m) of the points of both cameras that the other one sees, truncated at
  /// kRoomCostTolerance.
  double cost(const Transform& X_WC) const {
    double sum = 0.0, seen = 0.0;
    const auto add = [&](const RoomView& from, const Transform& X_WF, const RoomView& to,
                         const Transform& X_WT) {
      const std::size_t stride = std::max<std::size_t>(1, from.points().size() / kRoomCostPoints);
      SurfaceRow row;
      for (std::size_t i = 0; i < from.points().size(); i += stride) {
        const Seen how = compare(from.points()[i], X_WF, to, X_WT, kRoomCostTolerance, row);
        if (how == Seen::kNot) continue;
        ++seen;
        // What is far behind a surface may be hidden by it.
        const bool may_hide = how == Seen::kHidden && row.distance < -4.0 * kRoomCostTolerance;
        sum += how == Seen::kAgrees ? std::abs(row.distance) : (may_hide ? 0.7 : 1.0) * kRoomCostTolerance;
      }
    };
    add(camera_, X_WC, known_, known_.camera().X_WC);
    add(known_, known_.camera().X_WC, camera_, X_WC);
    return seen > 0.0 ? sum / seen : kInfinity;
  }

  /// Fills shared and agreeing.
  void compareAll(RoomFit& fit) const {
    double agree = 0.0, through = 0.0, all = 0.0, own = 0.0;
    const auto add = [&](const RoomView& from, const Transform& X_WF, const RoomView& to,
                         const Transform& X_WT, bool is_own) {
      SurfaceRow row;
      for (const RoomPoint& p : from.points()) {
        const Seen how = compare(p, X_WF, to, X_WT, kRoomLastGate, row);
        agree += how == Seen::kAgrees;
        through += how == Seen::kThrough;
        if (is_own) ++all, own += how == Seen::kAgrees;
      }
    };
    add(camera_, fit.X_WC, known_, known_.camera().X_WC, true);
    add(known_, known_.camera().X_WC, camera_, fit.X_WC, false);
    fit.shared = all > 0.0 ? own / all : 0.0;
    fit.agreeing = agree + through > 0.0 ? agree / (agree + through) : 0.0;
  }

 private:
  struct PlacedView {
    const RoomView& view;
    const Transform& X_WC;
  };
  static void collect(const PlacedView& from, const PlacedView& to, double gate, std::size_t points,
                      double side, std::vector<SurfaceRow>& rows) {
    const std::vector<RoomPoint>& all = from.view.points();
    const std::size_t stride = std::max<std::size_t>(1, all.size() / points);
    SurfaceRow row;
    for (std::size_t i = 0; i < all.size(); i += stride) {
      if (compare(all[i], from.X_WC, to.view, to.X_WC, gate, row) != Seen::kAgrees) continue;
      // A step of the camera moves its surface, not the points of the known one.
      row.n_W *= side;
      rows.push_back(row);
    }
  }

  const RoomView &known_, &camera_;
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
    for (const double turn : {kRoomStartTurn, -kRoomStartTurn})
      starts.push_back(X_WC * Eigen::AngleAxisd(turn, Vector3d::Unit(axis)));
  return starts;
}

/// Throws UsageError if the pose is not certain.
void refuseDoubtful(const RoomFit& fit) {
  if (fit.points < kRoomMinPoints)
    refuse(
        "--room: found %zu points that both cameras see, expected %zu or more: their views do not overlap, "
        "or "
        "the camera's start is more than 0.2 m or 20 degrees off",
        fit.points, kRoomMinPoints);
  if (!(fit.agreeing >= kRoomMinAgreeing))
    refuse(
        "--room: found that the cameras agree on %.0f %% of their common view, expected %.0f %% or more: the "
        "room has changed between the recordings, or the camera's start is more than 0.2 m or 20 degrees off",
        100.0 * fit.agreeing, 100.0 * kRoomMinAgreeing);
  if (!(fit.weakest >= kRoomMinConstraint))
    throw UsageError(
        "--room: found surfaces that do not determine every degree of freedom of the camera, as a floor and "
        "one "
        "wall do, expected surfaces with three directions in the common view");
  if (!(fit.rms <= kRoomMaxRms))
    refuse(
        "--room: found an RMS distance of %.0f mm between the surfaces of the cameras, expected %.0f or "
        "less: "
        "the intrinsics are wrong, or the room has changed",
        1e3 * fit.rms, 1e3 * kRoomMaxRms);
}

}  // namespace

RoomFit fitPoseToRoom(const RoomView& known, const RoomView& camera) {
  const RoomRows rows(known, camera);
  const Transform& X_WK = known.camera().X_WC;
  const Transform& start = camera.camera().X_WC;
  const CloudRegistration clouds(positionsOf(camera), positionsOf(known));
  RoomFit best;
  double smallest_cost = kInfinity;
  for (const Transform& X_WC : startsAround(start)) {
    const Transform end =
        rows.from(X_WK * clouds.align(X_WK.inverse() * X_WC), kRoomFirstGate, kRoomStartPoints);
    const double cost = rows.cost(end);
    if (!(cost < smallest_cost)) continue;
    smallest_cost = cost;
    best.X_WC = end;
  }
  best.X_WC = rows.from(best.X_WC, kRoomLastGate, kRoomAllPoints);
  const SurfaceSum sum = rows.at(best.X_WC, kRoomLastGate, kRoomAllPoints);
  rows.compareAll(best);
  best.points = sum.rows;
  best.weakest = sum.rows > 0 ? weakestConstraint(sum.JTJ / sum.weights) : 0.0;
  best.rms = std::sqrt(sum.squares / sum.weights);
  const Transform moved = start.inverse() * best.X_WC;
  best.moved = moved.translation().norm();
  best.turned = Eigen::AngleAxisd(moved.linear()).angle();
  refuseDoubtful(best);
  const Vector3d to_camera = best.X_WC.translation() - sum.middle;
  best.spread = std::hypot(best.rms, spreadWithin(covarianceOf(sum), to_camera), known.camera().spread);
  return best;
}

}  // namespace abstand::tracking
