// Sums rows, assembles the normal equations, steps.
#include "tracking/body/body_solver.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/math/turn_between.hpp"

namespace abstand::tracking {
namespace {

Vector3d rotationVector(const Quaterniond& q) {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  const Vector3d v = sign * q.vec();
  const double sine = v.norm();
  if (sine < 1e-12) return 2.0 * v;
  return v * (2.0 * std::atan2(sine, sign * q.w()) / sine);
}

Quaterniond turnBy(const Vector3d& r) {
  const double angle = r.norm();
  if (angle < 1e-12) return Quaterniond{1.0, 0.5 * r.x(), 0.5 * r.y(), 0.5 * r.z()}.normalized();
  return Quaterniond{Eigen::AngleAxisd(angle, r / angle)};
}

/// Twist (rad) of a ball's segment about its own axis. Neutral is the shortest rotation to the centre;
/// relative to it the rotation is split into swing and twist. Only exactly opposite to the centre, out of
/// reach, the swing is not unique.
double twistOf(const RigPart& part, const Quaterniond& R_PS) {
  const Quaterniond neutral = turnBetween(part.along, part.middle);
  const Quaterniond swing = turnBetween(part.middle, R_PS * part.along);
  return rotationVector(neutral.conjugate() * swing.conjugate() * R_PS).dot(part.along);
}

}  // namespace

void BodySolver::begin(const RigPose& pose) {
  pose_ = pose;
  place(*rig_, pose_, X_WS_);
  for (std::size_t i = 0; i < kRigSegments; ++i) {
    A_[i].setZero();
    b_[i].setZero();
  }
  H_.setZero();
  g_.setZero();
  cost_ = 0.0;

  origin_ = X_WS_[0].translation();
  const auto turn = [&](int column, std::size_t segment, const Vector3d& axis) {
    const Vector3d arm = origin_ - X_WS_[segment].translation();
    S_.col(column).head<3>() = axis.cross(arm);
    S_.col(column).tail<3>() = axis;
    segment_of_[static_cast<std::size_t>(column)] = segment;
  };
  for (std::size_t i = 0; i < kRigSegments; ++i) {
    const RigPart& part = rig_->parts[i];
    const Matrix3d& R_WP = X_WS_[index(part.parent)].linear();
    if (part.joint == RigJoint::kFree) {
      for (int k = 0; k < 3; ++k) {
        S_.col(part.column + k) << Vector3d::Unit(k), Vector3d::Zero();
        segment_of_[static_cast<std::size_t>(part.column + k)] = i;
        turn(part.column + 3 + k, i, Vector3d::Unit(k));
      }
    } else if (part.joint == RigJoint::kBall) {
      for (int k = 0; k < 3; ++k) turn(part.column + k, i, R_WP.col(k));
    } else {
      turn(part.column, i, R_WP * part.axis[0]);
      if (part.freedoms > 1)
        turn(part.column + 1, i, R_WP * (Eigen::AngleAxisd(pose_.angle[i][0], part.axis[0]) * part.axis[1]));
    }
  }
}

void BodySolver::addWrench(std::size_t segment, const Vector6& wrench, double r, double w) {
  A_[segment].noalias() += w * wrench * wrench.transpose();
  b_[segment] += (w * r) * wrench;
  cost_ += w * r * r;
}

void BodySolver::addPlane(RigSegment s, const Vector3d& p_W, const Vector3d& n, double r, double w) {
  Vector6 wrench;
  wrench << n, (p_W - origin_).cross(n);
  addWrench(index(s), wrench, r, w);
}

void BodySolver::addPoint(RigSegment s, const Vector3d& p_W, const Vector3d& goal, double w) {
  for (int k = 0; k < 3; ++k) addPlane(s, p_W, Vector3d::Unit(k), (p_W - goal)[k], w);
}

void BodySolver::addFreedom(int column, double target, double w) {
  H_(column, column) += w;
  g_(column) -= w * target;
  cost_ += w * target * target;
}

void BodySolver::addPrior(const RigPose& other, const Vector& w) {
  const Vector d = difference(*rig_, pose_, other);
  for (int c = 0; c < kRigDof; ++c) addFreedom(c, d(c), w(c));
}

void BodySolver::addLimits(double w) {
  for (std::size_t i = 1; i < kRigSegments; ++i) {
    const RigPart& part = rig_->parts[i];
    if (part.joint == RigJoint::kHinges) {
      for (int k = 0; k < part.freedoms; ++k) {
        const auto a = static_cast<std::size_t>(k);
        const double q = pose_.angle[i][a];
        if (q < part.lower[a]) addFreedom(part.column + k, part.lower[a] - q, w);
        if (q > part.upper[a]) addFreedom(part.column + k, part.upper[a] - q, w);
      }
      continue;
    }
    // Both as rows along one axis of the parent's frame: d(excess)/d(angle) is 1 about it.
    const auto drive = [&](const Vector3d& axis, double excess) {
      Matrix3d outer = axis * axis.transpose();
      H_.block<3, 3>(part.column, part.column) += w * outer;
      g_.segment<3>(part.column) += w * excess * axis;
      cost_ += w * excess * excess;
    };
    const Vector3d points = pose_.R_PS[i] * part.along;
    const double away = std::acos(std::clamp(points.dot(part.middle), -1.0, 1.0));
    const Vector3d across = part.middle.cross(points);
    if (away > part.cone && across.norm() > 1e-9) drive(across.normalized(), away - part.cone);
    const double twist = twistOf(part, pose_.R_PS[i]);
    if (std::abs(twist) > part.twist) drive(std::copysign(1.0, twist) * points, std::abs(twist) - part.twist);
  }
}

void BodySolver::addUntwist(RigSegment ball, double w) {
  const RigPart& part = (*rig_)[ball];
  const Quaterniond& R_PS = pose_.R_PS[index(ball)];
  const Vector3d points = R_PS * part.along;
  const double twist = twistOf(part, R_PS);
  H_.block<3, 3>(part.column, part.column) += w * points * points.transpose();
  g_.segment<3>(part.column) += w * twist * points;
  cost_ += w * twist * twist;
}

void BodySolver::assemble() {
  for (std::size_t i = kRigSegments; i-- > 1;) {
    const std::size_t parent = index(rig_->parts[i].parent);
    A_[parent] += A_[i];
    b_[parent] += b_[i];
  }
  for (int c = 0; c < kRigDof; ++c) {
    // Column c moves its segment and all descendants; dof of ancestors move them too.
    std::size_t i = segment_of_[static_cast<std::size_t>(c)];
    const Vector6 F = A_[i] * S_.col(c);
    g_(c) += b_[i].dot(S_.col(c));
    for (;;) {
      const RigPart& part = rig_->parts[i];
      for (int k = part.column; k < part.column + part.freedoms; ++k) {
        if (k > c) break;
        const double h = F.dot(S_.col(k));
        H_(c, k) += h;
        if (k != c) H_(k, c) += h;
      }
      if (i == 0) break;
      i = index(part.parent);
    }
  }
}

double BodySolver::step(double damping, double max_step) {
  assemble();
  Matrix damped = H_;
  damped.diagonal().array() += damping;
  const Eigen::LLT<Matrix> llt(damped);
  if (llt.info() != Eigen::Success) return 0.0;
  Vector d = -llt.solve(g_);
  if (!d.allFinite()) return 0.0;
  const double largest = d.cwiseAbs().maxCoeff();
  if (largest > max_step) d *= max_step / largest;
  advance(*rig_, d, pose_);
  place(*rig_, pose_, X_WS_);
  return std::min(largest, max_step);
}

Eigen::Matrix<double, 3, kRigDof> BodySolver::jacobian(RigSegment s, const Vector3d& p_W) const {
  Eigen::Matrix<double, 3, kRigDof> J = Eigen::Matrix<double, 3, kRigDof>::Zero();
  const Vector3d arm = p_W - origin_;
  for (std::size_t i = index(s);; i = index(rig_->parts[i].parent)) {
    const RigPart& part = rig_->parts[i];
    for (int c = part.column; c < part.column + part.freedoms; ++c)
      J.col(c) = S_.col(c).head<3>() + S_.col(c).tail<3>().cross(arm);
    if (i == 0) return J;
  }
}

void advance(const BodyRig& rig, const BodySolver::Vector& d, RigPose& pose) {
  pose.X_WP.translation() += d.head<3>();
  pose.X_WP.linear() =
      (turnBy(d.segment<3>(3)) * Quaterniond{pose.X_WP.linear()}).normalized().toRotationMatrix();
  for (std::size_t i = 1; i < kRigSegments; ++i) {
    const RigPart& part = rig.parts[i];
    if (part.joint == RigJoint::kBall) {
      pose.R_PS[i] = (turnBy(d.segment<3>(part.column)) * pose.R_PS[i]).normalized();
      continue;
    }
    for (int k = 0; k < part.freedoms; ++k) {
      const auto a = static_cast<std::size_t>(k);
      pose.angle[i][a] = std::clamp(pose.angle[i][a] + d(part.column + k), part.lower[a], part.upper[a]);
    }
  }
}

BodySolver::Vector difference(const BodyRig& rig, const RigPose& from, const RigPose& to) {
  BodySolver::Vector d;
  d.head<3>() = to.X_WP.translation() - from.X_WP.translation();
  d.segment<3>(3) =
      rotationVector(Quaterniond{to.X_WP.linear()} * Quaterniond{from.X_WP.linear()}.conjugate());
  for (std::size_t i = 1; i < kRigSegments; ++i) {
    const RigPart& part = rig.parts[i];
    if (part.joint == RigJoint::kBall) {
      d.segment<3>(part.column) = rotationVector(to.R_PS[i] * from.R_PS[i].conjugate());
      continue;
    }
    for (int k = 0; k < part.freedoms; ++k) {
      const auto a = static_cast<std::size_t>(k);
      d(part.column + k) = to.angle[i][a] - from.angle[i][a];
    }
  }
  return d;
}

}  // namespace abstand::tracking
