// Changes of a reaction as values, and their exchange while a robot runs.
#include "core/control/reaction_change.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/base/error.hpp"
#include "core/control/reaction.hpp"
#include "core/control/reaction_reader.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::control {
namespace reaction_change_test {

const Eigen::MatrixXd kNoMass;
constexpr int kDof = 2;

ReactionDescription sceneReaction() {
  ReactionDescription scene;
  scene.torque = TorqueLimitOptions{.gain = 2.0, .limit = {30.0}};
  scene.repulsion = RepulsionOptions{.range = 0.1, .force = 40.0, .damping = 0.0};
  return scene;
}

std::string problemOf(const ReactionChange& change) {
  try {
    changedReaction(sceneReaction(), change, kDof);
  } catch (const UsageError& e) {
    return e.what();
  }
  return "none";
}

TEST(ReactionChange, EmptyChangeIsSceneAndNumbersReplaceOnlyTheirOwn) {
  const ReactionDescription scene = sceneReaction();
  EXPECT_EQ(describeReaction(changedReaction(scene, {}, kDof)), describeReaction(scene));
  ReactionChange change;
  change.numbers["torque.gain"] = {5.0};
  change.numbers["torque.limit"] = {10.0, 20.0};
  change.numbers["stop.distance"] = {0.03};
  change.numbers["stop.resume_after"] = {kInfinity};
  change.numbers["hold.frequency"] = {3.0};
  ReactionDescription expected = scene;
  expected.torque->gain = 5.0;
  expected.torque->limit = {10.0, 20.0};
  expected.watch.distance = 0.03;
  expected.hold.frequency = 3.0;
  EXPECT_EQ(describeReaction(changedReaction(scene, change, kDof)), describeReaction(expected));
}

TEST(ReactionChange, LawsAreSwitchedAndKeepTheirNumbers) {
  ReactionChange change;
  change.numbers["repulsion.force"] = {70.0};
  change.laws = {{"repulsion", false}, {"speed", true}};
  const ReactionDescription off = changedReaction(sceneReaction(), change, kDof);
  EXPECT_FALSE(off.repulsion);
  ASSERT_TRUE(off.speed);
  EXPECT_EQ(off.speed->release, SpeedScaleOptions().release) << "the scene has none: the defaults";
  change.laws.erase("repulsion");
  EXPECT_EQ(changedReaction(sceneReaction(), change, kDof).repulsion->force, 70.0);
}

TEST(ReactionChange, InvalidChangesAreRefusedWithSentence) {
  const auto number = [](const char* key, config::JointNumbers value) {
    ReactionChange change;
    change.numbers[key] = std::move(value);
    return problemOf(change);
  };
  const auto law = [](const char* name, bool on) {
    ReactionChange change;
    change.laws[name] = on;
    return problemOf(change);
  };
  EXPECT_EQ(number("torque.gain", {-1.0}), "torque.gain -1: expected a number from 0 to 1e+06");
  EXPECT_NE(number("torque.gain", {kNaN}).find("torque.gain nan: expected"), std::string::npos);
  EXPECT_NE(number("torque.gain", {1.0, 2.0}).find("found 2 numbers, expected one"), std::string::npos);
  EXPECT_NE(number("torque.limit", {1.0, 2.0, 3.0}).find("one for each of 2 joints"), std::string::npos);
  EXPECT_NE(number("torque.limit", {}).find("found 0 numbers"), std::string::npos);
  EXPECT_NE(number("repulsion.stop_distance", {0.1}).find("expected less than the range, 0.1 m"),
            std::string::npos);
  EXPECT_NE(number("repulsion.push", {1.0}).find("found 'repulsion.push'"), std::string::npos);
  EXPECT_EQ(law("admittance", true), "none");
  EXPECT_EQ(law("admittance", false), "none") << "it is off";
  EXPECT_NE(law("hold", false).find("unknown law"), std::string::npos);
  // The numbers of a law that is off are checked, too.
  EXPECT_NE(number("speed.release", {0.0}).find("speed.release 0"), std::string::npos);
}

TEST(ReactionChange, ResponsesReplaceOnlyTheirOwn) {
  const ReactionDescription scene = sceneReaction();
  ReactionChange change;
  change.responses["lost_person"] = safety::StopResponse::kEmergency;
  ReactionDescription expected = scene;
  expected.stop.policy.response[static_cast<std::size_t>(safety::StopReason::kLostPerson)] =
      safety::StopResponse::kEmergency;
  EXPECT_EQ(describeReaction(changedReaction(scene, change, kDof)), describeReaction(expected));
  EXPECT_NE(describeReaction(scene), describeReaction(expected));
  const std::vector<StopChoice> choices = lawStates(scene, change).back().responses;
  ASSERT_EQ(choices.size(), safety::kStopReasons);
  for (const StopChoice& choice : choices) {
    EXPECT_EQ(choice.scene, scene.stop.policy.of(choice.reason));
    EXPECT_EQ(choice.value, expected.stop.policy.of(choice.reason));
  }
  change.responses = {{"rain", safety::StopResponse::kNone}};
  EXPECT_EQ(problemOf(change), "found 'rain', expected a reason of a stop");
}

TEST(ReactionChange, StatesListEveryNumberOnceWithBothValues) {
  ReactionChange change;
  change.numbers["torque.gain"] = {5.0};
  change.laws["repulsion"] = false;
  const std::vector<LawState> laws = lawStates(sceneReaction(), change);
  std::vector<std::string> names;
  std::set<std::string> keys;
  for (const LawState& law : laws) {
    names.push_back(law.name);
    for (const LawNumber& number : law.numbers) {
      EXPECT_TRUE(keys.insert(number.key).second) << number.key;
      // Every number listed can be changed.
      ReactionChange one;
      one.numbers[number.key] = number.scene;
      EXPECT_EQ(problemOf(one), "none") << number.key;
    }
  }
  EXPECT_EQ(names, (std::vector<std::string>{"torque", "repulsion", "proxy", "admittance", "speed", "braking",
                                             "hold", "stop"}));
  EXPECT_EQ(laws[0].numbers[0].value, config::JointNumbers{5.0});
  EXPECT_EQ(laws[0].numbers[0].scene, config::JointNumbers{2.0});
  EXPECT_FALSE(laws[1].on);
  EXPECT_TRUE(laws[1].scene_on);
  for (const LawState& law : laws) {
    EXPECT_EQ(law.switchable, law.name != "hold" && law.name != "stop") << law.name;
    EXPECT_EQ(law.restarts, law.name == "proxy" || law.name == "admittance") << law.name;
  }
}

/// Two joints; one cycle's input.
struct Cycle {
  std::vector<double> qd{0.0, 0.0}, efforts{1.0, -3.0};
  std::vector<safety::StopCause> causes;
  ReactionInput in;
  const ReactionInput& at(double t, bool reset = false) {
    in.t = t;
    in.dt = 1e-3;
    in.qd = qd;
    in.efforts = efforts;
    in.causes = causes;
    in.reset = reset;
    return in;
  }
};

TEST(ExchangeLaws, TorqueIsProportionalToGainAndLawOffGivesZero) {
  Reaction reaction(sceneReaction(), kDof, 4);
  Cycle c;
  EXPECT_EQ(reaction.update(c.at(0.0), kNoMass).torque[1], -6.0);
  ReactionDescription changed = sceneReaction();
  changed.torque->gain = 5.0;
  Reaction strong(changed, kDof, 4);
  changed.torque.reset();
  Reaction off(changed, kDof, 4);
  {
    testing::NoAlloc guard;
    reaction.exchangeLaws(strong);
    EXPECT_EQ(reaction.update(c.at(0.001), kNoMass).torque[1], -15.0);
    reaction.exchangeLaws(off);
    EXPECT_EQ(reaction.update(c.at(0.002), kNoMass).torque[1], 0.0);
    EXPECT_EQ(guard.count(), 0);
  }
  EXPECT_EQ(strong.description().torque->gain, 2.0) << "it holds the former laws";
}

TEST(ExchangeLaws, ActiveStopNeedsReset) {
  ReactionDescription scene = sceneReaction();
  scene.stop.resume_after = 0.05;
  for (const safety::StopReason reason : {safety::StopReason::kDistance, safety::StopReason::kUser}) {
    Reaction reaction(scene, kDof, 4);
    Cycle c;
    double t = 0.0;
    const auto run = [&](double seconds) {
      for (const double end = t + seconds; t < end; t += 1e-3) reaction.update(c.at(t), kNoMass);
      return reaction.stops().state();
    };
    run(0.1);
    c.causes = {{reason, 0.01, 0.02, 3, -1}};
    run(0.01);
    const safety::StopState stopped = reaction.stops().state();
    ASSERT_TRUE(stopped == safety::StopState::kProtectiveStop ||
                stopped == safety::StopState::kEmergencyStop);
    // The response to this cause is now none, and it is gone besides: the stop stays.
    ReactionDescription mild = scene;
    mild.stop.policy.response.fill(safety::StopResponse::kNone);
    mild.torque.reset();
    Reaction next(mild, kDof, 4);
    const double since = reaction.stops().since();
    reaction.exchangeLaws(next);
    EXPECT_EQ(reaction.stops().state(), stopped);
    EXPECT_EQ(reaction.stops().since(), since);
    EXPECT_EQ(reaction.stops().cause().reason, reason);
    EXPECT_EQ(reaction.stops().log().count(), 1u);
    c.causes.clear();
    EXPECT_EQ(run(1.0), safety::StopState::kWaitingForReset) << "it does not resume by itself";
    EXPECT_EQ(reaction.update(c.at(t += 1e-3, true), kNoMass).state, safety::StopState::kRunning);
    // A later stop follows the rules again.
    Reaction again(scene, kDof, 4);
    reaction.exchangeLaws(again);
    c.causes = {{safety::StopReason::kDistance, 0.01, 0.02, 3, -1}};
    run(0.01);
    c.causes.clear();
    EXPECT_EQ(run(0.2), safety::StopState::kRunning);
  }
}

TEST(ExchangeLaws, BrakesStayEngaged) {
  Reaction reaction(sceneReaction(), kDof, 4);
  Cycle c;
  c.causes = {{safety::StopReason::kUser, kNaN, kNaN, -1, -1}};
  EXPECT_TRUE(reaction.update(c.at(0.0), kNoMass).brakes);
  Reaction next(sceneReaction(), kDof, 4);
  reaction.exchangeLaws(next);
  c.causes.clear();
  const ReactionOutput out = reaction.update(c.at(0.001), kNoMass);
  EXPECT_TRUE(out.brakes);
  EXPECT_EQ(out.torque[0], 0.0);
}

TEST(ExchangeLaws, AdmittanceKeepsOffset) {
  ReactionDescription scene = sceneReaction();
  scene.admittance = AdmittanceOptions{.inertia = {1.0}, .damping = {10.0}, .stiffness = {20.0}};
  Reaction reaction(scene, kDof, 4);
  Cycle c;
  for (int i = 0; i < 100; ++i) reaction.update(c.at(i * 1e-3), kNoMass);
  const double offset = reaction.update(c.at(0.1), kNoMass).offset[1];
  ASSERT_LT(offset, -1e-3);
  scene.admittance->stiffness = {40.0};
  Reaction next(scene, kDof, 4);
  reaction.exchangeLaws(next);
  // It goes on from there, and comes to rest at tau / k = -6 / 40.
  EXPECT_NEAR(reaction.update(c.at(0.101), kNoMass).offset[1], offset, 1e-3);
  ReactionOutput out;
  for (int i = 0; i < 5000; ++i) out = reaction.update(c.at(0.102 + i * 1e-3), kNoMass);
  EXPECT_NEAR(out.offset[1], -6.0 / 40.0, 1e-6);
}

}  // namespace reaction_change_test
}  // namespace abstand::control
