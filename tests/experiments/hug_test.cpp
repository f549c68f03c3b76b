// Thesis 5.4: HUG alone with a safety margin of 7.5 cm: 79 pairs, and joint torques that move the arms apart.
#include <gtest/gtest.h>

#include "app/session/session.hpp"
#include "tests/support/paths.hpp"

namespace abstand::testing {
namespace hug_test {

std::unique_ptr<session::Session> openHug() {
  session::SessionOptions options;
  options.threads = 1;
  return std::make_unique<session::Session>(scene_file::loadScene(projectFile("data/scenes/hug_alone.yaml")),
                                            options);
}

std::vector<double> joints(const session::Session& session) {
  std::vector<double> q;
  for (const auto& m : session.mechanisms()) q.insert(q.end(), m->q().begin(), m->q().end());
  return q;
}

TEST(ThesisHug, FourteenBodiesGiveSeventyNinePairs) {
  const auto session = openHug();
  EXPECT_EQ(session->scene().objectCount(), 14u);
  EXPECT_EQ(session->scene().pairs().size(), 79u);  // not 66: the thesis subtracts the neighbours twice
  for (const scene::Pair& p : session->scene().pairs()) EXPECT_DOUBLE_EQ(p.options.margin, 0.075);
}

TEST(ThesisHug, DemoLinksAreApartWithoutMargin) {
  const auto session = openHug();
  const auto times = session->frameTimes();
  for (std::size_t i = 0; i < times.size(); i += 25) {
    session->step(times[i]);
    for (const scene::Pair& p : session->scene().pairs())
      EXPECT_GT(p.result.distance, 0.0) << session->scene().object(p.a).spec.name << " "
                                        << session->scene().object(p.b).spec.name << " t = " << times[i];
  }
}

TEST(ThesisHug, TorquesDoWorkAgainstApproach) {
  // The contact forces do work on the arms: positive exactly while the margins part, negative while they
  // close.
  const auto session = openHug();
  const auto times = session->frameTimes();
  constexpr double kClear = 2e-4;  // m per step of ten frames; slower changes are left out
  int closing = 0, parting = 0;
  session->step(times.front());
  auto q_before = joints(*session);
  double depth_before = 0.0;
  for (std::size_t i = 10; i < times.size(); i += 10) {
    session->step(times[i]);
    const auto q = joints(*session);
    double power = 0.0, depth = 0.0;
    for (std::size_t j = 0; j < q.size(); ++j) power += session->jointEfforts()[j] * (q[j] - q_before[j]);
    int contacts = 0;
    for (const scene::Pair& p : session->scene().pairs()) {
      depth += p.result.depth;
      contacts += p.result.contacts > 0;
    }
    if (contacts == 1 && depth_before > 0.0 && std::abs(depth - depth_before) > kClear) {
      if (depth > depth_before) {
        ++closing;
        EXPECT_LT(power, 0.0) << "t = " << times[i];
      } else {
        ++parting;
        EXPECT_GT(power, 0.0) << "t = " << times[i];
      }
    }
    q_before = q;
    depth_before = depth;
  }
  EXPECT_GE(closing, 3);
  EXPECT_GE(parting, 3);
}

}  // namespace hug_test
}  // namespace abstand::testing
