// Whole sessions: the same bits for any number of threads, third law over a run, live play.
#include "app/session/session.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "app/loop/live_session.hpp"
#include "app/run/run_scene.hpp"
#include "core/base/state_hash.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/paths.hpp"

namespace abstand::testing {
namespace session_test {

std::unique_ptr<session::Session> openReach(int threads = 1) {
  session::SessionOptions options;
  options.threads = threads;
  return std::make_unique<session::Session>(scene_file::loadScene(projectFile("data/scenes/hug_reach.yaml")),
                                            options);
}

void add(StateHash& hash, const Vector3d& v) {
  for (int i = 0; i < 3; ++i) hash.add(v[i]);
}

std::uint64_t runHash(session::Session& session) {
  session.scene().startCold();
  StateHash hash;
  for (int i = 0; i < 40; ++i) {
    session.step(0.05 * i);
    for (const scene::Pair& p : session.scene().pairs()) {
      hash.add(p.result.distance);
      hash.add(p.result.bound);
      add(hash, p.result.force_a);
      add(hash, p.result.torque_b);
      add(hash, p.result.witness_a);
    }
    for (const scene::Object& o : session.scene().objects()) add(hash, o.contact.torque);
    for (double e : session.jointEfforts()) hash.add(e);
  }
  return hash.value();
}

TEST(Session, IsBitIdenticalForAnyThreadCount) {
  auto session = openReach();
  const auto expected = runHash(*session);
  for (const int threads : {2, 3, 7, 16}) {
    session = openReach(threads);
    EXPECT_EQ(runHash(*session), expected) << threads << " threads";
  }
}

TEST(Session, CycleAllocatesNothing) {
  auto session = openReach();
  session->step(0.0);
  session->step(0.01);
  const NoAlloc guard;
  for (int i = 2; i < 60; ++i) session->step(0.05 * i);
  EXPECT_EQ(guard.count(), 0);
}

TEST(Session, ReportsPlannedStructuresByName) {
  session::SessionOptions options;
  options.threads = 1;
  std::size_t planned = 0;
  std::vector<std::string> order;
  options.planned = [&](std::size_t structures) {
    EXPECT_TRUE(order.empty());
    planned = structures;
  };
  double before = 0.0;
  options.monitor.progress = [&](double fraction, std::string_view name) {
    EXPECT_GE(fraction, before);
    before = fraction;
    if (std::find(order.begin(), order.end(), name) == order.end()) order.emplace_back(name);
  };
  const session::Session session(scene_file::loadScene(projectFile("data/scenes/rods.yaml")), options);
  EXPECT_EQ(planned, 1u);  // two rods of the same shape
  EXPECT_EQ(session.structures(), planned);
  EXPECT_EQ(order.size(), planned);
  EXPECT_EQ(before, 1.0);
  EXPECT_EQ(session.cachedStructures(), 0u);
}

TEST(Session, ForcesOfAllObjectsCancel) {
  auto session = openReach();
  for (std::uint32_t i = 0; i < session->scene().objectCount(); ++i)
    session->scene().setMargin(ObjectId(i), 0.05);
  double largest = 0.0;
  for (int i = 0; i < 20; ++i) {
    session->step(0.1 * i);
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    double force_scale = 1e-30, moment_scale = 1e-30;
    for (const scene::Object& o : session->scene().objects()) {
      force += o.contact.force;
      moment += o.contact.torque + o.p_WCom().cross(o.contact.force);
      force_scale += o.contact.force.norm();
      moment_scale += o.contact.torque.norm() + o.p_WCom().norm() * o.contact.force.norm();
    }
    largest = std::max(largest, force_scale);
    EXPECT_LE(force.norm(), 1e-9 * force_scale);
    EXPECT_LE(moment.norm(), 1e-9 * moment_scale);
  }
  EXPECT_GT(largest, 1.0);  // something did touch
}

TEST(Session, SecondRunGivesSameResults) {
  auto session = openReach();
  const auto first = runHash(*session);
  EXPECT_EQ(runHash(*session), first);
}

TEST(Session, CullingKeepsBounds) {
  // Certified distances hold for the exact surfaces; reported ones are off them by less than this.
  constexpr double kOnSurface = 1e-5;
  auto exact = openReach();
  std::uint64_t expected = 0;
  for (const int threads : {1, 3}) {
    session::SessionOptions options;
    options.threads = threads;
    options.rest = 0.05;
    options.horizon = 1.0;
    session::Session session(scene_file::loadScene(projectFile("data/scenes/hug_reach.yaml")), options);
    StateHash hash;
    scene::StepCounts sum;
    for (int i = 0; i < 400; ++i) {
      session.step(0.005 * i);
      exact->step(0.005 * i);
      sum.checked += session.scene().counts().checked;
      sum.rested += session.scene().counts().rested;
      sum.beyond += session.scene().counts().beyond;
      for (std::size_t p = 0; p < session.scene().pairs().size(); ++p) {
        const query::PairResult& r = session.scene().pairs()[p].result;
        const query::PairResult& e = exact->scene().pairs()[p].result;
        ASSERT_EQ(r.contacts, e.contacts) << i << " " << p;
        ASSERT_EQ(r.force_a, e.force_a);
        ASSERT_LE(r.distance - r.bound, e.distance + kOnSurface) << i << " " << p;
        ASSERT_LE(e.distance - e.bound, r.distance + kOnSurface) << i << " " << p;
        hash.add(r.distance);
        hash.add(r.bound);
      }
    }
    EXPECT_GT(sum.rested, 0);
    EXPECT_GT(sum.beyond, 0);
    EXPECT_GT(sum.checked, 0);
    if (threads == 1) expected = hash.value();
    EXPECT_EQ(hash.value(), expected);
  }
}

TEST(Session, SpeedsAreFromSceneOrDefaultsForCulling) {
  session::SessionOptions options;
  options.threads = 1;
  const auto scene = scene_file::loadScene(projectFile("data/scenes/hug_reach.yaml"));
  session::Session plain(scene, options);
  for (const scene::Object& o : plain.scene().objects()) EXPECT_EQ(o.max_speed, kInfinity) << o.spec.name;
  options.rest = 0.5;
  scene_file::SceneDescription said = scene;
  said.humans.at(0).parts[humanmodel::BodyPart::kHandLeft].max_speed = 3.5;
  said.mechanisms.at(0).settings.max_speed = 1.25;
  session::Session resting(said, options);
  const std::string person = said.humans[0].name;
  EXPECT_EQ(resting.scene().find(person + "/hand_left")->max_speed, 3.5);
  EXPECT_EQ(resting.scene().find(person + "/hand_right")->max_speed,
            said.humans[0].recording.file.empty() ? 0.0 : session::kHandSpeed);
  for (const auto& link : said.mechanisms[0].links)
    EXPECT_EQ(resting.scene().find(link.name)->max_speed, 1.25) << link.name;
}

TEST(LiveSession, PlaysSeeksAndAppliesMargins) {
  loop::LiveSession live(openReach(), 0.0);
  view::SceneSnapshot snapshot;
  const auto waitFor = [&](auto condition) {
    // Generous: a sanitizer build on a loaded machine is slow, and nothing here is about time.
    for (int i = 0; i < 3000; ++i) {
      live.takeSnapshot(snapshot);
      if (snapshot.step > 0 && condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  };
  EXPECT_TRUE(waitFor([&] { return snapshot.t == 0.0; }));
  live.send(loop::command::Seek{1.0});
  EXPECT_TRUE(waitFor([&] { return snapshot.t == 1.0; }));
  live.send(loop::command::Margin{0, 0.123});
  EXPECT_TRUE(waitFor([&] { return snapshot.objects[0].margin == 0.123; }));
  live.send(loop::command::Step{1});
  EXPECT_TRUE(waitFor([&] { return snapshot.t > 1.0; }));
  EXPECT_NEAR(snapshot.t, 1.0 + live.outline().frame_period, 1e-12);
  live.send(loop::command::Play{true});
  EXPECT_TRUE(waitFor([&] { return snapshot.playing && snapshot.t > 1.05; }));
  live.send(loop::command::Seek{kNaN});
  live.send(loop::command::Margin{-1, 1.0});
  live.send(loop::command::Play{false});
  EXPECT_TRUE(waitFor([&] { return !snapshot.playing; }));
  EXPECT_TRUE(std::isfinite(snapshot.t));
  std::vector<view::PlotSample> samples;
  live.drainPlot(samples);
  EXPECT_GT(samples.size(), 5u);
}

}  // namespace session_test
}  // namespace abstand::testing
