// Distances by class, and contact apart from what is only inside a margin.
#include "core/view/plot_sampler.hpp"

#include <gtest/gtest.h>

#include "tests/core/scene/crowd.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::view {
namespace plot_sampler_test {

constexpr int kBalls = 9;

/// The first third are parts of a person, the second links of a robot, the others things.
SceneOutline outlineOf(const scene::Scene& scene) {
  SceneOutline outline;
  for (std::uint32_t i = 0; i < scene.objectCount(); ++i) {
    const bool person = i < kBalls / 3, robot = !person && i < 2 * kBalls / 3;
    outline.objects.push_back({"ball" + std::to_string(i),
                               person  ? "person"
                               : robot ? "arm"
                                       : "objects",
                               person, true});
  }
  for (std::uint32_t p = 0; p < scene.pairs().size(); ++p)
    outline.pairs.emplace_back(static_cast<int>(scene.pairs()[p].a.index()),
                               static_cast<int>(scene.pairs()[p].b.index()));
  return outline;
}

void expectSame(const PlotSample& x, const PlotSample& y) {
  EXPECT_EQ(x.min_distance, y.min_distance);
  EXPECT_EQ(x.nearest_pair, y.nearest_pair);
  EXPECT_EQ(x.contact_force, y.contact_force);
  EXPECT_EQ(x.virtual_force, y.virtual_force);
  EXPECT_EQ(x.class_distance, y.class_distance);
}

TEST(PairClasses, FollowFromBothSides) {
  const scene::Scene scene = testing::crowd(kBalls);
  const SceneOutline outline = outlineOf(scene);
  EXPECT_EQ(pairClassOf(outline, {0, 3}), PairClass::kPersonRobot);
  EXPECT_EQ(pairClassOf(outline, {3, 0}), PairClass::kPersonRobot);
  EXPECT_EQ(pairClassOf(outline, {0, 8}), PairClass::kPersonThing);
  EXPECT_EQ(pairClassOf(outline, {4, 5}), PairClass::kRobotRobot);
  EXPECT_EQ(pairClassOf(outline, {8, 5}), PairClass::kRobotThing);
  EXPECT_EQ(pairClassOf(outline, {0, 1}), PairClass::kOther);
  EXPECT_EQ(pairClassOf(outline, {7, 8}), PairClass::kOther);
}

TEST(PlotSampler, AgreesWithAllPairsAtAnyStep) {
  scene::Scene scene = testing::crowd(kBalls);
  const SceneOutline outline = outlineOf(scene);
  PlotSampler sampler(outline);
  SceneSnapshot snapshot;
  double contact = 0.0, apart = 0.0;
  for (int frame = 0; frame < 40; ++frame) {
    testing::scatter(scene, frame, 2.0);
    // One pair is paused for two steps.
    const PairId paused(static_cast<std::uint32_t>(frame / 7));
    if (frame % 7 == 3) scene.setPaused(paused, true, 0.01 * frame);
    if (frame % 7 == 5) scene.setPaused(paused, false, 0.01 * frame);
    scene.step();
    if (frame % 5 == 4) continue;  // a step that is left out
    PlotSample sampled, all;
    sampler.fill(scene, sampled);
    capture(scene, snapshot);
    fillSample(outline, snapshot, all);
    expectSame(sampled, all);
    contact = std::max(contact, sampled.contact_force);
    apart = std::max(apart, sampled.virtual_force);
  }
  EXPECT_GT(contact, 0.0);
  EXPECT_GT(apart, 0.0) << "some pair was only inside its margin";
}

TEST(PlotSampler, TellsContactFromMargin) {
  SceneOutline outline;
  outline.objects = {{"p/a", "p", true, true}, {"arm/b", "arm", false, true}};
  outline.pairs = {{0, 1}};
  SceneSnapshot snapshot;
  snapshot.pairs.resize(1);
  query::PairResult& result = snapshot.pairs[0].result;
  result.bound = 1e-3;
  result.contacts = 4;
  result.force_a = Vector3d(0, 0, 5);
  for (const auto& [distance, touches] :
       {std::pair{0.02, false}, {1.001e-3, false}, {1e-3, true}, {-0.01, true}}) {
    result.distance = distance;
    PlotSample sample;
    fillSample(outline, snapshot, sample);
    EXPECT_EQ(sample.contact_force, touches ? 5.0 : 0.0) << distance;
    EXPECT_EQ(sample.virtual_force, touches ? 0.0 : 5.0) << distance;
    EXPECT_EQ(sample.class_distance[0], distance);
    EXPECT_EQ(sample.class_distance[1], kInfinity);
  }
  snapshot.pairs[0].paused = true;
  PlotSample sample;
  fillSample(outline, snapshot, sample);
  EXPECT_EQ(sample.contact_force, 0.0) << "not checked";
  EXPECT_EQ(sample.nearest_pair, -1);
  EXPECT_EQ(sample.class_distance[0], kInfinity);
}

TEST(PlotSampler, DoesNotAllocate) {
  scene::Scene scene = testing::crowd(kBalls);
  PlotSampler sampler(outlineOf(scene));
  PlotSample sample;
  testing::scatter(scene, 0, 2.0);
  scene.step();
  sampler.fill(scene, sample);
  testing::scatter(scene, 1, 2.0);
  scene.step();
  const testing::NoAlloc allocations;
  sampler.fill(scene, sample);
  EXPECT_EQ(allocations.count(), 0);
}

}  // namespace plot_sampler_test
}  // namespace abstand::view
