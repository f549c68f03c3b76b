#include "tracking/markers/marker_calibration.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

using enum RigSegment;

constexpr double kStatedSpread = 0.01;  // of a known stature
constexpr double kStatureSpread = 0.10, kBoneSpread = 0.05, kBreadthSpread = 0.08;
constexpr double kMinSize = 0.4, kMaxSize = 2.0;  // of the base, each size
constexpr double kIndependentMoments = 10.0;
constexpr std::size_t kFirstMoments = 6;
constexpr double kCalibrationAtRest = 1e-5;  // m, of a marker; shares, of a size
constexpr double kMaxLost = 0.2;             // share of misplaced markers at which a new pose search starts
constexpr double kMinStiff = 0.05;           // 1/rad^2, as in the solver's damping
constexpr int kCalibrationSteps = 12;        // pose steps between two changes of the body
// Robust scale: decreases from wide to that of single frames, then stays until convergence.
constexpr double kFirstReach = 0.50, kSecondReach = 0.12, kLastReach = 0.05;  // m
constexpr double kNarrower = 0.7;                                             // factor in each round
constexpr int kMaxRounds = 40;
// Limits of the changes of a size and of a marker position in one round, as the linearisation is inaccurate
// far from the solution.
constexpr double kMaxSizeStep = 0.08, kMaxShiftStep = 0.04;  // shares, m

using Dense = Eigen::MatrixXd;
constexpr int kSizeCount = static_cast<int>(kBodySizes);

/// Position of the base's marker, scaled with its segment.
Vector3d grown(const FoundMarker& m, const SizeVector& sizes) {
  return growth(m.segment, sizes).cwiseProduct(m.p_S);
}

/// The body and a pose for each moment; each round improves both.
class Calibration {
 public:
  Calibration(const BodyRig& base, std::span<const FoundMarker> found, std::optional<double> stature)
      : base_{base}, found_{found}, shift_(found.size(), Vector3d::Zero()) {
    if (stature) {
      usual_[0] = std::clamp(*stature / base.height, kMinSize, kMaxSize);
      stature_spread_ = kStatedSpread * usual_[0];
    }
    body_.sizes = usual_;
    remake();
  }

  /// Sets the moments to fit from now on.
  void addMoments(std::vector<const MarkerPlaces*> moments, double reach) {
    moments_ = std::move(moments);
    poses_.assign(moments_.size(), RigPose{});
    const PoseHold hold = restHold();
    MarkerSolver solver(body_.rig);
    for (std::size_t f = 0; f < moments_.size(); ++f) {
      MarkerPose found;
      found.misplaced = 1;
      if (f > 0)
        found = solver.solve(body_.markers, *moments_[f], poses_[f - 1], hold, reach, 3 * kCalibrationSteps);
      if (found.misplaced > kMaxLost * found.seen) found = solver.search(body_.markers, *moments_[f], hold);
      poses_[f] = found.pose;
    }
  }

  /// One round; returns the largest change.
  double improve(double reach) {
    const PoseHold hold = restHold();
    const int all = kSizeCount + 3 * static_cast<int>(found_.size());
    Dense H = Dense::Zero(all, all);
    Eigen::VectorXd g = Eigen::VectorXd::Zero(all);
    MarkerSolver solver(body_.rig);
    const double share = std::min(1.0, kIndependentMoments / static_cast<double>(moments_.size()));
    Dense across(all, kRigDof);
    for (std::size_t f = 0; f < moments_.size(); ++f) {
      const MarkerPlaces& seen = *moments_[f];
      poses_[f] = solver.solve(body_.markers, seen, poses_[f], hold, reach, kCalibrationSteps).pose;
      RigPlacement X_WS;
      place(body_.rig, poses_[f], X_WS);
      across.setZero();
      BodySolver::Vector slope = BodySolver::Vector::Zero();
      for (std::size_t k = 0; k < found_.size(); ++k) {
        if (!std::isfinite(seen[k].x())) continue;
        const RigSegment s = found_[k].segment;
        const Matrix3d R_WS = X_WS[index(s)].linear();
        const Vector3d p_W = X_WS[index(s)] * body_.markers[k].p_S;
        const Vector3d off = p_W - seen[k];
        const double w = share * markerWeight(off.norm(), reach);
        const auto J_size = sizeJacobian(base_, X_WS, s, found_[k].p_S);
        const auto J_pose = solver.problem().jacobian(s, p_W);
        const int at = kSizeCount + 3 * static_cast<int>(k);
        H.topLeftCorner<kSizeCount, kSizeCount>() += w * J_size.transpose() * J_size;
        H.block<kSizeCount, 3>(0, at) += w * J_size.transpose() * R_WS;
        H.block<3, kSizeCount>(at, 0) += w * R_WS.transpose() * J_size;
        H.block<3, 3>(at, at) += w * Matrix3d::Identity();
        g.head<kSizeCount>() += w * J_size.transpose() * off;
        g.segment<3>(at) += w * R_WS.transpose() * off;
        across.topRows<kSizeCount>() += w * J_size.transpose() * J_pose;
        across.middleRows<3>(at) += w * R_WS.transpose() * J_pose;
        slope += w * J_pose.transpose() * off;
      }
      // The pose adapts to every change of the body: that part is not a misfit.
      BodySolver::Matrix inner = share * solver.information();
      inner.diagonal().array() += share * kMinStiff;
      const Eigen::LLT<BodySolver::Matrix> llt(inner);
      if (llt.info() != Eigen::Success) continue;
      const Dense follow = llt.solve(across.transpose());
      H.noalias() -= across * follow;
      g.noalias() -= follow.transpose() * slope;
    }
    addPriors(H, g);
    Eigen::VectorXd d = -H.ldlt().solve(g);
    if (!d.allFinite()) return 0.0;
    const double size_step = d.head<kSizeCount>().cwiseAbs().maxCoeff();
    const double shift_step = d.tail(all - kSizeCount).cwiseAbs().maxCoeff();
    d *= std::min({1.0, kMaxSizeStep / size_step, kMaxShiftStep / shift_step});
    apply(d);
    return d.cwiseAbs().maxCoeff();
  }

  MarkerBody release() && { return std::move(body_); }

 private:
  PoseHold restHold() const {
    PoseHold hold;
    hold.to_rest = restWeights(body_.rig, body_.markers);
    return hold;
  }

  void addPriors(Dense& H, Eigen::VectorXd& g) const {
    for (int i = 0; i < kSizeCount; ++i) {
      const auto size = static_cast<BodySize>(i);
      const bool is_breadth = size == BodySize::kHips || size == BodySize::kShoulders;
      const double spread = size == BodySize::kStature ? stature_spread_
                            : is_breadth               ? kBreadthSpread
                                                       : kBoneSpread;
      const double w = 1.0 / (spread * spread);
      H(i, i) += w;
      g(i) += w * (body_.sizes[i] - usual_[i]);
    }
    for (std::size_t k = 0; k < found_.size(); ++k) {
      const double w = 1.0 / (found_[k].spread * found_[k].spread);
      const int at = kSizeCount + 3 * static_cast<int>(k);
      H.diagonal().segment<3>(at).array() += w;
      g.segment<3>(at) += w * shift_[k];
    }
  }

  void apply(const Eigen::VectorXd& d) {
    body_.sizes += d.head<kSizeCount>();
    body_.sizes[0] = std::clamp(body_.sizes[0], kMinSize, kMaxSize);
    for (int i = 1; i < kSizeCount; ++i)
      body_.sizes[i] = std::clamp(body_.sizes[i], kMinSize - body_.sizes[0], kMaxSize - body_.sizes[0]);
    for (std::size_t k = 0; k < found_.size(); ++k)
      shift_[k] += d.segment<3>(kSizeCount + 3 * static_cast<int>(k));
    remake();
  }

  void remake() {
    body_.rig = resized(base_, body_.sizes);
    body_.markers.resize(found_.size());
    for (std::size_t k = 0; k < found_.size(); ++k)
      body_.markers[k] = {found_[k].segment, grown(found_[k], body_.sizes) + shift_[k]};
  }

  const BodyRig& base_;
  std::span<const FoundMarker> found_;
  std::vector<Vector3d> shift_;  ///< offset of each marker from the set's position, m
  SizeVector usual_{sameSizes()};
  double stature_spread_{kStatureSpread};
  MarkerBody body_;
  std::vector<const MarkerPlaces*> moments_;
  std::vector<RigPose> poses_;
};

}  // namespace

std::array<bool, kRigSegments> observedSegments(const BodyRig& rig, std::span<const RigMarker> markers) {
  std::array<bool, kRigSegments> observed{};
  for (const auto& m : markers)
    for (RigSegment s = m.segment; !observed[index(s)]; s = rig[s].parent) observed[index(s)] = true;
  return observed;
}

BodySolver::Vector restWeights(const BodyRig& rig, std::span<const RigMarker> markers) {
  constexpr double kSlightly = 0.2, kTrunk = 50.0, kLimb = 1.0;  // 1/rad^2
  const auto observed = observedSegments(rig, markers);
  BodySolver::Vector w = BodySolver::Vector::Zero();
  for (std::size_t i = 1; i < kRigSegments; ++i) {
    const RigPart& part = rig.parts[i];
    const double unobserved = segmentAt(i) == kChest ? kTrunk : kLimb;
    w.segment(part.column, part.freedoms).setConstant(observed[i] ? kSlightly : unobserved);
  }
  return w;
}

MarkerBody calibrate(const BodyRig& base, std::span<const FoundMarker> found,
                     std::span<const MarkerPlaces> moments, std::optional<double> stature) {
  Calibration calibration(base, found, stature);
  const auto evenly = [&](std::size_t max_count) {
    std::vector<const MarkerPlaces*> picked;
    const std::size_t count = std::min(max_count, moments.size());
    for (std::size_t i = 0; i < count; ++i) picked.push_back(&moments[i * moments.size() / count]);
    return picked;
  };
  const auto converge = [&](double reach) {
    for (int i = 0; i < kMaxRounds; ++i) {
      const double changed = calibration.improve(reach);
      if (changed < kCalibrationAtRest && reach == kLastReach) return;
      reach = std::max(kLastReach, kNarrower * reach);
    }
  };
  calibration.addMoments(evenly(kFirstMoments), kFirstReach);
  converge(kFirstReach);
  if (moments.size() > kFirstMoments) {
    calibration.addMoments(evenly(moments.size()), kSecondReach);
    converge(kSecondReach);
  }
  return std::move(calibration).release();
}

}  // namespace abstand::tracking
