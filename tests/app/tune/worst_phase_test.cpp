#include "app/tune/worst_phase.hpp"

#include <gtest/gtest.h>

#include "app/tune/body_path.hpp"
#include "core/query/pair_query.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::tune {
namespace worst_phase_test {

// m: the search's own tolerance, and the engine's near contact.
constexpr double kTolerance = 1e-3, kEngine = 3e-4;

WorstPhase of(const std::vector<WorstPhase>& all, const std::string& part) {
  for (const WorstPhase& w : all)
    if (w.part == "person/" + part) return w;
  throw std::runtime_error(part);
}

TEST(WorstPhase, IsMinimumOverAllTimePairs) {
  // The robot comes 1.2 m, the person 0.9 m, both at their own time: together they leave 0.3 m less the
  // bodies.
  const testing::ScratchFolder folder;
  const auto session =
      testing::openSlide(folder, {.robot = 0.3, .person = 0.9, .stops_at = 1.0, .seconds = 4.0});
  session->step(4.0);
  const scene::Object* torso = session->scene().find("person/torso");
  ASSERT_TRUE(torso);
  const std::vector<WorstPhase> all = worstPhases(*session, {});
  ASSERT_EQ(all.size(), humanmodel::kBodyPartCount);
  // By brute force over frames of both: the person rests at its nearest from 1 s on, the robot in its last
  // frame.
  double least = kInfinity;
  for (const double t : session->frameTimes()) {
    session->step(t);
    for (const scene::Pair& pair : session->scene().pairs())
      if (session->scene().object(pair.a).spec.name == "person/torso" ||
          session->scene().object(pair.b).spec.name == "person/torso")
        least = std::min(least, pair.result.distance - pair.result.bound);
  }
  const WorstPhase w = of(all, "torso");
  EXPECT_LE(w.lower, least + kEngine);
  EXPECT_GT(w.lower, least - kTolerance - kEngine);
  EXPECT_NEAR(w.t_robot, 4.0, 0.02);
  EXPECT_GE(w.t_person, 1.0 - 0.02);
  EXPECT_EQ(w.link, "ball");
  EXPECT_GE(w.phase, 0.0);
  EXPECT_LT(w.phase, 4.0);
}

TEST(WorstPhase, IsNearerThanSynchronousRun) {
  // In step the person is gone before the robot comes; at another phase they touch.
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, {.robot = 0.55, .person = -0.6, .seconds = 4.0});
  double in_step = kInfinity;
  for (const double t : session->frameTimes()) {
    session->step(t);
    for (const scene::Pair& pair : session->scene().pairs())
      in_step = std::min(in_step, pair.result.distance);
  }
  const WorstPhase w = of(worstPhases(*session, {}), "torso");
  EXPECT_GT(in_step, 0.5);
  EXPECT_LT(w.lower, in_step - 0.5);
  // With the person where it begins and the robot at its end: 2.4 - 2.2 m less the bodies.
  EXPECT_NEAR(w.t_person, 0.0, 0.02);
  EXPECT_NEAR(w.t_robot, 4.0, 0.02);
}

TEST(WorstPhase, MatchesBruteForce) {
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(
      folder, {.robot = 0.2, .person = 0.3, .stops_at = 1.5, .rate = 20.0, .seconds = 2.0});
  const std::vector<WorstPhase> all = worstPhases(*session, {.rate = 20.0});
  // Poses of both, apart from each other.
  const std::vector<double> times = session->frameTimes();
  struct Poses {
    Transform ball;
    std::vector<Transform> parts;
  };
  std::vector<Poses> poses;
  const scene::Scene& scene = session->scene();
  for (const double t : times) {
    session->step(t);
    Poses p{scene.find("ball")->X_WB, {}};
    for (const WorstPhase& w : all) p.parts.push_back(scene.find(w.part)->X_WB);
    poses.push_back(std::move(p));
  }
  kernels::PairScratch scratch;
  for (std::size_t k = 0; k < all.size(); ++k) {
    double least = kInfinity;
    for (const Poses& person : poses)
      for (const Poses& robot : poses) {
        query::PairResult r;
        query::queryPair({*scene.find(all[k].part)->spec.structure, person.parts[k]},
                         {*scene.find("ball")->spec.structure, robot.ball}, {}, scratch, r);
        least = std::min(least, r.distance - r.bound);
      }
    EXPECT_LE(all[k].lower, least + kEngine) << all[k].part;
    // Far away the engine's own distances are within 1 %.
    EXPECT_GT(all[k].lower, least - kTolerance - kEngine - 0.01 * std::max(0.0, least - 0.1)) << all[k].part;
  }
}

TEST(BodyPath, ReachBoundsEveryPoint) {
  BodyPath path({Vector3d(0.1, 0, 0), 0.3});
  const auto pose = [](double t) {
    Transform X = Transform::Identity();
    X.linear() = Eigen::AngleAxisd(std::sin(3.0 * t), Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    X.translation() = Vector3d(std::cos(2.0 * t), 0.3 * t, std::sin(5.0 * t));
    return X;
  };
  for (int i = 0; i <= 40; ++i) path.add(0.05 * i, pose(0.05 * i));
  for (const auto& [t0, t1] : {std::pair{0.0, 2.0}, {0.3, 0.34}, {0.71, 1.3}, {1.0, 1.05}}) {
    const double reach = path.reach(t0, t1);
    const Transform middle = path.at(0.5 * (t0 + t1));
    double farthest = 0.0;
    for (int i = 0; i <= 200; ++i) {
      const Transform X = path.at(t0 + (t1 - t0) * i / 200.0);
      for (const Vector3d& d : {Vector3d::UnitX().eval(), Vector3d::UnitY().eval(), Vector3d::UnitZ().eval()})
        for (const double sign : {-0.3, 0.3}) {
          const Vector3d p = Vector3d(0.1, 0, 0) + sign * d;
          farthest = std::max(farthest, (X * p - middle * p).norm());
        }
    }
    EXPECT_LE(farthest, reach * (1.0 + 1e-12)) << t0;
  }
}

}  // namespace worst_phase_test
}  // namespace abstand::tune
