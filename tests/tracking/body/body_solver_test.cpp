// The solver against differences, dense sums and known answers.
#include "tracking/body/body_solver.hpp"
#include "core/math/turn_between.hpp"

#include <gtest/gtest.h>
#include <Eigen/Cholesky>

#include "tests/support/no_alloc.hpp"
#include "tests/tracking/body/random_rig_pose.hpp"

namespace abstand::tracking {
namespace body_solver_test {

using testing::randomRigPose;

const BodyRig& rig() {
  static const BodyRig made = makeRig(humanmodel::makeHuman({}));
  return made;
}

TEST(BodyRig, DofsAreCountedOnce) {
  int expected = 0;
  for (const RigPart& part : rig().parts) {
    EXPECT_EQ(part.column, expected);
    expected += part.freedoms;
  }
  EXPECT_EQ(expected, kRigDof);
}

TEST(BodyRig, StandsLikeModel) {
  const humanmodel::HumanModel model = humanmodel::makeHuman({});
  RigPose pose;
  pose.X_WP.translation() = model.rest[humanmodel::Joint::kPelvis];
  RigPlacement X_WS;
  place(rig(), pose, X_WS);
  humanmodel::SkeletonFrame frame;
  jointsOf(rig(), X_WS, humanmodel::JointState::kTracked, frame);
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    EXPECT_LT((frame.p[j] - model.rest.p[j]).norm(), 1e-12)
        << humanmodel::jointName(static_cast<humanmodel::Joint>(j));
}

TEST(BodySolver, JacobianMatchesFiniteDifferences) {
  constexpr double kChange = 1e-6, kTolerance = 1e-5;  // m/rad; the second derivative times the change
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RigPose pose = randomRigPose(rig(), seed, 1.0);
    BodySolver solver(rig());
    solver.begin(pose);
    for (std::size_t i = 0; i < kRigSegments; ++i) {
      const Vector3d p_S{0.03, -0.02, -0.1};
      const Vector3d p_W = solver.placement()[i] * p_S;
      const auto J = solver.jacobian(segmentAt(i), p_W);
      for (int c = 0; c < kRigDof; ++c) {
        RigPose moved = pose;
        advance(rig(), kChange * BodySolver::Vector::Unit(c), moved);
        RigPlacement X_WS;
        place(rig(), moved, X_WS);
        const Vector3d numeric = (X_WS[i] * p_S - p_W) / kChange;
        EXPECT_LT((numeric - J.col(c)).norm(), kTolerance) << segmentName(segmentAt(i)) << ", freedom " << c;
      }
    }
  }
}

TEST(BodySolver, SumsByTreeEqualDenseSums) {
  const RigPose pose = randomRigPose(rig(), 7, 1.0);
  BodySolver solver(rig());
  solver.begin(pose);
  BodySolver::Matrix H = BodySolver::Matrix::Zero();
  BodySolver::Vector g = BodySolver::Vector::Zero();
  double cost = 0.0;
  for (std::size_t i = 0; i < kRigSegments; ++i) {
    for (int k = 0; k < 3; ++k) {
      const Vector3d p_W = solver.placement()[i] * Vector3d(0.05 * k, 0.1, -0.07);
      const Vector3d n = Vector3d(1.0, static_cast<double>(i), -2.0 * k).normalized();
      const double r = 0.01 * (k + 1) - 0.003 * static_cast<double>(i), w = 1.0 + k;
      const Eigen::Matrix<double, 1, kRigDof> J = n.transpose() * solver.jacobian(segmentAt(i), p_W);
      H += w * J.transpose() * J;
      g += w * r * J.transpose();
      cost += w * r * r;
      solver.addPlane(segmentAt(i), p_W, n, r, w);
    }
  }
  constexpr double kDamping = 1e-3;
  H.diagonal().array() += kDamping;
  const BodySolver::Vector d = -H.llt().solve(g);
  RigPose expected = pose;
  advance(rig(), d, expected);
  EXPECT_DOUBLE_EQ(solver.cost(), cost);
  solver.step(kDamping, 1e9);
  EXPECT_LT(difference(rig(), expected, solver.pose()).norm(), 1e-9);
  H.diagonal().array() -= kDamping;
  EXPECT_LT((solver.information() - H).norm(), 1e-9 * H.norm());
}

TEST(BodySolver, DifferenceInvertsAdvance) {
  const RigPose pose = randomRigPose(rig(), 3, 1.0);
  BodySolver::Vector d = BodySolver::Vector::Zero();
  for (int c = 0; c < kRigDof; ++c) d(c) = 0.02 * std::sin(c);
  RigPose moved = pose;
  advance(rig(), d, moved);
  EXPECT_LT((difference(rig(), pose, moved) - d).norm(), 1e-12);
}

TEST(BodySolver, LimitsDriveJointsBack) {
  for (const double sign : {1.0, -1.0}) {
    RigPose pose;
    // Twice the back's cone forward, more than the shoulder's twist, an elbow as far as its clamp lets it.
    pose.R_PS[index(RigSegment::kChest)] = Eigen::AngleAxisd(unit::deg(80), Vector3d::UnitY());
    const RigPart& arm = rig()[RigSegment::kUpperArmLeft];
    pose.R_PS[index(RigSegment::kUpperArmLeft)] =
        Quaterniond(Eigen::AngleAxisd(sign * unit::deg(150), arm.middle)) *
        turnBetween(arm.along, arm.middle);
    BodySolver solver(rig());
    for (int i = 0; i < 50; ++i) {
      solver.begin(pose);
      solver.addLimits(1.0);
      solver.step(1e-6, 0.5);
      pose = solver.pose();
    }
    solver.begin(pose);
    solver.addLimits(1.0);
    EXPECT_LT(solver.cost(), 1e-10);
    // Only as far as needed.
    const Vector3d up = pose.R_PS[index(RigSegment::kChest)] * Vector3d::UnitZ();
    EXPECT_NEAR(std::acos(up.z()), rig()[RigSegment::kChest].cone, 1e-4);
  }
}

TEST(BodySolver, UntwistsAThighWithoutMovingIt) {
  constexpr double kTolerance = 1e-6;
  const RigPart& thigh = rig()[RigSegment::kThighLeft];
  RigPose pose = randomRigPose(rig(), 3, 0.3);
  Quaterniond& R_PS = pose.R_PS[index(RigSegment::kThighLeft)];
  const Quaterniond swung = turnBetween(thigh.middle, Vector3d(0.4, 0.2, -0.8).normalized()) *
                            turnBetween(thigh.along, thigh.middle);
  R_PS = swung * Quaterniond(Eigen::AngleAxisd(unit::deg(30), thigh.along));
  BodySolver solver(rig());
  solver.begin(pose);
  solver.addUntwist(RigSegment::kThighLeft, 2.0);
  EXPECT_NEAR(solver.cost(), 2.0 * unit::deg(30) * unit::deg(30), kTolerance);
  for (int i = 0; i < 20; ++i) {
    solver.begin(pose);
    solver.addUntwist(RigSegment::kThighLeft, 2.0);
    solver.step(1e-6, 0.5);
    pose = solver.pose();
  }
  EXPECT_LT(pose.R_PS[index(RigSegment::kThighLeft)].angularDistance(swung), kTolerance);
}

TEST(BodySolver, AllocatesNothing) {
  BodySolver solver(rig());
  const RigPose pose = randomRigPose(rig(), 5, 0.5), other = randomRigPose(rig(), 6, 0.5);
  testing::NoAlloc guard;
  solver.begin(pose);
  solver.addPoint(RigSegment::kHandLeft, {1, 2, 3}, {1, 2, 2.9}, 1.0);
  solver.addPrior(other, BodySolver::Vector::Ones());
  solver.addLimits(1.0);
  solver.addUntwist(RigSegment::kThighRight, 1.0);
  solver.step(1e-3, 0.3);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace body_solver_test
}  // namespace abstand::tracking
