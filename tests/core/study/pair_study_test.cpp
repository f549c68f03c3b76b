// Which pairs can collide: arms whose answer is known in closed form.
#include "core/study/pair_study.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"
#include "tests/support/structures.hpp"

namespace abstand::study {
namespace pair_study_test {

constexpr double kRadius = 0.05;
// m; a query walks to the nearest points until they are hardly getting nearer.
constexpr double kWalk = 1e-6;

std::shared_ptr<const structure::HapticStructure> ball(double radius = kRadius) {
  return {&testing::structureOf(geometry::Sphere{radius}, structure::FieldKind::kMixed, 0.02), [](auto*) {}};
}

mechanism::MechanismFrame joint(int parent, const Vector3d& xyz, const Vector3d& axis, double reach) {
  mechanism::MechanismFrame f;
  f.parent = parent;
  f.type = mechanism::JointType::kRevolute;
  f.has_dh = false;
  f.axis = axis;
  f.X_PJ.translation() = xyz;
  f.limits.lower = -reach;
  f.limits.upper = reach;
  return f;
}

/// Revolute joints in a row, 0.4 m apart along x; the frame behind the last one is its tip.
mechanism::Mechanism arm(const std::vector<Vector3d>& axes, double reach) {
  mechanism::Mechanism m;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    m.frames.push_back(joint(static_cast<int>(i) - 1, {i == 0 ? 0.0 : 0.4, 0, 0}, axes[i], reach));
    m.frames.back().dof = m.dof++;
  }
  mechanism::MechanismFrame tip = joint(static_cast<int>(axes.size()) - 1, {0.4, 0, 0}, Vector3d::UnitZ(), 0);
  tip.type = mechanism::JointType::kFixed;
  m.frames.push_back(tip);
  m.prepare();
  return m;
}

const Vector3d kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

StudyOptions options(long samples, int searches) {
  StudyOptions o;
  o.samples = samples;
  o.searches = searches;
  o.threads = 1;
  return o;
}

/// A ball at the foot of a planar arm of two rods and one at its tip: their centres are 0.8 cos(q1 / 2)
/// apart.
struct Elbow {
  explicit Elbow(double reach) : mechanism{arm({kZ, kZ}, reach)} {}
  mechanism::Mechanism mechanism;
  std::vector<StudyMechanism> mechanisms{{&mechanism, Transform::Identity()}};
  std::vector<StudyBody> bodies{{ball(), 0, -1, Transform::Identity()},
                                {ball(), 0, 2, Transform::Identity()}};
};

TEST(PairStudy, SearchFindsMinDistance) {
  const Elbow e(2.0);
  const auto pairs = studyPairs(e.mechanisms, e.bodies, {{0, 1}}, options(50, 4));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].verdict, PairVerdict::kNever);
  EXPECT_EQ(pairs[0].hits, 0);
  EXPECT_EQ(pairs[0].samples, 50);
  EXPECT_NEAR(pairs[0].distance, 0.8 * std::cos(1.0) - 2 * kRadius, kWalk);
  EXPECT_NEAR(std::abs(pairs[0].posture[1]), 2.0, 1e-9);
  EXPECT_EQ(pairs[0].dofs, (std::vector<int>{0, 1}));  // the ball at the foot turns with nothing
}

TEST(PairStudy, ClearanceCountsAsCollision) {
  const Elbow e(2.0);
  auto o = options(50, 4);
  o.clearance = 0.8 * std::cos(1.0) - 2 * kRadius + 0.01;
  const auto pairs = studyPairs(e.mechanisms, e.bodies, {{0, 1}}, o);
  EXPECT_EQ(pairs[0].verdict, PairVerdict::kSometimes);
}

TEST(PairStudy, SamplingStopsOnceCollisionIsFound) {
  const Elbow e(kPi);
  const auto pairs = studyPairs(e.mechanisms, e.bodies, {{0, 1}}, options(100000, 4));
  EXPECT_EQ(pairs[0].verdict, PairVerdict::kSometimes);
  EXPECT_FALSE(pairs[0].by_search);
  EXPECT_GT(pairs[0].hits, 0);
  EXPECT_LT(pairs[0].samples, 2000);
  EXPECT_LT(pairs[0].distance, 0.0);
}

TEST(PairStudy, OverlapInEveryPostureIsAlways) {
  const mechanism::Mechanism m = arm({kZ}, 1.0);
  const std::vector<StudyMechanism> mechanisms{{&m, Transform::Identity()}};
  const std::vector<StudyBody> bodies{{ball(), 0, -1, Transform::Identity()},
                                      {ball(0.03), 0, 0, Transform::Identity()}};
  const auto pairs = studyPairs(mechanisms, bodies, {{0, 1}}, options(100, 4));
  EXPECT_EQ(pairs[0].verdict, PairVerdict::kAlways);
  EXPECT_EQ(pairs[0].hits, 100);
}

TEST(PairStudy, StaticPairNeedsOneBlockOfSamples) {
  const mechanism::Mechanism m = arm({kZ}, 1.0);
  const std::vector<StudyMechanism> mechanisms{{&m, Transform::Identity()}};
  const std::vector<StudyBody> bodies{{ball(), 0, 0, Transform::Identity()},
                                      {ball(), 0, 1, Transform::Identity()}};
  const auto pairs = studyPairs(mechanisms, bodies, {{0, 1}}, options(5000, 4));
  EXPECT_EQ(pairs[0].verdict, PairVerdict::kNever);
  EXPECT_TRUE(pairs[0].dofs.empty());
  EXPECT_LE(pairs[0].samples, 256);
  EXPECT_NEAR(pairs[0].distance, 0.4 - 2 * kRadius, kWalk);
}

/// Six joints and a thing in the room that their tip touches in few postures.
struct Needle {
  mechanism::Mechanism mechanism{arm({kZ, kY, kY, kZ, kY, kZ}, 2.0)};
  std::vector<StudyMechanism> mechanisms{{&mechanism, Transform::Identity()}};
  std::vector<StudyBody> bodies{{ball(0.03), 0, 6, Transform::Identity()},
                                {ball(0.03), -1, -1, Transform(Eigen::Translation3d(1.7, 0.4, -1.0))}};
};

TEST(PairStudy, SearchFindsWhatSamplesMiss) {
  const Needle n;
  const auto sampled = studyPairs(n.mechanisms, n.bodies, {{0, 1}}, options(300, 0));
  EXPECT_EQ(sampled[0].verdict, PairVerdict::kNever) << "the seed was chosen so that samples alone are wrong";
  const auto searched = studyPairs(n.mechanisms, n.bodies, {{0, 1}}, options(300, 8));
  EXPECT_EQ(searched[0].verdict, PairVerdict::kSometimes);
  EXPECT_TRUE(searched[0].by_search);
  EXPECT_EQ(searched[0].hits, 0);
  EXPECT_LT(searched[0].distance, sampled[0].distance);
}

TEST(PairStudy, ThreadsDoNotChangeTheResult) {
  const Needle n;
  const Elbow e(2.5);
  const std::vector<StudyMechanism> mechanisms{n.mechanisms[0], e.mechanisms[0]};
  std::vector<StudyBody> bodies = n.bodies;
  for (StudyBody b : e.bodies) {
    b.mechanism = 1;
    bodies.push_back(b);
  }
  for (int frame = 1; frame < 6; ++frame) bodies.push_back({ball(), 0, frame, Transform::Identity()});
  std::vector<std::pair<int, int>> all;
  for (int a = 0; a < static_cast<int>(bodies.size()); ++a)
    for (int b = a + 1; b < static_cast<int>(bodies.size()); ++b) all.emplace_back(a, b);
  const auto one = studyPairs(mechanisms, bodies, all, options(700, 3));
  for (const int threads : {2, 5}) {
    auto o = options(700, 3);
    o.threads = threads;
    const auto many = studyPairs(mechanisms, bodies, all, o);
    ASSERT_EQ(many.size(), one.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(many[i].verdict, one[i].verdict);
      EXPECT_EQ(many[i].distance, one[i].distance);
      EXPECT_EQ(many[i].posture, one[i].posture);
      EXPECT_EQ(many[i].hits, one[i].hits);
    }
  }
}

TEST(PairStudy, RejectsBadOptions) {
  const Elbow e(2.0);
  EXPECT_THROW(studyPairs(e.mechanisms, e.bodies, {}, options(0, 1)), UsageError);
  EXPECT_THROW(studyPairs(e.mechanisms, e.bodies, {}, options(1, -1)), UsageError);
  auto o = options(100, 1);
  o.clearance = kNaN;
  EXPECT_THROW(studyPairs(e.mechanisms, e.bodies, {}, o), UsageError);
}

// What was found before an interrupt is told; what is not known then is neither never nor always.
TEST(PairStudy, InterruptLeavesPairsUndecided) {
  const Elbow e(2.0);
  auto o = options(100, 1);
  o.interrupted = [] { return true; };
  auto pairs = studyPairs(e.mechanisms, e.bodies, {{0, 1}}, o);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].verdict, PairVerdict::kUndecided);
  EXPECT_EQ(pairs[0].samples, 0);
  // After two blocks of 32 samples.
  int asked = 0;
  o.samples = 100000;
  o.interrupted = [&asked] { return ++asked > 2; };
  pairs = studyPairs(e.mechanisms, e.bodies, {{0, 1}}, o);
  EXPECT_EQ(pairs[0].verdict, PairVerdict::kUndecided);
  EXPECT_EQ(pairs[0].samples, 64);
  EXPECT_LT(pairs[0].distance, 0.8);
  // All samples, but not the search.
  asked = 0;
  o.samples = 64;
  pairs = studyPairs(e.mechanisms, e.bodies, {{0, 1}}, o);
  EXPECT_EQ(pairs[0].verdict, PairVerdict::kUndecided);
  // The pair hits sometimes, and that is known for good.
  const Elbow far(kPi);
  asked = 0;
  o.samples = 100000;
  o.clearance = 0.5;
  pairs = studyPairs(far.mechanisms, far.bodies, {{0, 1}}, o);
  EXPECT_EQ(pairs[0].verdict, PairVerdict::kSometimes);
}

}  // namespace pair_study_test
}  // namespace abstand::study
