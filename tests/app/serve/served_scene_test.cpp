// A scene that packets move: closed-form distances and torques, stops of stale input, nothing stale is safe.
#include "app/serve/served_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "app/loop/closed_loop.hpp"
#include "humanmodel/part_uncertainty.hpp"
#include "humanmodel/rest_pose.hpp"
#include "tests/app/loop/slide_scene.hpp"
#include "tests/app/serve/joint_packet.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/paths.hpp"

namespace abstand::serve {
namespace served_scene_test {

/// A ball on a vertical slide (q is its height) over a plate whose top lies at z = 0, and a person far away.
const char* kScene = R"(abstand: 1
defaults: {voxel: 0.01, point: 0.01}
mechanisms:
  - name: slide
    file: slide.mech
    q: [1]
    links: [{name: ball, frame: 1, shape: {sphere: {radius: 0.1}}}]
objects:
  - {name: plate, shape: {cuboid: {size: [1, 1, 0.2]}}, pose: {xyz: [0, 0, -0.1]}}
)";
const char* kPerson = R"(humans:
  - name: operator
    margin: 0.05
defaults: {voxel: 0.02, point: 0.02}
)";
const char* kSlide = "chain\n    frame   1   0      0          d    0\nend_chain\n";

struct ServedSceneTest : ::testing::Test {
  abstand::testing::ScratchFolder folder;
  std::unique_ptr<ServedScene> scene;
  Packet packet;
  std::string slide{kSlide};

  void open(bool person, const control::ReactionDescription& reaction = usualReaction()) {
    folder.write("slide.mech", slide);
    std::string text = kScene;
    if (person) {
      text.replace(text.find("defaults: {voxel: 0.01, point: 0.01}\n"), 37, "");
      text += kPerson;
    }
    session::SessionOptions options;
    options.threads = 1;
    options.cache = false;
    options.remember = true;
    auto session = std::make_unique<session::Session>(
        scene_file::parseScene(text, folder.path() / "scene.yaml"), options);
    scene = std::make_unique<ServedScene>(std::move(session), ServedOptions{reaction, 4});
    packet = makePacket(scene->format());
  }

  void joints(double height, double t, bool reset = false) {
    setJoint(packet, height, t, reset);
    scene->take(packet, t);
  }
  void person(double t, double x = 0.0) {
    packet.type = PacketType::kSkeleton;
    packet.index = 0;
    packet.skeleton = scene->session().humans()[0]->model().rest;
    for (auto& p : packet.skeleton.p) p.x() += 3.0 + x;
    scene->take(packet, t);
  }
  const RobotReport& robot() const { return scene->report().robots[0]; }
};

TEST_F(ServedSceneTest, JointValuesAreCheckedAgainstLimits) {
  slide += "limits\n limit 1 0.2 0.8 2 none\nend_limits\n";
  open(false);
  const mechanism::JointLimitWatch& limits = scene->robots()[0]->limits();
  // From 0.5 m down at 1 m/s: too low in the last two packets.
  for (int i = 0; i <= 4; ++i) {
    joints(0.5 - 0.1 * i, 0.1 * i);
    scene->cycle(0.1 * i);
  }
  auto breaches = limits.breaches();
  ASSERT_EQ(breaches.size(), 1u);
  EXPECT_EQ(breaches[0].kind, mechanism::LimitKind::kPosition);
  EXPECT_NEAR(breaches[0].value, 0.1, 1e-12);
  EXPECT_EQ(breaches[0].limit, 0.2);
  EXPECT_NEAR(breaches[0].since, 0.4, 1e-12);
  EXPECT_EQ(breaches[0].count, 1);
  // Up by 0.3 m within 0.1 s of the sender's clock.
  joints(0.4, 0.5);
  breaches = limits.breaches();
  ASSERT_EQ(breaches.size(), 2u);
  EXPECT_EQ(breaches[1].kind, mechanism::LimitKind::kVelocity);
  EXPECT_NEAR(breaches[1].value, 3.0, 1e-6);
  EXPECT_EQ(breaches[1].limit, 2.0);
  EXPECT_EQ(breaches[1].count, 1);
  // What came was used as it came.
  EXPECT_EQ(scene->session().mechanisms()[0]->q()[0], 0.4);
}

TEST_F(ServedSceneTest, RobotSpeedUsesSenderClock) {
  slide += "limits\n limit 1 none none 2 none\nend_limits\n";
  open(false);
  const mechanism::JointLimitWatch& limits = scene->robots()[0]->limits();
  joints(0.5, 0.01);
  // The clock was set back, stands, and is ahead by an hour.
  for (const double stamp : {0.0, 0.0, 3600.0}) {
    packet.q[0] += 0.1;
    packet.time_us = static_cast<std::uint64_t>(1e6 * stamp);
    scene->take(packet, 0.02);
  }
  EXPECT_TRUE(limits.kept());
  // After a silence somebody else may send.
  joints(0.5, 3600.01);
  EXPECT_FALSE(limits.kept());
  open(false);
  const mechanism::JointLimitWatch& anew = scene->robots()[0]->limits();
  joints(0.5, 0.01);
  scene->cycle(0.01);
  scene->cycle(5.0);
  joints(20.5, 5.0);
  EXPECT_TRUE(anew.kept());
}

TEST_F(ServedSceneTest, BallOnPlateHasExpectedDistanceForceAndTorque) {
  open(false);
  joints(0.5, 0.01);
  scene->cycle(0.01);
  const PairReport& near = scene->report().nearest[0];
  EXPECT_EQ(near.trust, Trust::kFresh);
  // Beyond 0.1 m, what is remembered may be 1 % too far.
  EXPECT_GE(near.distance, 0.4 - 1e-6);
  EXPECT_LE(near.distance, 1.01 * 0.4);
  EXPECT_LE(near.distance - near.bound, 0.4);
  EXPECT_EQ(scene->report().nearest[1].a, -1);
  EXPECT_EQ(scene->report().torque[0], 0.0);
  EXPECT_EQ(robot().state, safety::StopState::kRunning);
  EXPECT_FALSE(robot().has_reason);
  EXPECT_EQ(robot().speed_scale, 1.0);
  joints(0.09, 0.02);  // 10 mm deep
  scene->cycle(0.02);
  const Wrench& w = scene->report().links[0];
  EXPECT_GT(w.force.z(), 0.0);
  // The slide is prismatic along z: its torque is the force along z.
  EXPECT_NEAR(scene->report().torque[0], w.force.z(), 1e-9 * w.force.norm());
}

TEST_F(ServedSceneTest, StalePersonStopsRobot) {
  open(true);
  // Nothing is known before the first packet.
  scene->cycle(0.005);
  EXPECT_EQ(robot().state, safety::StopState::kProtectiveStop);
  EXPECT_EQ(robot().reason, safety::StopReason::kStaleInput);
  EXPECT_EQ(robot().speed_scale, 0.0);
  EXPECT_EQ(scene->report().person_age[0], kInfinity);
  EXPECT_EQ(scene->report().separation[0].distance, -kInfinity);
  for (const PairReport& p : scene->report().nearest) EXPECT_EQ(p.distance, -kInfinity);
  EXPECT_EQ(scene->nextStale(), kInfinity);

  person(0.01);
  for (int i = 1; i <= 100; ++i) {
    const double t = 0.01 * i;
    if (i <= 50) person(t);
    joints(1.0, t);
    scene->cycle(t);
    const PairReport& s = scene->report().separation[0];
    // The last skeleton came at 0.5 s, and the usual age is 0.2 s.
    if (t < 0.7 - 1e-6) {
      EXPECT_EQ(robot().state, safety::StopState::kRunning) << t;
      EXPECT_GT(s.distance - s.bound, 1.0);
    } else if (t > 0.7 + 1e-6) {
      EXPECT_NE(robot().state, safety::StopState::kRunning) << t;
      EXPECT_EQ(robot().reason, safety::StopReason::kLostPerson);
      EXPECT_EQ(robot().speed_scale, 0.0);
      EXPECT_EQ(s.distance, -kInfinity);
      EXPECT_EQ(s.trust, Trust::kNone);
    }
  }
  // It stays until a person lets it go on, and then only when the skeleton is there again.
  joints(1.0, 1.01, true);
  scene->cycle(1.01);
  EXPECT_EQ(robot().state, safety::StopState::kWaitingForReset);
  person(1.02);
  joints(1.0, 1.02);
  scene->cycle(1.02);
  EXPECT_EQ(robot().state, safety::StopState::kWaitingForReset);
  joints(1.0, 1.03, true);
  scene->cycle(1.03);
  EXPECT_EQ(robot().state, safety::StopState::kRunning);
  EXPECT_GT(scene->report().separation[0].distance, 1.0);
}

TEST_F(ServedSceneTest, ReportsAdmittanceOffset) {
  control::ReactionDescription reaction;
  reaction.repulsion.emplace();
  reaction.repulsion->range = 0.2;
  reaction.repulsion->force = 100.0;
  reaction.repulsion->damping = 0.0;
  reaction.admittance.emplace();
  reaction.admittance->inertia = {1.0};
  reaction.admittance->damping = {50.0};
  reaction.admittance->stiffness = {500.0};
  reaction.admittance->offset = {1.0};
  open(false, reaction);
  ASSERT_EQ(scene->report().offset.size(), 1u);
  // The ball is kept 0.1 m over the plate, so the push is 100 N (0.1 / 0.2)^2 = 25 N, and its offset at rest
  // 25 N / 500 N/m.
  for (int i = 0; i <= 3000; ++i) {
    joints(0.2, 1e-3 * i);
    scene->cycle(1e-3 * i);
  }
  // The laws take the distance less its bound, a sixth of a millimetre at most.
  EXPECT_NEAR(scene->report().offset[0], 0.05, 2e-4);
  open(false);
  EXPECT_TRUE(scene->report().offset.empty());
}

TEST(ServedMass, TorqueAndEnergyStopMatchClosedLoop) {
  // A slide of 2 kg drives towards a ball that nobody moves, damped by a weak potential that cannot stop it.
  // The closed loop says where it is in every millisecond, and what it was told; served, it is told the same.
  const char* const reaction = "{repulsion: {range: 0.4, force: 0.35, damping: 1}}";
  const char* const plan = "    motion: come.csv\n";
  abstand::testing::SlideScene run(reaction, "", plan), sent(reaction, "", plan);
  loop::ClosedLoop loop(*run.session, 0.0);
  ServedOptions options;
  options.scene_first = true;
  ServedScene scene(std::move(sent.session), options);
  EXPECT_TRUE(scene.remarks().empty());
  Packet packet = makePacket(scene.format());
  packet.type = PacketType::kJoints;
  packet.index = 0;
  packet.values = 1;
  double most = 0.0;
  bool stopped = false;
  for (int i = 0; i < 1900; ++i) {
    const double t = 1e-3 * i;
    packet.q[0] = loop.robots()[0]->q()[0];
    packet.time_us = static_cast<std::uint64_t>(1000) * static_cast<std::uint64_t>(i);
    loop.step();
    scene.take(packet, t);
    scene.cycle(t);
    const double torque = loop.robots()[0]->torque()[0];
    ASSERT_EQ(scene.report().robots[0].state, loop.robots()[0]->stops().state()) << t;
    ASSERT_NEAR(scene.report().torque[0], torque, 1e-9) << t;
    most = std::max(most, std::abs(torque));
    stopped = stopped || loop.robots()[0]->stops().state() == safety::StopState::kEmergencyStop;
  }
  EXPECT_GT(most, 0.01);
  EXPECT_TRUE(stopped);
}

TEST_F(ServedSceneTest, RemarksConstantMassForRobotWithoutInertia) {
  control::ReactionDescription reaction;
  reaction.repulsion.emplace();
  open(false, reaction);
  ASSERT_EQ(scene->remarks().size(), 1u);
  EXPECT_NE(scene->remarks()[0].find("constant mass of 5 kg"), std::string::npos) << scene->remarks()[0];
}

TEST_F(ServedSceneTest, EmergencyStopHoldsWhileClientMoves) {
  control::ReactionDescription reaction;
  reaction.repulsion.emplace();
  reaction.repulsion->range = 0.5;
  reaction.repulsion->force = 1.0;
  reaction.repulsion->stop_share = 0.0;  // any approach of its own within range is more than it can take
  open(false, reaction);
  // Up and down over the plate, every posture sent twice, as a client does that samples slower than it sends:
  // every other cycle it seems to rest, and at every turn it does.
  int i = 0;
  for (; i <= 2000; ++i) {
    const double t = 1e-3 * i;
    joints(0.4 + 0.1 * std::cos(20.0 * 1e-3 * (i / 2 * 2)), t, i == 1500);
    scene->cycle(t);
    if (i == 1500) {
      EXPECT_EQ(robot().refusal, safety::ResetRefusal::kTooEarly);
      std::vector<std::byte> bytes(stateBytes(scene->report()));
      writeState(scene->report(), {}, bytes);
      EXPECT_EQ(std::to_integer<int>(bytes[24]), 4) << "the flag of the answer";
    }
    if (i > 1) {
      ASSERT_EQ(robot().state, safety::StopState::kEmergencyStop) << t;
      ASSERT_EQ(scene->report().torque[0], 0.0) << t;
    }
  }
  const safety::StopLog& log = scene->robots()[0]->stops();
  ASSERT_EQ(log.count(), 1u) << "one stop, however often it could have been left";
  EXPECT_EQ(log.entry(0).cause.reason, safety::StopReason::kEnergy);

  // It obeys: from then on 0.1 s, the reset, and it runs.
  const double q = scene->session().mechanisms()[0]->q()[0];
  for (; robot().state == safety::StopState::kEmergencyStop; ++i) {
    joints(q, 1e-3 * i);
    scene->cycle(1e-3 * i);
  }
  EXPECT_EQ(robot().state, safety::StopState::kWaitingForReset);
  EXPECT_NEAR(1e-3 * i, 2.1, 3e-3);
  joints(q, 1e-3 * i, true);
  scene->cycle(1e-3 * i);
  EXPECT_EQ(robot().state, safety::StopState::kRunning);
  EXPECT_EQ(robot().refusal, safety::ResetRefusal::kNone);
}

TEST_F(ServedSceneTest, BoundsWidenWithSkeletonAge) {
  open(true);
  person(0.5);
  joints(1.0, 0.5);
  scene->cycle(0.5);
  const PairReport fresh = scene->report().separation[0];
  // Nothing moves, and what is proven shrinks at the speed that a person may have (2.0 m/s), until they are
  // lost.
  for (const double age : {0.001, 0.05, 0.09}) {
    scene->cycle(0.5 + age);
    const PairReport& now = scene->report().separation[0];
    EXPECT_EQ(now.distance, fresh.distance);
    EXPECT_NEAR(now.bound - fresh.bound, 2.0 * age, 1e-9) << age;
  }
}

TEST_F(ServedSceneTest, BoundsWidenForInferredJoints) {
  open(true);
  person(0.5);
  joints(1.0, 0.5);
  scene->cycle(0.5);
  const PairReport tracked = scene->report().separation[0];
  packet.skeleton.state.fill(humanmodel::JointState::kInferred);
  packet.type = PacketType::kSkeleton;
  packet.index = 0;
  scene->take(packet, 0.5);
  scene->cycle(0.5);
  const PairReport guessed = scene->report().separation[0];
  EXPECT_EQ(guessed.distance, tracked.distance);
  EXPECT_NEAR(guessed.bound - tracked.bound, humanmodel::kSpreadQuantile * humanmodel::kGuessedSpread, 1e-9);
}

TEST_F(ServedSceneTest, UncertainPoseStopsRobotWhereShownPoseWouldNot) {
  control::ReactionDescription reaction = usualReaction();
  reaction.watch.distance = 0.3;
  open(true, reaction);
  person(0.5, -2.35);
  joints(1.0, 0.5);
  scene->cycle(0.5);
  EXPECT_EQ(robot().state, safety::StopState::kRunning);
  packet.skeleton.state.fill(humanmodel::JointState::kInferred);
  packet.type = PacketType::kSkeleton;
  packet.index = 0;
  scene->take(packet, 0.5);
  scene->cycle(0.501);
  EXPECT_EQ(robot().state, safety::StopState::kProtectiveStop);
  const PairReport& s = scene->report().separation[0];
  EXPECT_GT(s.distance, reaction.watch.distance);
  const safety::StopCause& cause = scene->robots()[0]->cause();
  EXPECT_EQ(cause.reason, safety::StopReason::kDistance);
  EXPECT_NEAR(cause.value, s.distance - s.bound, 1e-9);
}

TEST_F(ServedSceneTest, StaleJointsStopRobotAtStatedTime) {
  open(false);
  joints(0.5, 0.01);
  scene->cycle(0.01);
  EXPECT_NEAR(scene->nextStale(), 0.11, 1e-12);
  scene->cycle(0.109);
  EXPECT_EQ(robot().state, safety::StopState::kRunning);
  scene->cycle(0.1101);
  EXPECT_EQ(robot().state, safety::StopState::kProtectiveStop);
  EXPECT_EQ(robot().reason, safety::StopReason::kStaleInput);
  EXPECT_EQ(scene->report().nearest[0].distance, -kInfinity);
  EXPECT_EQ(scene->report().torque[0], 0.0);
  EXPECT_EQ(scene->robots()[0]->stops().count(), 1u);
}

TEST_F(ServedSceneTest, ApproachingPersonSlowsRobot) {
  open(true);
  // The ball stands; a person at its side leaves no room to move: the scale is 0 while it goes towards them.
  double least = 1.0;
  for (int i = 1; i <= 50; ++i) {
    const double t = 0.01 * i;
    person(t, -2.7);
    joints(2.5 - 0.02 * i, t);  // down at 2 m/s, towards the head
    scene->cycle(t);
    least = std::min(least, robot().speed_scale);
  }
  EXPECT_EQ(least, 0.0);
  const PairReport& s = scene->report().separation[0];
  EXPECT_LT(s.distance, 1.0);
  EXPECT_EQ(s.trust, Trust::kFresh);

  // A cycle and its answer allocate nothing.
  std::vector<std::byte> bytes(stateBytes(scene->report()));
  const abstand::testing::NoAlloc guard;
  for (int i = 51; i <= 110; ++i) {
    person(0.01 * i, -0.03 * i);
    joints(1.5 - 0.015 * (i - 50), 0.01 * i);
    scene->cycle(0.01 * i);
    writeState(scene->report(), {}, bytes);
  }
  scene->cycle(3.0);  // everything becomes stale
  EXPECT_EQ(guard.count(), 0);
  EXPECT_NE(robot().state, safety::StopState::kRunning);
}

}  // namespace served_scene_test
}  // namespace abstand::serve
