// Near misses and protective distances against closed forms.
#include <gtest/gtest.h>

#include "app/tune/speed_table.hpp"
#include "core/contact/contact_limits_reader.hpp"
#include "core/contact/predicted_contact.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::tune {
namespace approach_test {

// m and m/s: engine's distances, and speeds in whole steps.
constexpr double kEngine = 3e-4;

std::shared_ptr<const contact::ContactLimits> limits() {
  return std::make_shared<const contact::ContactLimits>(
      contact::loadContactLimits(contact::defaultContactLimits(), humanmodel::partNames()));
}

const PartClearance& partOf(const TunedRecording& tuned, const std::string& name) {
  for (const PartClearance& p : tuned.pass.parts)
    if (p.part == name) return p;
  throw std::runtime_error(name);
}

TEST(ApproachTable, ReportsStopAndHardestContactBefore) {
  // 2.4 m away, the person comes 2.1 m at 0.7 m/s and stands; the robot stands all the time.
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, {.robot = 0.0, .person = 0.7, .stops_at = 3.0});
  TuneOptions options;
  options.pass.contact = limits();
  const TunedRecording tuned = tuneRecording(*session, options, {}, "slide");
  const Approach* torso = nullptr;
  for (const Approach& a : tuned.pass.approaches)
    if (tuned.pass.parts[a.part].part == "torso") {
      EXPECT_FALSE(torso) << "one approach";
      torso = &a;
    }
  ASSERT_TRUE(torso);
  EXPECT_NEAR(torso->t, 3.0, 1e-9);
  EXPECT_EQ(tuned.pass.links[torso->link], "ball");
  const std::vector<double>& c = partOf(tuned, "torso").track.clearance;
  EXPECT_EQ(torso->clearance, *std::min_element(c.begin(), c.end()));
  EXPECT_NEAR(torso->motion.closing(), 0.0, kEngine);
  // Straight on: the nearest points approach with the person's speed.
  EXPECT_NEAR(torso->contact.closing, 0.7, kEngine);
  EXPECT_LT(torso->contact.t, 3.0);
  // The rail has no masses: a wall. The worst region of the torso at that speed.
  const contact::RegionContact expected =
      contact::worstContact(options.pass.contact->regionsOf("torso"), {torso->contact.closing, {kInfinity}});
  EXPECT_EQ(torso->contact.region, expected.region->name);
  EXPECT_DOUBLE_EQ(torso->contact.force, expected.contact.force);
  EXPECT_DOUBLE_EQ(torso->contact.share, expected.contact.share);
  EXPECT_GT(torso->contact.pressure, 0.0);
}

/// The ball on the rail, of 10 kg.
std::unique_ptr<session::Session> openHeavySlide(const testing::ScratchFolder& folder,
                                                 const testing::SlideSpeeds& speeds) {
  const auto scene = testing::writeSlide(folder, speeds);
  folder.write("slide.mech",
               "units\nlength m\nangle degrees\nend_units\nmapping\ndof 0 1\nend_mapping\nchain\n"
               "frame 1 0 90 d 0\nend_chain\ninertia\nbody 1 10 0 0 0 0.01 0.01 0.01 0 0 0\nend_inertia\n");
  session::SessionOptions options;
  options.threads = 1;
  options.cache = false;
  options.rest = 0.0;
  return depth::openSession(scene_file::loadScene(scene), options);
}

TEST(ApproachTable, ClampedPartUsesQuasiStaticLimits) {
  const testing::ScratchFolder folder;
  const auto session = openHeavySlide(folder, {.robot = 0.0, .person = 0.7, .stops_at = 3.0});
  TuneOptions options;
  options.pass.contact = limits();
  options.pass.near = 0.6;
  options.pass.clamped = {"torso"};
  const TunedRecording tuned = tuneRecording(*session, options, {}, "slide");
  EXPECT_EQ(tuned.clamped, options.pass.clamped);
  int clamped = 0, free = 0;
  for (const Approach& a : tuned.pass.approaches) {
    const std::string& part = tuned.pass.parts[a.part].part;
    if (a.contact.region.empty() || part == "head") continue;
    const bool is_torso = part == "torso";
    ++(is_torso ? clamped : free);
    const auto kind = is_torso ? contact::ContactKind::kQuasiStatic : contact::ContactKind::kTransient;
    EXPECT_EQ(a.contact.kind, kind) << part;
    const contact::RegionLimits& region = *options.pass.contact->region(a.contact.region);
    const double allowed = region.force.value * (is_torso ? 1.0 : region.transient.value);
    EXPECT_NEAR(a.contact.share, a.contact.force / allowed, 1e-9 * a.contact.share) << part;
    if (!is_torso) continue;
    // Straight on: the whole mass, and none of the person recoils.
    const contact::RegionContact expected =
        contact::worstContact(options.pass.contact->regionsOf(part), {a.contact.closing, {10.0}, kind});
    EXPECT_EQ(region.name, expected.region->name);
    EXPECT_NEAR(a.contact.force, expected.contact.force, kEngine * a.contact.force);
    EXPECT_NEAR(a.contact.force, a.contact.closing * std::sqrt(10.0 * region.spring.value),
                kEngine * a.contact.force);
  }
  EXPECT_EQ(clamped, 1);
  EXPECT_GT(free, 0);
}

TEST(ApproachTable, UsesClampedPartsOfScene) {
  const testing::ScratchFolder folder;
  const auto slide = testing::writeSlide(folder, {.robot = 0.5, .seconds = 1.0});
  scene_file::SceneDescription scene = scene_file::loadScene(slide);
  scene.humans.front().clamped = {humanmodel::BodyPart::kHandLeft};
  session::SessionOptions session_options;
  session_options.cache = false;
  const auto session = depth::openSession(std::move(scene), session_options);
  TuneOptions options;
  options.pass.clamped = {"torso"};
  EXPECT_EQ(tuneRecording(*session, options, {}, "slide").clamped,
            (std::vector<std::string>{"hand_left", "torso"}));
}

TEST(ApproachTable, HeadContactIsExcluded) {
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, {.robot = 0.0, .person = 0.7, .stops_at = 3.0});
  TuneOptions options;
  options.pass.contact = limits();
  options.pass.near = 1.0;
  const TunedRecording tuned = tuneRecording(*session, options, {}, "slide");
  int heads = 0;
  for (const Approach& a : tuned.pass.approaches)
    if (tuned.pass.parts[a.part].part == "head") {
      ++heads;
      EXPECT_TRUE(a.contact.excluded);
      EXPECT_EQ(a.contact.share, kInfinity);
    }
  EXPECT_EQ(heads, 1);
}

TEST(SpeedSeparation, MatchesIsoFormulaAtEveryFrame) {
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, {.robot = 0.5, .seconds = 4.0});
  TuneOptions options;
  safety::SeparationOptions& o = options.pass.separation;
  o.reaction_time = 0.1, o.stopping_time = 0.3, o.intrusion = 0.2, o.person_error = 0.1, o.robot_error = 0.05;
  const TunedRecording tuned = tuneRecording(*session, options, {}, "slide");
  const PartClearance& torso = partOf(tuned, "torso");
  std::size_t compared = 0;
  for (std::size_t i = 0; i + 1 < torso.track.frames(); ++i) {
    const double c = torso.track.clearance[i];
    if (c < 0.05) break;
    // Term by term: v_h (T_r + T_s) + v_r T_r + v_r T_s / 2 + C + Z_d + Z_r; v_h is 2.0 m/s nearer than 0.5
    // m.
    const double person = c < 0.5 ? 2.0 : 1.6;
    const double needed = person * 0.4 + 0.5 * 0.1 + 0.5 * 0.5 * 0.3 + 0.35;
    EXPECT_NEAR(torso.separation.missing[i], needed - c, kEngine) << i;
    const double permitted = (c - person * 0.4 - 0.35) / (0.1 + 0.15);
    EXPECT_NEAR(torso.separation.speed_scale[i], std::clamp(permitted / 0.5, 0.0, 1.0),
                2.0 * kEngine / 0.25 / 0.5)
        << i;
    ++compared;
  }
  EXPECT_GT(compared, 300u);
  ASSERT_TRUE(torso.separation.worst);
  EXPECT_NEAR(torso.separation.worst->robot_speed, 0.5, kEngine);
  EXPECT_EQ(torso.separation.worst->permitted_speed, 0.0);
}

TEST(SpeedTable, UsesMinimumOfEachSegment) {
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, {.robot = 0.5, .seconds = 4.0});
  const TunedRecording tuned = tuneRecording(*session, {}, {}, "slide");
  const std::vector<SpeedSegment> segments = speedTable({tuned}, 0.5);
  ASSERT_EQ(segments.size(), 8u);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    double slowest = 1.0;
    for (const PartClearance& p : tuned.pass.parts)
      for (std::size_t i = 0; i < p.track.frames(); ++i)
        if (p.track.t[i] >= segments[s].t0 - 1e-9 && p.track.t[i] < segments[s].t1 - 1e-9)
          slowest = std::min(slowest, p.separation.speed_scale[i]);
    EXPECT_EQ(segments[s].speed_scale, slowest) << s;
    EXPECT_EQ(segments[s].limited_by.has_value(), slowest < 1.0);
  }
  // Far away at first, at the person in the end.
  EXPECT_EQ(segments.front().speed_scale, 1.0);
  EXPECT_EQ(segments.back().speed_scale, 0.0);
  EXPECT_EQ(cycleTime(segments), kInfinity);
  EXPECT_NEAR(cycleTime({{0.0, 1.0, 0.5, {}, 0.5, 1.0}, {1.0, 2.0, 1.0, {}, 1.0, 1.0}}), 3.0, 1e-12);
}

TEST(SpeedSeparation, StandingOrRecedingRobotIsNotLimited) {
  const testing::ScratchFolder folder;
  for (const double speed : {0.0, -0.3}) {
    const auto session = testing::openSlide(folder, {.robot = speed, .person = 0.5});
    const TunedRecording tuned = tuneRecording(*session, {}, {}, "slide");
    for (const PartClearance& p : tuned.pass.parts) {
      EXPECT_FALSE(p.separation.worst) << p.part;
      EXPECT_EQ(*std::min_element(p.separation.speed_scale.begin(), p.separation.speed_scale.end()), 1.0);
    }
  }
}

}  // namespace approach_test
}  // namespace abstand::tune
