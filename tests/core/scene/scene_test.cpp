#include "core/scene/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"
#include "core/base/state_hash.hpp"
#include "core/math/object_motion.hpp"
#include "core/view/snapshot.hpp"
#include "tests/core/scene/crowd.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::scene {
namespace scene_test {

// A few roundings of numbers near 1.
constexpr double kRounding = 1e-12;
// Differences of poses near 1 m, divided by steps of 10 ms.
constexpr double kVelocityRounding = 1e-9;

using testing::at;
using testing::ball;
using testing::crowd;
using testing::scatter;

std::uint64_t runHash(int threads) {
  Scene scene = crowd(20);
  scene.setThreads(threads);
  StateHash hash;
  for (int frame = 0; frame < 50; ++frame) {
    scatter(scene, frame);
    scene.step();
    for (const Object& o : scene.objects()) {
      for (int k = 0; k < 3; ++k) {
        hash.add(o.contact.force[k]);
        hash.add(o.contact.torque[k]);
      }
      hash.add(o.contacts + (o.colliding ? 0.5 : 0.0));
    }
    for (const Pair& p : scene.pairs()) hash.add(p.result.distance);
  }
  return hash.value();
}

TEST(Scene, IsBitIdenticalForAnyThreadCount) {
  const auto one = runHash(1);
  for (const int n : {2, 3, 7, 16}) EXPECT_EQ(runHash(n), one) << n << " threads";
}

TEST(Scene, ThreadsMayChangeBetweenSteps) {
  Scene scene = crowd(10);
  for (const int n : {3, 1, 8, 2, 2, 0}) {
    scene.setThreads(n);
    scatter(scene, n);
    scene.step();
    EXPECT_TRUE(std::isfinite(scene.result(PairId(44)).distance));
  }
  EXPECT_GE(scene.threads(), 1);
  EXPECT_THROW(scene.setThreads(-1), UsageError);
  EXPECT_THROW(scene.setThreads(Scene::kMaxThreads + 1), UsageError);
  const Scene moved = std::move(scene);
  EXPECT_EQ(moved.pairs().size(), 45u);
}

TEST(Scene, StepsWithoutObjectsOrPairs) {
  Scene scene;
  scene.step();
  scene.setThreads(3);
  scene.step();
  scene.addObject({"a", "objects", ball(20)});
  scene.step();
  EXPECT_EQ(scene.object(ObjectId(0)).contacts, 0);
}

TEST(Scene, CycleAllocatesNothing) {
  for (const int threads : {1, 3}) {
    Scene scene = crowd(10);
    scene.setThreads(threads);
    view::SceneSnapshot snapshot;
    scatter(scene, 0);
    scene.step();
    view::capture(scene, snapshot);
    const testing::NoAlloc guard;
    for (int frame = 1; frame < 20; ++frame) {
      scatter(scene, frame);
      scene.step();
      view::capture(scene, snapshot);
    }
    EXPECT_EQ(guard.count(), 0) << threads;
  }
}

TEST(Scene, TotalsAreSumsOfPairs) {
  Scene scene = crowd(12);
  scatter(scene, 3);
  scene.step();
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
  int contacts = 0;
  for (std::uint32_t i = 0; i < 12; ++i) {
    const Object& o = scene.object(ObjectId(i));
    Wrench sum;
    int touched = 0;
    for (const PairId id : scene.pairsOf(ObjectId(i))) {
      const Pair& p = scene.pairs()[id.index()];
      const bool first = p.a == ObjectId(i);
      EXPECT_TRUE(first || p.b == ObjectId(i));
      sum +=
          first ? Wrench{p.result.force_a, p.result.torque_a} : Wrench{-p.result.force_a, p.result.torque_b};
      touched += p.result.contacts;
    }
    EXPECT_EQ(scene.pairsOf(ObjectId(i)).size(), 11u);
    EXPECT_EQ(o.contact.force, sum.force);
    EXPECT_EQ(o.contact.torque, sum.torque);
    EXPECT_EQ(o.contacts, touched);
    EXPECT_EQ(o.colliding, touched > 0);
    force += o.contact.force;
    moment += o.contact.torque + o.p_WCom().cross(o.contact.force);
    contacts += touched;
  }
  ASSERT_GT(contacts, 0) << "the crowd must touch for this test to mean something";
  const double scale = 1e6 * contacts;  // N, about stiffness times depth times pairs
  EXPECT_LT(force.norm(), kRounding * scale);
  EXPECT_LT(moment.norm(), kRounding * scale);
}

TEST(Scene, TotalsAreResetEachStep) {
  Scene scene = crowd(2);
  scene.setPose(ObjectId(0), at(0.0), 0.0);
  scene.setPose(ObjectId(1), at(0.3), 0.0);
  scene.step();
  EXPECT_TRUE(scene.object(ObjectId(0)).colliding);
  EXPECT_LT(scene.object(ObjectId(0)).contact.force.x(), 0.0) << "A is pushed away from B";
  EXPECT_GT(scene.object(ObjectId(1)).contact.force.x(), 0.0);
  scene.setPose(ObjectId(1), at(3.0), 0.1);
  scene.step();
  EXPECT_FALSE(scene.object(ObjectId(0)).colliding);
  EXPECT_EQ(scene.object(ObjectId(1)).contact.force, Vector3d(0, 0, 0));
}

TEST(Scene, NamesAndPairsAreUnique) {
  Scene scene;
  const ObjectId a = scene.addObject({"a", "g", ball(20), 0.1});
  const ObjectId b = scene.addObject({"b", "g", ball(20), 0.2});
  EXPECT_THROW(scene.addObject({"a", "h", ball(20)}), UsageError);
  EXPECT_THROW(scene.addObject({"", "h", ball(20)}), UsageError);
  EXPECT_THROW(scene.addObject({"c", "h", ball(20), -0.1}), UsageError);
  EXPECT_THROW(scene.addObject({"c", "h", ball(20), kNaN}), UsageError);
  EXPECT_EQ(scene.objectCount(), 2u);
  scene.addPair(b, a);
  EXPECT_THROW(scene.addPair(a, b), UsageError);
  EXPECT_THROW(scene.addPair(b, a), UsageError);
  EXPECT_THROW(scene.addPair(a, a), UsageError);
  EXPECT_EQ(scene.pairs().size(), 1u);
  EXPECT_EQ(scene.pairs()[0].a, b) << "a pair keeps its order";

  ObjectId found(99);
  ASSERT_NE(scene.find("b", &found), nullptr);
  EXPECT_EQ(found, b);
  EXPECT_EQ(scene.find("b")->spec.group, "g");
  EXPECT_EQ(scene.find("nobody"), nullptr);
}

TEST(Scene, PairMarginReplacesSum) {
  Scene scene = crowd(3);
  scene.setPairMargin(PairId(2), 0.3);  // of the objects 1 and 2
  EXPECT_DOUBLE_EQ(scene.pairs()[2].options.margin, 0.3);
  EXPECT_DOUBLE_EQ(scene.pairs()[1].options.margin, 0.02);
  scene.setMargin(ObjectId(1), 0.5);
  EXPECT_DOUBLE_EQ(scene.pairs()[0].options.margin, 0.51);
  EXPECT_DOUBLE_EQ(scene.pairs()[2].options.margin, 0.3) << "its own margin stays";
  scene.setPairMargin(PairId(2), 0.0);
  EXPECT_DOUBLE_EQ(scene.pairs()[2].options.margin, 0.0);
  EXPECT_THROW(scene.setPairMargin(PairId(2), -0.1), UsageError);
  EXPECT_THROW(scene.setPairMargin(PairId(2), kNaN), UsageError);
  EXPECT_DOUBLE_EQ(scene.pairs()[2].options.margin, 0.0);
  scene.setPairMargin(PairId(2), std::nullopt);
  EXPECT_DOUBLE_EQ(scene.pairs()[2].options.margin, 0.51);
}

TEST(Scene, MarginsAndForceLawApplyToPairs) {
  Scene scene = crowd(3);
  EXPECT_DOUBLE_EQ(scene.pairs()[0].options.margin, 0.02);
  scene.setMargin(ObjectId(1), 0.5);
  EXPECT_DOUBLE_EQ(scene.pairs()[0].options.margin, 0.51);  // 0, 1
  EXPECT_DOUBLE_EQ(scene.pairs()[1].options.margin, 0.02);  // 0, 2
  EXPECT_DOUBLE_EQ(scene.pairs()[2].options.margin, 0.51);  // 1, 2
  EXPECT_THROW(scene.setMargin(ObjectId(1), -1.0), UsageError);
  EXPECT_THROW(scene.setMargin(ObjectId(1), kInfinity), UsageError);
  EXPECT_DOUBLE_EQ(scene.object(ObjectId(1)).spec.margin, 0.5);

  scene.setForceLaw(query::ForceLaw::kThesis, 7.0);
  EXPECT_THROW(scene.setForceLaw(query::ForceLaw::kVolume, kNaN), UsageError);
  const ObjectId late = scene.addObject({"late", "objects", ball(20)});
  scene.addPair(ObjectId(0), late);
  for (const Pair& p : scene.pairs()) {
    EXPECT_EQ(p.options.law, query::ForceLaw::kThesis);
    EXPECT_EQ(p.options.stiffness, 7.0);
  }
}

TEST(Scene, SharedStructuresCountOnce) {
  Scene scene;
  const auto shared = ball(20);
  scene.addObject({"a", "g", shared});
  const std::size_t one = scene.memoryBytes();
  scene.addObject({"b", "g", shared});
  EXPECT_EQ(scene.memoryBytes(), one);
  scene.addObject({"c", "g", ball(20)});
  EXPECT_EQ(scene.memoryBytes(), 2 * one);
}

TEST(ScenePoses, RejectsInvalidPosesAndKeepsLast) {
  Transform sheared = at(0), scaled = at(0), mirrored = at(0), zero = at(0), nan = at(0), far = at(0),
            infinite = at(0);
  sheared.linear()(0, 1) = 0.1;
  scaled.linear() *= 2.0;
  mirrored.linear()(2, 2) = -1.0;
  zero.linear().setZero();
  nan.linear()(1, 1) = kNaN;
  far.translation().x() = 1e7;
  infinite.translation().y() = kInfinity;
  Scene scene = crowd(2);
  const ObjectId id(0);
  EXPECT_TRUE(scene.setPose(id, at(0.0), 0.0));
  EXPECT_TRUE(scene.setPose(id, at(1.0), 1.0, PoseState::kInferred));
  EXPECT_EQ(scene.object(id).pose_state, PoseState::kInferred);
  long rejected = 0;
  for (const Transform& X : {sheared, scaled, mirrored, zero, nan, far, infinite}) {
    EXPECT_FALSE(scene.setPose(id, X, 2.0));
    const Object& o = scene.object(id);
    EXPECT_EQ(o.rejected_poses, ++rejected);
    EXPECT_EQ(o.pose_state, PoseState::kRejected);
    EXPECT_EQ(o.X_WB.translation(), Vector3d(1, 0, 0));
    EXPECT_EQ(o.t, 1.0);
  }
  EXPECT_FALSE(scene.setPose(id, at(2.0), kNaN));
  EXPECT_TRUE(scene.setPose(id, at(3.0), 3.0));
  const Object& o = scene.object(id);
  EXPECT_EQ(o.pose_state, PoseState::kFresh);
  EXPECT_NEAR(o.velocity.linear.x(), 1.0, kRounding) << "from the last good pose";
}

TEST(ScenePoses, ConstantMotionGivesItsVelocity) {
  // Turns about a fixed axis while it drifts; the centre of mass lies off the origin.
  const Vector3d omega(0.7, -1.1, 0.4), drift(0.3, 0.2, -0.1), com(0.1, 0.05, -0.2);
  Scene scene;
  const ObjectId id = scene.addObject({"a", "g", ball(20, com)});
  const double dt = 0.01;
  const auto poseAt = [&](double t) {
    Transform X = at(0);
    X.linear() = Eigen::AngleAxisd(omega.norm() * t, omega.normalized()).toRotationMatrix();
    X.translation() = drift * t;
    return X;
  };
  for (int i = 0; i < 25; ++i) {
    ASSERT_TRUE(scene.setPose(id, poseAt(dt * i), dt * i));
    const Object& o = scene.object(id);
    if (i == 0) {
      EXPECT_EQ(o.velocity.linear, Vector3d(0, 0, 0));
      continue;
    }
    const Vector3d way = poseAt(dt * i) * com - poseAt(dt * (i - 1)) * com;
    EXPECT_LT((o.velocity.linear - way / dt).norm(), kVelocityRounding);
    EXPECT_LT((o.velocity.angular - omega).norm(), kVelocityRounding);
    EXPECT_LT((o.mean_velocity.angular - omega).norm(), kVelocityRounding);
    const int first = std::max(0, i - (Scene::kMeanSamples - 1));
    const Vector3d mean = (poseAt(dt * i) * com - poseAt(dt * first) * com) / (dt * (i - first));
    EXPECT_LT((o.mean_velocity.linear - mean).norm(), kVelocityRounding) << i;
  }
}

TEST(ScenePoses, SameTimeReplacesPoseWithoutVelocityJump) {
  Scene scene = crowd(1);
  const ObjectId id(0);
  scene.setPose(id, at(0.0), 0.0);
  scene.setPose(id, at(0.1), 0.1);
  scene.setPose(id, at(5.0), 0.1);
  EXPECT_EQ(scene.object(id).X_WB.translation().x(), 5.0);
  EXPECT_NEAR(scene.object(id).velocity.linear.x(), 1.0, kRounding);
  scene.setPose(id, at(5.2), 0.2);
  EXPECT_NEAR(scene.object(id).velocity.linear.x(), 2.0, kRounding);
  EXPECT_NEAR(scene.object(id).mean_velocity.linear.x(), 1.5, kRounding);
}

TEST(ScenePoses, BackwardTimeJumpRestartsVelocity) {
  Scene scene = crowd(1);
  const ObjectId id(0);
  scene.setPose(id, at(0.0), 10.0);
  scene.setPose(id, at(1.0), 11.0);
  EXPECT_TRUE(scene.setPose(id, at(-3.0), 2.0));
  EXPECT_EQ(scene.object(id).velocity.linear, Vector3d(0, 0, 0));
  EXPECT_EQ(scene.object(id).mean_velocity.linear, Vector3d(0, 0, 0));
  scene.setPose(id, at(-2.0), 3.0);
  EXPECT_NEAR(scene.object(id).mean_velocity.linear.x(), 1.0, kRounding);
}

TEST(ObjectMotion, RotationBetweenRecoversRotation) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Matrix3d R = testing::randomPose(seed).linear(), S = testing::randomPose(seed + 10000).linear();
    const Vector3d v = rotationBetween(R, S);
    ASSERT_LE(v.norm(), kPi + kRounding);
    const Matrix3d turned = Eigen::AngleAxisd(v.norm(), v.normalized()) * R;
    ASSERT_LT((turned - S).norm(), 1e-9) << seed;  // near half a turn the axis loses digits
  }
  EXPECT_EQ(rotationBetween(Matrix3d::Identity(), Matrix3d::Identity()), Vector3d(0, 0, 0));
  const Matrix3d tiny = Eigen::AngleAxisd(1e-9, Vector3d::UnitZ()).toRotationMatrix();
  EXPECT_NEAR(rotationBetween(Matrix3d::Identity(), tiny).z(), 1e-9, 1e-20);
}

TEST(Snapshot, MatchesScene) {
  Scene scene = crowd(4);
  view::SceneSnapshot s;
  s.step = 17;
  view::capture(scene, s);
  EXPECT_EQ(s.nearest_pair, -1) << "nothing was queried yet";
  scatter(scene, 1);
  scene.setPose(ObjectId(2), at(5.0), 0.5, PoseState::kStale);
  scene.step();
  view::capture(scene, s);
  EXPECT_EQ(s.step, 17) << "capture leaves the rest alone";
  ASSERT_EQ(s.objects.size(), 4u);
  ASSERT_EQ(s.pairs.size(), 6u);
  EXPECT_EQ(s.objects[2].pose_state, PoseState::kStale);
  for (std::size_t i = 0; i < 4; ++i) {
    const Object& o = scene.objects()[i];
    EXPECT_TRUE(s.objects[i].X_WB.isApprox(o.X_WB, 0.0));
    EXPECT_EQ(s.objects[i].p_WCom, o.p_WCom());
    EXPECT_EQ(s.objects[i].contact.force, o.contact.force);
    EXPECT_EQ(s.objects[i].velocity.linear, o.velocity.linear);
    EXPECT_EQ(s.objects[i].margin, o.spec.margin);
    EXPECT_EQ(s.objects[i].colliding, o.colliding);
  }
  ASSERT_GE(s.nearest_pair, 0);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(s.pairs[i].result.distance, scene.pairs()[i].result.distance);
    EXPECT_EQ(s.pairs[i].margin, scene.pairs()[i].options.margin);
    EXPECT_LE(s.pairs[static_cast<std::size_t>(s.nearest_pair)].result.distance, s.pairs[i].result.distance);
  }
}

}  // namespace scene_test
}  // namespace abstand::scene
