// Comparison of the surfaces that two cameras see.
#include "tracking/depth/calibration/room_rows.hpp"

#include <algorithm>
#include <cmath>

#include "tracking/depth/calibration/depth_noise.hpp"

namespace abstand::tracking {
namespace {

constexpr double kRoomCostTolerance = 0.03;  // m
constexpr double kRoomAgree = 0.8;           // smallest cosine between the normals of both cameras
constexpr int kRoomSteps = 40;
constexpr double kSmallRoomStep = 1e-6;
// Standard deviations of the depth by which a surface is clearly behind a point; kLastGate at least.
constexpr double kRoomPastNoise = 4.0;

std::size_t strideOf(const RoomView& view, std::size_t points) {
  return std::max<std::size_t>(1, view.points().size() / points);
}

}  // namespace

/// Sums over the compared points.
struct RoomRows::Tally {
  double points{0.0}, agree{0.0}, through{0.0}, past{0.0}, weights{0.0};
  Vector3d middle{Vector3d::Zero()};  ///< m, about which the rotations are taken
  double width{0.0};                  ///< m, SurfaceSum::width
  Matrix6d products{Matrix6d::Zero()};
};

/// Compares point `p` of `from` with the surface of `to`. The row: moves of `from` against `to`.
RoomRows::Seen RoomRows::compare(const RoomPoint& p, const PlacedView& from, const PlacedView& to,
                                 double gate, SurfaceRow& row) {
  row.p_W = from.X_WC * p.p_C;
  const RoomPoint* q = to.view.at(to.X_WC.inverse() * row.p_W);
  if (!q || !q->smooth()) return Seen::kNot;
  const Vector3d n_p = from.X_WC.linear() * p.n_C;
  row.n_W = to.X_WC.linear() * q->n_C;
  const Vector3d d = row.p_W - to.X_WC * q->p_C;
  row.distance = row.n_W.dot(d);
  const double noise = std::max(depthNoiseAt(p.p_C.z()), depthNoiseAt(q->p_C.z()));
  row.weight = std::pow(depthNoiseAt(1.0) / std::max(noise, depthNoiseAt(1.0)), 2);
  if (std::abs(row.distance) < gate && n_p.dot(row.n_W) > kRoomAgree) return Seen::kAgrees;
  return row.distance > 0.0 ? Seen::kThrough : Seen::kHidden;
}

/// Whether the view sees surfaces clearly behind a point at its pixel and at the eight around it: not at an
/// edge, where a pixel of error decides what is seen.
bool RoomRows::seesPast(const Vector3d& p_W, const PlacedView& to) {
  const Vector3d p_C = to.X_WC.inverse() * p_W;
  const double past = p_C.z() + std::max(kLastGate, kRoomPastNoise * depthNoiseAt(p_C.z()));
  const double pixel = p_C.z() * to.view.pixel();
  for (int v = -1; v <= 1; ++v)
    for (int u = -1; u <= 1; ++u) {
      const RoomPoint* q = to.view.at(p_C + pixel * Vector3d(u, v, 0.0));
      if (!q || !(q->p_C.z() > past)) return false;
    }
  return true;
}

void RoomRows::collect(const PlacedView& from, const PlacedView& to, double gate, std::size_t points,
                       double side, std::vector<SurfaceRow>& rows) {
  const std::vector<RoomPoint>& all = from.view.points();
  SurfaceRow row;
  for (std::size_t i = 0; i < all.size(); i += strideOf(from.view, points)) {
    if (compare(all[i], from, to, gate, row) != Seen::kAgrees) continue;
    // A step of the camera moves its surface, not the points of the known one.
    row.n_W *= side;
    rows.push_back(row);
  }
}

SurfaceSum RoomRows::at(const Transform& X_WC, double gate, std::size_t points) const {
  std::vector<SurfaceRow> rows;
  const PlacedView camera{camera_, X_WC}, known{known_, known_.camera().X_WC};
  collect(camera, known, gate, points, 1.0, rows);
  collect(known, camera, gate, points, -1.0, rows);
  return sumOf(rows);
}

Transform RoomRows::from(Transform X_WC, double gate, std::size_t points) const {
  for (int i = 0; i < kRoomSteps; ++i) {
    const double part = gate > kLastGate ? std::min(1.0, static_cast<double>(i) / (0.5 * kRoomSteps)) : 1.0;
    const SurfaceSum sum = at(X_WC, gate * std::pow(kLastGate / gate, part), points);
    if (sum.rows <= 6) return X_WC;
    const std::optional<Vector6d> step = stepOf(sum);
    if (!step) return X_WC;
    X_WC = movedAbout(sum.middle, X_WC, *step);
    if (part == 1.0 && step->norm() < kSmallRoomStep) break;
  }
  return X_WC;
}

double RoomRows::cost(const Transform& X_WC) const {
  double sum = 0.0, seen = 0.0;
  const auto add = [&](const PlacedView& from, const PlacedView& to) {
    SurfaceRow row;
    for (std::size_t i = 0; i < from.view.points().size(); i += strideOf(from.view, kSomePoints)) {
      const Seen how = compare(from.view.points()[i], from, to, kRoomCostTolerance, row);
      if (how == Seen::kNot) continue;
      ++seen;
      // What is far behind a surface may be hidden by it.
      const bool may_hide = how == Seen::kHidden && row.distance < -4.0 * kRoomCostTolerance;
      sum += how == Seen::kAgrees ? std::abs(row.distance) : (may_hide ? 0.7 : 1.0) * kRoomCostTolerance;
    }
  };
  const PlacedView camera{camera_, X_WC}, known{known_, known_.camera().X_WC};
  add(camera, known);
  add(known, camera);
  return seen > 0.0 ? sum / seen : kInfinity;
}

void RoomRows::count(const PlacedView& from, const PlacedView& to, std::size_t points, Tally& tally) {
  const std::vector<RoomPoint>& all = from.view.points();
  SurfaceRow row;
  for (std::size_t i = 0; i < all.size(); i += strideOf(from.view, points)) {
    const Seen how = compare(all[i], from, to, kLastGate, row);
    ++tally.points;
    tally.through += how == Seen::kThrough;
    if (how != Seen::kAgrees) {
      tally.past += seesPast(row.p_W, to);
      continue;
    }
    ++tally.agree;
    const Vector3d n_W = from.X_WC.linear() * all[i].n_C, arm = row.p_W - tally.middle;
    Vector6d one, other;
    one << n_W, arm.cross(n_W);
    other << row.n_W, arm.cross(row.n_W);
    const double part = row.distance / tally.width;
    const double weight = row.weight / ((1.0 + part * part) * (1.0 + part * part));
    tally.products += 0.5 * weight * (one * other.transpose() + other * one.transpose());
    tally.weights += weight;
  }
}

RoomAgreement RoomRows::agreement(const Transform& X_WC, std::size_t points, const SurfaceSum& sum) const {
  const PlacedView camera{camera_, X_WC}, known{known_, known_.camera().X_WC};
  Tally all;
  all.middle = sum.middle;
  all.width = sum.width;
  count(camera, known, points, all);
  RoomAgreement result;
  result.shared = all.points > 0.0 ? all.agree / all.points : 0.0;
  count(known, camera, points, all);
  if (!(all.agree > 0.0)) return result;
  result.agreeing = all.agree / (all.agree + all.through);
  result.seen_through = all.past / (all.agree + all.past);
  result.weakest = weakestConstraint(all.products / all.weights);
  return result;
}

}  // namespace abstand::tracking
