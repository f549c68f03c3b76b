// The `reaction` of a mechanism: read, refused, written and read again.
#include "core/control/reaction_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace abstand::control {
namespace reaction_reader_test {

using ::testing::HasSubstr;
using ::testing::StartsWith;

ReactionDescription read(const std::string& text) {
  const config::YamlNode node = config::parseYaml(text, "r.yaml");
  return readReaction(node, "r.yaml");
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const ParseError& e) {
    return e.what();
  }
  return "it was read";
}

const char* const kWhole = R"(
torque: {gain: 0.5, limit: [10, 20, 30], cut: each}
repulsion: {range: 0.2, force: 80, damping: 1, mass: 3, stop_distance: 0.02, stop_share: 0.5}
proxy: {stiffness: 500, rotation_stiffness: 4, force: 20, torque: 2, gap: 0.001, step: 0.002}
admittance: {inertia: 2, damping: [1, 2, 3], stiffness: 0, velocity: 0.7, offset: 0.1}
speed: {reaction_time: 0.2, stopping_time: 0.4, deceleration: 3, intrusion: 0.1, person_error: 0.02,
        robot_error: 0.01, person_speed: 1.5, person_speed_near: 2.5, near: 0.4, person_acceleration: 6,
        release: 1, least: 0.05}
braking: {deceleration: [3, 4, 5], reaction_time: 0.02, joints: together, distance: 0.03, person_speed: 1.6,
          person_acceleration: 40}
hold: {frequency: 4, damping: 0.8}
stop: {distance: 0.03, input_age: 0.05, person_age: 0.5, joint_speed: 2.5, resume_after: 1.5, standstill: 0.01,
       slow_to: 0.3, on: {lost_person: slow, distance: emergency, torque: protective}}
)";

TEST(ReactionReader, ReadsEveryKey) {
  const ReactionDescription r = read(kWhole);
  ASSERT_TRUE(r.torque && r.repulsion && r.proxy && r.admittance && r.speed);
  EXPECT_EQ(r.torque->gain, 0.5);
  EXPECT_EQ(r.torque->limit, (config::JointNumbers{10, 20, 30}));
  EXPECT_EQ(r.torque->cut, TorqueCut::kEach);
  EXPECT_EQ(r.repulsion->range, 0.2);
  EXPECT_EQ(r.repulsion->stop_share, 0.5);
  EXPECT_EQ(r.proxy->rotation_stiffness, 4.0);
  EXPECT_EQ(r.admittance->damping, (config::JointNumbers{1, 2, 3}));
  EXPECT_EQ(r.admittance->stiffness, (config::JointNumbers{0}));
  EXPECT_EQ(r.speed->separation.person_acceleration, 6.0);
  EXPECT_EQ(r.speed->release, 1.0);
  ASSERT_TRUE(r.braking);
  EXPECT_EQ(r.braking->path.deceleration, (config::JointNumbers{3, 4, 5}));
  EXPECT_EQ(r.braking->path.reaction_time, 0.02);
  EXPECT_EQ(r.braking->path.kind, safety::BrakingKind::kTogether);
  EXPECT_EQ(r.braking->distance, 0.03);
  EXPECT_EQ(r.braking->person_speed, 1.6);
  EXPECT_EQ(r.braking->person_acceleration, 40.0);
  EXPECT_EQ(r.hold.frequency, 4.0);
  EXPECT_EQ(r.hold.damping, 0.8);
  EXPECT_EQ(r.watch.distance, 0.03);
  EXPECT_EQ(r.watch.joint_speed, (config::JointNumbers{2.5}));
  EXPECT_EQ(r.stop.resume_after, 1.5);
  EXPECT_EQ(r.stop.slow_to, 0.3);
  EXPECT_EQ(r.stop.policy.of(safety::StopReason::kLostPerson), safety::StopResponse::kSlow);
  EXPECT_EQ(r.stop.policy.of(safety::StopReason::kDistance), safety::StopResponse::kEmergency);
  EXPECT_EQ(r.stop.policy.of(safety::StopReason::kTorque), safety::StopResponse::kProtective);
  EXPECT_EQ(r.stop.policy.of(safety::StopReason::kUser), safety::StopResponse::kEmergency) << "as it was";
}

TEST(ReactionReader, OmittedLawsAreInactive) {
  const ReactionDescription r = read("{}");
  EXPECT_FALSE(r.torque || r.repulsion || r.proxy || r.admittance || r.speed || r.braking);
  EXPECT_EQ(r.stop.resume_after, kInfinity);
  const ReactionDescription defaults = read("repulsion: {}");
  ASSERT_TRUE(defaults.repulsion);
  EXPECT_EQ(defaults.repulsion->range, RepulsionOptions{}.range);
}

TEST(ReactionReader, RoundTrips) {
  for (const char* text :
       {kWhole, "{}", "repulsion: {}", "torque: {}\nspeed: {}\nstop: {joint_speed: [1, 2]}",
        "admittance: {}\nproxy: {}", "braking: {}"}) {
    const std::string once = describeReaction(read(text));
    const std::string twice = describeReaction(read(once));
    EXPECT_EQ(once, twice);
  }
  EXPECT_THAT(describeReaction(read(kWhole)),
              HasSubstr("torque: {gain: 0.5, limit: [10, 20, 30], cut: each}\n"));
  EXPECT_THAT(describeReaction(read(kWhole), "      "), StartsWith("      torque: {"));
}

TEST(ReactionReader, ReportsErrorsWithPosition) {
  struct Case {
    const char* text;
    const char* expected;
  };
  for (const Case& c : {
           Case{"[]", "r.yaml:1:1: error: found a list for `reaction`, expected a map"},
           Case{"repulsoin: {}",
                "r.yaml:1:1: error: found the unknown key `repulsoin` in `reaction`, expected one "
                "of torque, repulsion, proxy, admittance, speed, braking, hold, stop\nhint: did you mean "
                "`repulsion`?"},
           Case{"repulsion: {rnge: 1}", "hint: did you mean `range`?"},
           Case{"repulsion: {range: 0}",
                "r.yaml:1:20: error: found `0` for `range`, expected a number above 0 and at most 10 m"},
           Case{"repulsion: {range: 0.1, stop_distance: 0.2}",
                "found a `stop_distance` of 0.2, expected less than the `range`, 0.1 m"},
           Case{"torque: {limit: []}", "r.yaml:1:17: error: found an empty list for `limit`"},
           Case{"torque: {limit: [1, x]}", "found `x` for `limit`, expected a finite number"},
           Case{"torque: {limit: -1}", "found `-1` for `limit`, expected a number from 0 to inf N m or N"},
           Case{"torque: {cut: eech}", "did you mean `each`?"},
           Case{"speed: {person_sped: 1}", "did you mean `person_speed`?"},
           Case{"speed: {reaction_time: nan}", "expected a finite number"},
           Case{"stop: {on: {lost_persn: slow}}", "did you mean `lost_person`?"},
           Case{"stop: {on: {user: emergancy}}", "did you mean `emergency`?"},
           Case{"stop: {on: slow}", "found `slow` for `on`, expected a map"},
           Case{"braking: {joints: eech}", "did you mean `each`?"},
           Case{"braking: {deceleration: 0}", "expected a number above 0 and at most 1e+06 rad/s^2 or m/s^2"},
           Case{"admittance: 3", "r.yaml:1:13: error: found `3` for `admittance`, expected a map"},
           Case{"proxy: {step: {}}", "found a map for `step`, expected a finite number"},
       })
    EXPECT_THAT(refusal(c.text), HasSubstr(c.expected)) << c.text;
}

}  // namespace reaction_reader_test
}  // namespace abstand::control
