// Thesis 5.3: three spheres in a box, each pair on a thread of its own. Two meet in the first loop, all three
// in the next.
#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <thread>

#include "app/session/session.hpp"
#include "core/scene/pair_threads.hpp"
#include "tests/support/paths.hpp"

namespace abstand::testing {
namespace spheres_test {

std::unique_ptr<session::Session> openSpheres() {
  session::SessionOptions options;
  options.threads = 1;
  return std::make_unique<session::Session>(scene_file::loadScene(projectFile("data/scenes/spheres.yaml")),
                                            options);
}

TEST(ThesisSpheres, StructuresMatchThesis) {
  const auto session = openSpheres();
  ASSERT_EQ(session->scene().objectCount(), 3u);
  ASSERT_EQ(session->scene().pairs().size(), 3u);
  for (const scene::Object& o : session->scene().objects()) {
    EXPECT_EQ(o.spec.structure->grid.size, Vector3i(61, 61, 61));
    EXPECT_NEAR(static_cast<double>(o.spec.structure->shell.size()), 1066, 120);
  }
}

TEST(ThesisSpheres, TwoCollideInFirstLoopThreeInNext) {
  const auto session = openSpheres();
  // The fast spheres pass the middle at 0.5 s and every second after, the slow one at 1.5 s and every two
  // seconds after: so the meetings in the middle take turns.
  const auto touching = [&](double from, double to) {
    std::set<std::size_t> pairs;
    for (double t = from; t <= to; t += 0.001) {
      session->step(t);
      for (std::size_t i = 0; i < 3; ++i)
        if (session->scene().pairs()[i].result.contacts > 0) pairs.insert(i);
    }
    return pairs.size();
  };
  for (const double loop : {0.0, 2.0, 4.0}) {
    EXPECT_EQ(touching(loop + 0.3, loop + 0.7), 1u) << loop;
    EXPECT_EQ(touching(loop + 0.75, loop + 1.25), 0u) << loop;
    EXPECT_EQ(touching(loop + 1.3, loop + 1.7), 3u) << loop;
  }
}

TEST(ThesisSpheres, ForcesPointAlongLineOfCentres) {
  const auto session = openSpheres();
  int touching = 0;
  for (const double t : session->frameTimes()) {
    session->step(t);
    for (const scene::Pair& p : session->scene().pairs()) {
      if (p.result.contacts < 5) continue;
      ++touching;
      const Vector3d away = session->scene().object(p.a).p_WCom() - session->scene().object(p.b).p_WCom();
      if (away.norm() < 0.02) continue;  // nearly through each other: no direction
      const Vector3d force = p.result.force_a.normalized();
      // A handful of points at 5 mm cannot weigh the direction better than this.
      EXPECT_GT(force.dot(away.normalized()), 0.95) << "t = " << t;
    }
  }
  EXPECT_GT(touching, 10);
}

TEST(ThesisSpheres, ThreeThreadsMatchLockStep) {
  const auto session = openSpheres();
  scene::PairThreads threads(session->scene());
  std::vector<scene::PairThreads::GroupIndex> groups;
  for (std::uint32_t i = 0; i < 3; ++i) {
    groups.push_back(threads.addGroup({PairId(i)}));
    threads.start(groups.back());
  }
  std::vector<query::PairResult> live(3);
  const auto times = session->frameTimes();
  for (std::size_t k = 0; k < times.size(); k += times.size() / 40 + 1) {
    session->step(times[k]);
    threads.publishPoses(session->scene());
    // Until every thread has seen these poses; bounded, so that a mistake fails instead of hanging. Live
    // pairs remember earlier poses, so far away they may be off by a hundredth.
    const auto same = [&] {
      threads.collect(live);
      for (std::size_t i = 0; i < 3; ++i) {
        const query::PairResult& step = session->scene().pairs()[i].result;
        const double allowed = 0.01 * std::abs(step.distance) + 1e-5;
        if (std::abs(live[i].distance - step.distance) > allowed || live[i].force_a != step.force_a)
          return false;
      }
      return true;
    };
    bool agreed = false;
    for (int attempt = 0; attempt < 5000 && !(agreed = same()); ++attempt)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_TRUE(agreed) << "t = " << times[k];
  }
  for (auto g : groups) threads.stop(g);
}

}  // namespace spheres_test
}  // namespace abstand::testing
