// The law `braking`: when it asks for a stop is known in closed form on a slide, and no admissible person is
// hit.
#include "app/session/braking_watch.hpp"

#include <gtest/gtest.h>

#include <random>

#include "app/loop/closed_loop.hpp"
#include "core/base/error.hpp"
#include "tests/app/loop/slide_scene.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::session {
namespace braking_watch_test {

constexpr double kRadius = 0.05;  // of both balls of the slide scene, m

/// A slide whose thing is taken for a part of a person.
struct Watched {
  explicit Watched(const control::BrakingLawOptions& options)
      : slide("{}"),
        scene(slide.session->scene()),
        driver(*slide.session->mechanisms()[0]),
        pairs(driver, scene, people(), control::ReactionDescription{}),
        watch(driver, scene, pairs.own(), options) {}

  std::vector<bool> people() const {
    std::vector<bool> people(scene.objectCount());
    ObjectId thing(0);
    scene.find("thing", &thing);
    people[thing.index()] = true;
    return people;
  }
  /// Ball at 0 with the velocity `v`, thing `gap` away from it with the velocity `u` towards it.
  std::optional<safety::StopCause> check(double gap, double v, double u = 0.0) {
    t += 1.0;
    const double q = 0.0;
    driver.moveTo({&q, 1}, t, scene);
    ObjectId thing(0);
    scene.find("thing", &thing);
    Transform X = Transform::Identity();
    for (const double dt : {0.0, 1e-3}) {
      X.translation() = Vector3d(gap + 2 * kRadius + u * (1e-3 - dt), 0, 0);
      scene.setPose(thing, X, t + dt);
    }
    scene.step();
    return watch.check(scene, {&q, 1}, {&v, 1});
  }

  testing::SlideScene slide;
  scene::Scene& scene;
  MechanismDriver& driver;
  RobotPairs pairs;
  BrakingWatch watch;
  double t{0.0};
};

/// m, that ball and person come nearer to each other until the ball stands.
double closedForm(const control::BrakingLawOptions& o, double v, double person) {
  const double a = o.path.deceleration[0], tr = o.path.reaction_time;
  return v * tr + 0.5 * v * v / a + person * (tr + v / a);
}

TEST(BrakingWatch, RequestsStopAtClosedFormDistance) {
  // Both come straight at each other, so the smallest distance is that at the end. 24 samples leave 3 mm at
  // most on ways of half a metre.
  constexpr double kSampling = 3e-3;
  for (const double deceleration : {1.0, 5.0})
    for (const double v : {0.1, 0.4, 1.0})
      for (const double person : {0.0, 1.6}) {
        control::BrakingLawOptions o;
        o.path.deceleration = {deceleration};
        o.path.reaction_time = 0.05;
        o.person_speed = person;
        o.distance = 0.02;
        Watched w(o);
        const double needed = o.distance + closedForm(o, v, person);
        EXPECT_FALSE(w.check(needed + kSampling, v)) << v << " m/s, person " << person;
        const auto cause = w.check(needed - 1e-4, v);
        ASSERT_TRUE(cause) << v << " m/s, person " << person;
        EXPECT_EQ(cause->reason, safety::StopReason::kBraking);
        EXPECT_EQ(cause->limit, o.distance);
        EXPECT_LT(cause->value, o.distance);
      }
}

TEST(BrakingWatch, DoesNotStopStandingOrRecedingRobot) {
  control::BrakingLawOptions o;
  Watched w(o);
  EXPECT_FALSE(w.check(0.001, 0.0)) << "a standing robot hits nobody";
  EXPECT_TRUE(w.check(0.001, 0.1));
  o.person_speed = 0.0;
  Watched alone(o);
  EXPECT_FALSE(alone.check(0.01, -1.0)) << "it goes away from a person who stands";
  EXPECT_TRUE(alone.check(0.01, 1.0));
}

TEST(BrakingWatch, UsesObservedPersonSpeedIfFaster) {
  control::BrakingLawOptions o;
  o.path.deceleration = {2.0};
  o.path.reaction_time = 0.0;
  o.person_speed = 1.0;
  Watched w(o);
  const double v = 0.5, gap = closedForm(o, v, 1.0) + 0.05;
  EXPECT_FALSE(w.check(gap, v, 0.9));
  EXPECT_TRUE(w.check(gap, v, 3.0)) << "0.25 s at 3 m/s are 75 cm";
}

TEST(BrakingWatch, UnknownJointsRequestStop) {
  Watched w(control::BrakingLawOptions{});
  const auto cause = w.check(0.3, kNaN);
  ASSERT_TRUE(cause);
  EXPECT_EQ(cause->value, -kInfinity);
}

TEST(BrakingWatch, WithoutStopNoAdmissiblePersonIsHit) {
  // Any person within the bounds, any phase: 200 random motions for each of 200 random beginnings.
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> one(0.0, 1.0);
  control::BrakingLawOptions o;
  o.path.deceleration = {3.0};
  o.person_speed = 2.0;
  o.person_acceleration = 30.0;
  Watched w(o);
  int free = 0;
  for (int k = 0; k < 200; ++k) {
    const double gap = 0.6 * one(random), v = 1.2 * one(random), u = 4.0 * one(random) - 2.0;
    if (w.check(gap, v, u)) continue;
    ++free;
    const double tr = o.path.reaction_time, stop = tr + v / 3.0;
    for (int trial = 0; trial < 200; ++trial) {
      double x = gap, speed = u;  // towards the ball, on the line: the worst way
      const double push = 30.0 * (2.0 * one(random) - 0.4), turns = stop * one(random);
      for (double t = 0.0; t < stop; t += 1e-4) {
        speed = std::clamp(speed + (t < turns ? push : 30.0) * 1e-4, -2.0, 2.0);
        x -= speed * 1e-4;
        const double braking = std::max(0.0, t - tr);
        const double way = v * std::min(t, tr) + v * braking - 1.5 * braking * braking;
        ASSERT_GT(x - way, -1e-3) << "gap " << gap << ", v " << v << ", u " << u << ", at " << t;
      }
    }
  }
  EXPECT_GT(free, 20) << "the law lets the robot move at all";
}

TEST(BrakingWatch, AllocatesNothing) {
  Watched w(control::BrakingLawOptions{});
  w.check(0.1, 0.5);
  const double q = 0.0, v = 0.5;
  testing::NoAlloc guard;
  EXPECT_TRUE(w.watch.check(w.scene, {&q, 1}, {&v, 1}));
  EXPECT_EQ(guard.count(), 0);
}

TEST(BrakingWatch, BrakingRobotStopsBeforePerson) {
  // Position-controlled, so that it stands at once when it is told to.
  const testing::ScratchFolder folder;
  folder.write("slide.mech",
               "units\nlength m\nangle degrees\nend_units\nmapping\ndof 0 1\nend_mapping\nchain\n"
               "frame 1 0 90 d 0\nend_chain\nlimits\nlimit 1 -5 5 10 500\nend_limits\n");
  folder.write("go.csv", "t,q0\n0,0\n2,2\n");
  // The plan ends 0.8 m behind the person.
  scene_file::SceneDescription scene = scene_file::parseScene(R"(abstand: 1
defaults: {voxel: 0.05, point: 0.05, outer_layers: 1}
mechanisms:
  - name: slide
    file: slide.mech
    base: {xyz: [-1.2, 0, 1.2], rpy: [0, 0, 1.5707963267948966]}
    motion: go.csv
    reaction: {admittance: {}, braking: {deceleration: 2, person_speed: 0.5, distance: 0.05}}
    links: [{name: ball, frame: 1, shape: {sphere: {radius: 0.05}}}]
humans: [{name: person, height: 1.75}]
)",
                                                              folder.path() / "scene.yaml");
  SessionOptions options;
  options.threads = 1;
  options.cache = false;
  Session session(std::move(scene), options);
  loop::ClosedLoop loop(session, 0.0);
  const loop::ReactingRobot& robot = *loop.robots()[0];
  double v = 0.0;
  for (int i = 0; i < 2000; ++i) {
    if (robot.stops().moving()) v = robot.qd()[0];
    loop.step();
  }
  const safety::StopLog& log = robot.stops().log();
  ASSERT_EQ(log.count(), 2u) << "one stop, then it waits for somebody";
  EXPECT_EQ(log.entry(0).cause.reason, safety::StopReason::kBraking);
  EXPECT_GT(v, 0.5);
  // It stands at once, so what its brakes and the person would have needed is left; a cycle and the samples
  // take no more than 2 cm of it.
  control::BrakingLawOptions o;
  o.path.deceleration = {2.0};
  EXPECT_NEAR(robot.record().nearest_person.value, 0.05 + closedForm(o, v, 0.5), 0.02);
}

}  // namespace braking_watch_test
}  // namespace abstand::session
