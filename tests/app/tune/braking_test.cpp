// Braking along the recorded path against dense sampling.
#include <gtest/gtest.h>

#include "app/depth/open_session.hpp"
#include "app/run/swept_check.hpp"
#include "app/tune/body_path.hpp"
#include "app/tune/braking_clearance.hpp"
#include "tests/support/paths.hpp"

namespace abstand::tune {
namespace braking_test {

// m: what the engine's warm and cold distances beyond 0.1 m may differ by, of the distance.
constexpr double kFarShare = 0.011;

TEST(BrakingClearance, IsNeverAboveDenseSampling) {
  session::SessionOptions options;
  options.threads = 1;
  options.rest = 0.0;
  const auto session =
      depth::openSession(scene_file::loadScene(testing::projectFile("data/scenes/hug_reach.yaml")), options);
  const BrakingOptions braking{0.1, 1.0};
  MotionWindow window(*session, watchedPairs(*session), braking, {});
  ASSERT_GT(window.pairs().size(), 100u);
  BrakingClearance clearance(*session, window, 0.0);
  run::SweptCheck swept(session->scene());
  const std::vector<double> limits(session->scene().pairs().size(), -kInfinity);
  std::vector<query::PairResult> results(limits.size());
  std::vector<BodyPath> paths;
  for (const scene::Object& o : session->scene().objects())
    paths.emplace_back(o.spec.structure->bounding_sphere);
  kernels::PairScratch scratch;
  std::vector<double> found;
  std::size_t frame = 0, compared = 0, moving = 0;
  for (const double t : session->frameTimes()) {
    session->step(t);
    for (std::size_t i = 0; i < results.size(); ++i) results[i] = session->scene().pairs()[i].result;
    for (std::size_t i = 0; i < paths.size(); ++i) paths[i].add(t, session->scene().objects()[i].X_WB);
    std::vector<double> between;
    for (const auto& b : swept.frame(t, results, limits)) between.push_back(b.lower);
    window.add(t, results, between, swept.motions());
    while (clearance.ofFirst(found)) {
      const double begin = window.frames().front().t;
      // Some pairs of some frames: a query of each sample is slow.
      for (std::size_t p = frame % 7; frame % 29 == 0 && p < found.size(); p += 7) {
        const WatchedPair& pair = window.pairs()[p];
        const auto halt = window.haltOfFirst(pair.robot);
        ASSERT_TRUE(halt);
        if (std::isinf(found[p])) continue;
        ++moving;
        double least = kInfinity;
        for (int k = 0; k <= 40; ++k) {
          const double s = halt->duration() * k / 40.0;
          query::PairResult r;
          query::queryPair(
              {*session->scene().objects()[pair.part].spec.structure, paths[pair.part].at(begin + s)},
              {*session->scene().objects()[pair.link].spec.structure,
               paths[pair.link].at(begin + halt->programTime(s))},
              {}, scratch, r);
          least = std::min(least, r.distance);
        }
        EXPECT_LE(found[p], least * (1.0 + kFarShare) + 1e-4) << begin << " pair " << p;
        ++compared;
      }
      ++frame;
      window.drop();
    }
  }
  EXPECT_GT(compared, 200u);
  EXPECT_GT(moving, 200u);
}

}  // namespace braking_test
}  // namespace abstand::tune
