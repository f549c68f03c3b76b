// What the tips say of pairs and bodies, and since when.
#include "ui/model/pair_sentence.hpp"

#include <gtest/gtest.h>

#include "tests/ui/fake_session.hpp"

namespace abstand::ui {
namespace pair_sentence_test {

/// One person and one robot that come together along x.
struct PairSentence : ::testing::Test {
  PairSentence() {
    outline.objects = {{"arm/hand", "arm", false, true}, {"anna/head", "anna", true, true}};
    outline.pairs = {{0, 1}};
    outline.frame_period = 0.01;
    snapshot.objects.resize(2);
    snapshot.pairs.resize(1);
    snapshot.objects[0].velocity.linear = Vector3d(0.5, 0, 0);
    snapshot.objects[1].velocity.linear = Vector3d(-0.02, 3.0, 0);
    snapshot.pairs[0].margin = 0.05;
    at(0.0, 0.2);
  }
  void at(double t, double distance) {
    snapshot.t = t;
    query::PairResult& result = snapshot.pairs[0].result;
    result.distance = distance;
    result.bound = 0.0015;
    result.witness_a = Vector3d(0, 0, 1);
    result.witness_b = Vector3d(distance, 0, 1);
    result.contacts = distance < 0.05 ? 3 : 0;
    result.force_a = Vector3d(distance < 0.05 ? -44.8 : 0.0, 0, 0);
    times.add(outline, snapshot);
  }
  std::string sentence() const { return pairSentence(outline, snapshot, 0, times.of(0)).toStdString(); }

  view::SceneOutline outline;
  view::SceneSnapshot snapshot;
  LevelTimes times;
};

TEST_F(PairSentence, SaysEverythingOfPair) {
  EXPECT_EQ(
      sentence(),
      "arm/hand and anna/head are clear of each other since 0.000 s or earlier: distance 200.0 mm ± 1.5 "
      "mm, margin 50 mm, closing at 0.52 m/s, no force.");
  at(0.01, 0.09);
  EXPECT_EQ(
      sentence(),
      "arm/hand and anna/head are near each other, closer than twice the margin, since 0.010 s: distance "
      "90.0 mm ± 1.5 mm, margin 50 mm, closing at 0.52 m/s, no force.");
  at(0.02, 0.032);
  at(0.03, 0.030);
  EXPECT_EQ(
      sentence(),
      "arm/hand and anna/head are inside the margin since 0.020 s: distance 30.0 mm ± 1.5 mm, margin 50 "
      "mm, closing at 0.52 m/s, virtual (margin) force 44.8 N.");
  at(0.04, 0.0015);
  EXPECT_EQ(sentence(),
            "arm/hand and anna/head touch since 0.040 s: distance 1.5 mm ± 1.5 mm, margin 50 mm, closing at "
            "0.52 m/s, contact force 44.8 N.");
  snapshot.objects[0].velocity.linear = Vector3d(-0.3, 0, 0);
  snapshot.objects[1].pose_uncertainty = 0.02;
  at(0.05, 0.2);
  EXPECT_NE(sentence().find("margin 50 mm and 20 mm for the poses, moving apart at 0.28 m/s, no force."),
            std::string::npos)
      << sentence();
}

TEST(DistanceText, SaysHowWellPosesAreKnown) {
  EXPECT_EQ(distanceText(0.0321, 0.0).toStdString(), "32.1 mm");
  EXPECT_EQ(distanceText(0.331, 0.529).toStdString(), "331 mm ± 529 mm");
  EXPECT_EQ(distanceText(0.331, kInfinity).toStdString(), "331 mm, pose unknown");
}

TEST_F(PairSentence, JumpForgetsSinceWhen) {
  at(0.01, 0.03);
  EXPECT_TRUE(times.of(0).exact);
  at(0.50, 0.03);
  EXPECT_FALSE(times.of(0).exact) << "a seek";
  EXPECT_EQ(times.of(0).t, 0.5);
  at(0.49, 0.03);
  EXPECT_FALSE(times.of(0).exact) << "a step back";
  snapshot.playing = true;
  at(0.80, 0.03);
  EXPECT_EQ(times.of(0).t, 0.49) << "played: the state has not changed";
  at(0.90, 0.2);
  EXPECT_TRUE(times.of(0).exact);
  EXPECT_EQ(times.of(0).t, 0.9);
}

TEST_F(PairSentence, UncheckedAndLostPairsAreNotClear) {
  snapshot.objects[1].pose_state = scene::PoseState::kStale;
  at(0.01, 0.2);
  EXPECT_EQ(sentence().find("The pose of arm/hand or anna/head is lost since 0.010 s: distance"), 0u)
      << sentence();
  EXPECT_NE(bodySentence(outline, snapshot, 1, times).indexOf("stale"), -1);
  snapshot.pairs[0].paused = true;
  at(0.02, 0.2);
  EXPECT_EQ(sentence().find("arm/hand and anna/head are not checked"), 0u) << sentence();
  snapshot.pairs[0] = {};
  snapshot.pairs[0].result.distance = kNaN;
  snapshot.objects[1].pose_state = scene::PoseState::kFresh;
  EXPECT_EQ(sentence().find("Nothing is known of"), 0u) << sentence();
  EXPECT_TRUE(pairSentence(outline, {}, 0, {}).isEmpty()) << "another scene";
}

TEST(BodyStates, TellContactFromMargin) {
  FakeSession session;
  view::SceneSnapshot snapshot;
  std::vector<BodyState> states;
  int touching = 0, inside = 0;
  for (double t = 0.0; t < 6.0; t += 0.1) {
    session.seek(t);
    session.takeSnapshot(snapshot);
    findBodyStates(session.outline(), snapshot, states);
    ASSERT_EQ(states.size(), snapshot.objects.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
      // By brute force.
      bool touches = false, is_inside = false;
      Vector3d contact = Vector3d::Zero(), apart = Vector3d::Zero();
      for (std::size_t p = 0; p < snapshot.pairs.size(); ++p) {
        const auto [a, b] = session.outline().pairs[p];
        if (a != static_cast<int>(i) && b != static_cast<int>(i)) continue;
        const query::PairResult& result = snapshot.pairs[p].result;
        const bool touch = result.distance <= result.bound;
        touches |= touch;
        is_inside |= result.distance - result.bound < snapshot.pairs[p].margin;
        (touch ? contact : apart) += a == static_cast<int>(i) ? result.force_a : Vector3d(-result.force_a);
      }
      EXPECT_EQ(states[i].level == PairLevel::kTouching, touches);
      EXPECT_EQ(states[i].level == PairLevel::kInside, !touches && is_inside);
      EXPECT_NEAR((states[i].contact_force - contact).norm(), 0.0, 1e-9);
      EXPECT_NEAR((states[i].virtual_force - apart).norm(), 0.0, 1e-9);
      EXPECT_EQ(states[i].words(0.0).startsWith(QLatin1String("touching")), touches);
      EXPECT_EQ(states[i].words(0.0).startsWith(QLatin1String("inside margin")), !touches && is_inside);
      touching += touches;
      inside += !touches && is_inside;
    }
  }
  EXPECT_GT(touching, 0);
  EXPECT_GT(inside, 0);
  EXPECT_NE(levelColour(PairLevel::kTouching), levelColour(PairLevel::kInside));
  EXPECT_NE(levelColour(PairLevel::kNear), levelColour(PairLevel::kInside));
}

}  // namespace pair_sentence_test
}  // namespace abstand::ui
