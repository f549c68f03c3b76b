// Permitted speeds by contact limits, their proof by replay, and the trade of speed against margin.
#include <gtest/gtest.h>

#include "app/tune/speed_proof.hpp"
#include "core/base/error.hpp"
#include "core/contact/contact_limits_reader.hpp"
#include "core/contact/predicted_contact.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::tune {
namespace speeds_test {

// m and m/s: engine's distances, and speeds in whole steps.
constexpr double kEngine = 3e-4;

TuneOptions withLimits() {
  TuneOptions options;
  options.pass.contact = std::make_shared<const contact::ContactLimits>(
      contact::loadContactLimits(contact::defaultContactLimits(), humanmodel::partNames()));
  return options;
}

/// m/s, the least allowed one of all regions of a part against a wall, in closed form.
double allowedSpeedOf(const TuneOptions& options, const std::string& part) {
  double least = kInfinity;
  for (const contact::RegionLimits* r : options.pass.contact->regionsOf(part))
    least = std::min(least,
                     r->transient.value * r->force.value / std::sqrt(r->body_mass.value * r->spring.value));
  return least;
}

const PartClearance& clearanceOf(const TunedRecording& tuned, const std::string& name) {
  for (const PartClearance& p : tuned.pass.parts)
    if (p.part == name) return p;
  throw std::runtime_error(name);
}

struct ContactCase {
  const char* name;
  testing::SlideSpeeds speeds;
};

class ContactSpeed : public ::testing::TestWithParam<ContactCase> {};

TEST_P(ContactSpeed, MatchesClosedFormWhenNearAndApproaching) {
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, GetParam().speeds);
  const TuneOptions options = withLimits();
  const TunedRecording tuned = tuneRecording(*session, options, {}, "slide");
  const PartClearance& torso = clearanceOf(tuned, "torso");
  const double allowed = allowedSpeedOf(options, "torso");
  EXPECT_FALSE(torso.contact_excluded);
  std::size_t compared = 0;
  for (std::size_t i = 0; i + 1 < torso.track.frames(); ++i) {
    const double robot = torso.robot_speed[i], person = torso.person_speed[i];
    const bool judged = torso.track.clearance[i] < options.pass.near && robot > 0.0;
    const double expected = judged ? std::clamp((allowed - person) / robot, 0.0, 1.0) : 1.0;
    EXPECT_NEAR(torso.contact_scale[i], expected, 4.0 * kEngine) << i;
    if (!judged || robot + person < allowed - kEngine) {
      EXPECT_EQ(torso.contact_scale[i], 1.0) << i;
    }
    compared += judged;
  }
  EXPECT_EQ(compared > 5, GetParam().speeds.robot > 0.0) << compared;
}

// Two masses and a spring, one of the masses a wall: F = v sqrt(m_H k) and E = m_H v^2 / 2, in each frame.
TEST_P(ContactSpeed, PredictsContactOfEachFrameInClosedForm) {
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, GetParam().speeds);
  const TuneOptions options = withLimits();
  const TunedRecording tuned = tuneRecording(*session, options, {}, "slide");
  const PartClearance& torso = clearanceOf(tuned, "torso");
  std::size_t predicted = 0;
  for (std::size_t i = 0; i + 1 < torso.track.frames(); ++i) {
    const FrameContact& contact = torso.contact[i];
    const double closing = torso.robot_speed[i] + torso.person_speed[i];
    if (!(torso.track.clearance[i] < options.pass.near && closing > kEngine)) {
      EXPECT_LE(contact.share, kEngine) << i;
      continue;
    }
    ++predicted;
    ASSERT_LT(contact.region, tuned.pass.regions.size()) << i;
    const contact::RegionLimits* region = options.pass.contact->region(tuned.pass.regions[contact.region]);
    ASSERT_NE(region, nullptr);
    const double mass = region->body_mass.value, k = region->spring.value;
    EXPECT_NEAR(contact.force, closing * std::sqrt(mass * k), kEngine * std::sqrt(mass * k)) << i;
    EXPECT_NEAR(contact.energy, 0.5 * mass * closing * closing, kEngine * mass * closing) << i;
    EXPECT_EQ(tuned.pass.links[contact.link], tuned.pass.links[torso.link[i]]);
    const double allowed = allowedSpeedOf(options, "torso");
    EXPECT_GE(contact.share, closing / allowed - kEngine / allowed) << i;
    // The speed of the robot is cut exactly where a limit is broken.
    if (torso.robot_speed[i] > kEngine && std::abs(contact.share - 1.0) > kEngine) {
      EXPECT_EQ(contact.share > 1.0, torso.contact_scale[i] < 1.0) << i;
    }
  }
  EXPECT_EQ(torso.contacts.worst.has_value(), predicted > 0);
  double exceeded = 0.0;
  for (std::size_t i = 0; i + 1 < torso.track.frames(); ++i)
    if (torso.contact[i].share > 1.0) exceeded += torso.track.t[i + 1] - torso.track.t[i];
  EXPECT_NEAR(torso.contacts.exceeded, exceeded, 1e-12);
  // A robot that goes away never has the person near.
  EXPECT_EQ(predicted > 5, GetParam().speeds.robot >= 0.0) << predicted;
}

TEST(ContactSpeed, PredictsNoContactThatIsAllowedForHead) {
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, {.robot = 0.5, .seconds = 4.2});
  TuneOptions options = withLimits();
  options.pass.near = 1.0;
  const TunedRecording tuned = tuneRecording(*session, options, {}, "slide");
  const PartClearance& head = clearanceOf(tuned, "head");
  std::size_t near = 0;
  for (const FrameContact& contact : head.contact) {
    if (!(contact.share > 0.0)) continue;
    ++near;
    EXPECT_EQ(contact.share, kInfinity);
    EXPECT_GT(contact.force, 0.0);
  }
  EXPECT_GT(near, 5u);
}

INSTANTIATE_TEST_SUITE_P(
    Speeds, ContactSpeed,
    ::testing::Values(ContactCase{"slowed_down", {.robot = 0.5, .seconds = 4.2}},
                      ContactCase{"slower_than_allowed", {.robot = 0.2, .person = 0.05, .seconds = 8.4}},
                      ContactCase{"person_takes_a_share", {.robot = 0.4, .person = 0.1, .seconds = 4.2}},
                      ContactCase{"person_alone_breaks_it", {.robot = 0.2, .person = 0.6, .seconds = 2.7}},
                      ContactCase{"robot_stands", {.robot = 0.0, .person = 0.7, .stops_at = 3.0}},
                      ContactCase{"robot_goes_away", {.robot = -0.2, .person = 1.0, .stops_at = 2.5}}),
    [](const auto& c) { return c.param.name; });

TEST(ContactSpeed, IsZeroForClampedPartAgainstWall) {
  // Of a clamped part no mass recoils, and a robot without masses counts as a wall.
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, {.robot = 0.1, .seconds = 22.0});
  TuneOptions options = withLimits();
  options.pass.clamped = {"torso"};
  const TunedRecording tuned = tuneRecording(*session, options, {}, "slide");
  const PartClearance& torso = clearanceOf(tuned, "torso");
  std::size_t judged = 0;
  for (std::size_t i = 0; i + 1 < torso.track.frames(); ++i) {
    const bool near = torso.track.clearance[i] < options.pass.near && torso.robot_speed[i] > 0.0;
    judged += near;
    EXPECT_EQ(torso.contact_scale[i], near ? 0.0 : 1.0) << i;
  }
  EXPECT_GT(judged, 5u);
}

TEST(ContactSpeed, UsesSeparationForHead) {
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, {.robot = 0.5, .seconds = 4.2});
  const TunedRecording tuned = tuneRecording(*session, withLimits(), {}, "slide");
  const PartClearance& head = clearanceOf(tuned, "head");
  EXPECT_TRUE(head.contact_excluded);
  EXPECT_EQ(head.contact_scale, head.separation.speed_scale);
  EXPECT_EQ(*std::min_element(head.contact_scale.begin(), head.contact_scale.end()), 0.0);
  // Without a table no contact is known to be within limits: so it is with every part.
  const auto again = testing::openSlide(folder, {.robot = 0.5, .seconds = 4.2});
  const TunedRecording unknown = tuneRecording(*again, {}, {}, "slide");
  for (const PartClearance& p : unknown.pass.parts) {
    EXPECT_TRUE(p.contact_excluded) << p.part;
    EXPECT_EQ(p.contact_scale, p.separation.speed_scale) << p.part;
  }
}

TEST(SpeedRules, UseTheirOwnScalePerSegment) {
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, {.robot = 0.5, .seconds = 4.2});
  const std::vector<TunedRecording> all{tuneRecording(*session, withLimits(), {}, "slide")};
  const auto both = speedTable(all, 0.5, SpeedRule::kBoth);
  const auto separation = speedTable(all, 0.5, SpeedRule::kSeparation);
  const auto contact = speedTable(all, 0.5, SpeedRule::kContact);
  ASSERT_EQ(both.size(), contact.size());
  bool apart = false;
  for (std::size_t s = 0; s < both.size(); ++s) {
    double by_separation = 1.0, by_contact = 1.0;
    for (const PartClearance& p : all[0].pass.parts)
      for (std::size_t i = 0; i < p.track.frames(); ++i)
        if (p.track.t[i] >= both[s].t0 - 1e-9 && p.track.t[i] < both[s].t1 - 1e-9) {
          by_separation = std::min(by_separation, p.separation.speed_scale[i]);
          by_contact = std::min(by_contact, p.contact_scale[i]);
        }
    for (const auto* table : {&both, &separation, &contact}) {
      EXPECT_EQ((*table)[s].by_separation, by_separation) << s;
      EXPECT_EQ((*table)[s].by_contact, by_contact) << s;
      EXPECT_EQ((*table)[s].limited_by.has_value(), (*table)[s].speed_scale < 1.0) << s;
    }
    EXPECT_EQ(both[s].speed_scale, std::min(by_separation, by_contact)) << s;
    EXPECT_EQ(separation[s].speed_scale, by_separation) << s;
    EXPECT_EQ(contact[s].speed_scale, by_contact) << s;
    apart = apart || by_separation < by_contact;
    if (const auto& limit = separation[s].limited_by) {
      EXPECT_EQ(limit->kind, SpeedLimit::kSeparation);
    }
    if (const auto& limit = contact[s].limited_by) {
      EXPECT_EQ(limit->kind, limit->part == "head" ? SpeedLimit::kSeparation : SpeedLimit::kContact);
    }
  }
  EXPECT_TRUE(apart);
}

/// A ball on a rail, people from files, and what replays need.
class SpeedProofTest : public ::testing::Test {
 protected:
  SpeedProofTest() : options_(withLimits()) {
    // S_p = v (0.1 + 0.15): people who do as recorded, at any distance.
    auto& o = options_.pass.separation;
    o.person_speed = o.person_speed_near = 0.0;
    // Contacts with arms and head are farther away than this.
    options_.pass.near = 0.2;
  }
  void make(const testing::SlideSpeeds& speeds, const std::string& motion = "") {
    testing::writeSlide(folder_, speeds);
    if (!motion.empty()) folder_.write("go.csv", motion);
    PlanItem item;
    item.scene = folder_.path() / "slide.yaml";
    item.name = "slide";
    items_ = {item};
    recorded_ = run(items_).recordings;
  }
  ReplayRuns run(const std::vector<PlanItem>& items) {
    ReplayRuns runs;
    for (const PlanItem& item : items) {
      scene_file::SceneDescription scene = scene_file::loadScene(item.scene);
      item.apply(scene);
      session::SessionOptions open;
      open.threads = 1;
      open.cache = false;
      open.rest = 0.0;
      const auto session = depth::openSession(std::move(scene), open);
      runs.recordings.push_back(tuneRecording(*session, options_, {}, item.name));
    }
    return runs;
  }
  ProgramReplay replay() {
    return {items_, recorded_, programMotions(scene_file::loadScene(items_[0].scene)), folder_.path(),
            [this](const std::vector<PlanItem>& items) {
              names_.clear();
              for (const PlanItem& item : items) names_.push_back(item.name);
              return run(items);
            }};
  }
  SpeedProof prove(SpeedRule rule, double segment = 0.5) {
    ProgramReplay r = replay();
    return proveSpeeds(speedTable(recorded_, segment, rule), recorded_, r, {rule, 5.0, 10});
  }

  testing::ScratchFolder folder_;
  TuneOptions options_;
  std::vector<PlanItem> items_;
  std::vector<TunedRecording> recorded_;
  std::vector<std::string> names_;  ///< of the last replay's runs
};

TEST_F(SpeedProofTest, AdmissibleProgramIsProvenAtOnce) {
  make({.robot = 0.2, .seconds = 4.0});
  for (const SpeedRule rule : {SpeedRule::kBoth, SpeedRule::kSeparation, SpeedRule::kContact}) {
    const SpeedProof proof = prove(rule);
    EXPECT_TRUE(proof.proven);
    EXPECT_EQ(proof.iterations, 1);
    EXPECT_EQ(proof.broken_time_separation, 0.0);
    EXPECT_EQ(proof.broken_contacts, 0);
    EXPECT_NEAR(proof.pace->cycleTime(), 4.0, 1e-6);
    EXPECT_EQ(names_, std::vector<std::string>{"slide"});
  }
}

TEST_F(SpeedProofTest, ContactRuleSlowsDownToLimit) {
  make({.robot = 0.5, .seconds = 4.2});
  const double allowed = allowedSpeedOf(options_, "torso");
  ASSERT_LT(allowed, 0.5);
  const SpeedProof proof = prove(SpeedRule::kContact);
  ASSERT_TRUE(proof.proven);
  EXPECT_FALSE(proof.stands);
  // The last stretch is within `near`: 0.98 a replay is what iterations may cost.
  const double share = allowed / 0.5;
  EXPECT_LE(proof.scales.back().scale, share + kEngine);
  EXPECT_GE(proof.scales.back().scale, share * std::pow(0.98, proof.iterations) - 4.0 * kEngine);
  EXPECT_EQ(proof.scales.front().scale, 1.0);
  // It takes longer than the recording, which is met again.
  EXPECT_GT(proof.pace->cycleTime(), 4.2);
  EXPECT_EQ(names_, (std::vector<std::string>{"slide", "slide, round 2"}));
}

TEST_F(SpeedProofTest, SeparationRuleSlowsDownWithDistance) {
  options_.pass.separation.intrusion = 0.05;
  make({.robot = 0.5, .seconds = 4.2});
  const SpeedProof proof = prove(SpeedRule::kSeparation);
  ASSERT_TRUE(proof.proven);
  EXPECT_LE(proof.iterations, 3);
  // v <= (clearance - C) / 0.25 where the last stretch ends; a frame before, as recorded, it is 5 mm more.
  const double least = clearanceOf(recorded_[0], "torso").track.clearance.back() - 0.05;
  ASSERT_GT(least, 0.02);
  const double share = least / 0.25 / 0.5;
  EXPECT_LE(proof.scales.back().scale, share + (0.005 + kEngine) / 0.125);
  EXPECT_GT(proof.scales.back().scale, share * std::pow(0.98, proof.iterations - 1) - kEngine / 0.125);
}

TEST_F(SpeedProofTest, IteratesWhenSlowerRobotMeetsPersonElsewhere) {
  // As recorded the robot rests after 1 m and 2 s, long before the person comes; slower it does not.
  make({.robot = 0.5, .person = 0.2, .stops_at = 5.5, .seconds = 6.0}, "t,q0\n0,0\n2,1\n");
  const auto table = speedTable(recorded_, 0.5, SpeedRule::kContact);
  for (const SpeedSegment& s : table) EXPECT_EQ(s.speed_scale, 1.0) << s.t0;
  auto slow = table;
  for (SpeedSegment& s : slow) s.speed_scale = 0.36;
  ProgramReplay r = replay();
  const SpeedProof once = proveSpeeds(slow, recorded_, r, {SpeedRule::kContact, 5.0, 1});
  EXPECT_FALSE(once.proven);
  EXPECT_EQ(once.iterations, 1);
  EXPECT_EQ(once.broken_contacts, 1);
  EXPECT_FALSE(once.stands);
  EXPECT_EQ(once.scales.front().scale, 0.36);
  const SpeedProof proof = proveSpeeds(slow, recorded_, r, {SpeedRule::kContact, 5.0, 10});
  EXPECT_TRUE(proof.proven);
  EXPECT_GT(proof.iterations, 1);
  EXPECT_EQ(proof.broken_contacts, 0);
  EXPECT_EQ(proof.scales.front().scale, 0.36) << "only what was broken is slower";
  EXPECT_LT(proof.scales[3].scale, 0.36);
}

TEST_F(SpeedProofTest, FastPersonLeavesNoSpeed) {
  make({.robot = 0.5, .person = 0.4, .stops_at = 2.75, .seconds = 4.0}, "t,q0\n0,0\n2,1\n");
  auto table = speedTable(recorded_, 0.5, SpeedRule::kContact);
  for (SpeedSegment& s : table) s.speed_scale = std::min(s.speed_scale, 0.72);
  ProgramReplay r = replay();
  const SpeedProof proof = proveSpeeds(table, recorded_, r, {SpeedRule::kContact, 5.0, 10});
  EXPECT_FALSE(proof.proven);
  ASSERT_TRUE(proof.stands);
  EXPECT_EQ(proof.stands->kind, SpeedLimit::kContact);
  EXPECT_EQ(proof.stands->part, "torso");
  EXPECT_GE(proof.iterations, 1);
}

TEST_F(SpeedProofTest, RejectsForcedStandstillBeforeReplay) {
  options_.pass.separation = {};
  make({.robot = 0.5, .seconds = 4.2});
  const SpeedProof proof = prove(SpeedRule::kBoth);
  EXPECT_FALSE(proof.proven);
  EXPECT_EQ(proof.iterations, 0);
  EXPECT_FALSE(proof.pace);
  ASSERT_TRUE(proof.stands);
  EXPECT_EQ(proof.stands->kind, SpeedLimit::kSeparation);
  EXPECT_TRUE(names_.empty());
}

TEST_F(SpeedProofTest, CoversTimeBeforeRecording) {
  // The program begins 3 s before the recording of 4 s.
  make({.robot = 0.2, .seconds = 4.0}, "t,q0\n-3,0\n3,0.6\n");
  const SpeedProof proof = prove(SpeedRule::kContact);
  EXPECT_TRUE(proof.proven);
  EXPECT_EQ(names_, (std::vector<std::string>{"slide, round 0", "slide"}));
}

TEST_F(SpeedProofTest, RejectsProgramWithoutMotion) {
  make({.robot = 0.2, .seconds = 1.0});
  folder_.write("go.csv", "t,q0\n0,0\n");
  EXPECT_THROW(programMotions(scene_file::loadScene(items_[0].scene)), UsageError);
}

TEST_F(SpeedProofTest, TradeOffMatchesTheoryAtEachScale) {
  const double speed = 0.8, reaction = options_.pass.braking.reaction_time,
               deceleration = options_.pass.braking.deceleration, frame = 0.01;
  make({.robot = speed, .seconds = 4.0});
  ProgramReplay r = replay();
  const std::vector<TradePoint> curve = tradeCurve({0.5, 0.75, 1.0}, r, options_);
  ASSERT_EQ(curve.size(), 3u);
  for (const TradePoint& p : curve) {
    const double v = p.speed_scale * speed, needed = v * reaction + 0.5 * v * v / deceleration;
    EXPECT_DOUBLE_EQ(p.cycle_time, 4.0 / p.speed_scale);
    // The way within a frame, and whole millimetres.
    EXPECT_GT(p.margin, needed - kEngine) << p.speed_scale;
    EXPECT_LT(p.margin, needed + v * frame + 1e-3 + kEngine) << p.speed_scale;
    EXPECT_GT(p.stopped_share, 0.0);
    EXPECT_EQ(p.failed, 0u);
  }
  EXPECT_LT(curve[0].margin, curve[2].margin);
}

}  // namespace speeds_test
}  // namespace abstand::tune
