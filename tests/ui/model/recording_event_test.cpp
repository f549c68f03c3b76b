// Touches, stops and lost tracking among the events of a recording.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ui/fake_analysis.hpp"
#include "ui/model/event_text.hpp"
#include "ui/model/recording_review.hpp"

namespace abstand::ui {
namespace recording_event_test {

constexpr std::size_t kTouching = 3, kLost = 5, kLostToo = 6;  // parts
constexpr double kFrame = 0.02;                                // s

/// One part comes within 5 mm (the uncertainty of FakeAnalysis) from 2 s to 3 s, two are not seen from 6 s
/// on.
struct RecordingEvents : ::testing::Test {
  RecordingEvents() {
    review.open(&analysis, session.outline(), std::vector<double>(session.outline().objects.size(), 0.0));
    analysis.run(100);  // several chunks, and news in between
    review.pull();
    analysis.runAll();
    review.pull();
  }
  std::vector<RecordingEvent> of(EventKind kind) const {
    std::vector<RecordingEvent> found;
    std::copy_if(review.events().begin(), review.events().end(), std::back_inserter(found),
                 [&](const RecordingEvent& event) { return event.kind == kind; });
    return found;
  }

  FakeSession session;
  FakeAnalysis analysis{session.outline(), [this](std::size_t part, std::size_t frame) {
                          const double t = analysis.t(frame);
                          if (part == kTouching) return t > 1.99 && t < 2.99 ? -0.006 : 0.5;
                          if ((part == kLost || part == kLostToo) && t > 5.99) return kNaN;
                          return 0.5;
                        }};
  RecordingReview review;
};

TEST_F(RecordingEvents, TouchIsWhatIsWithinTheBoundAtThePoses) {
  const auto touches = of(EventKind::kContact);
  ASSERT_EQ(touches.size(), 1u);
  EXPECT_EQ(touches[0].part, static_cast<int>(kTouching));
  EXPECT_EQ(touches[0].link, 0);
  EXPECT_NEAR(touches[0].t0, 2.0, 1e-9);
  EXPECT_NEAR(touches[0].t1, 3.0, kFrame);
  EXPECT_NEAR(touches[0].min_clearance, -0.006, 1e-6);
  EXPECT_TRUE(eventText(review, touches[0]).contains(QLatin1String("touching")));
}

TEST_F(RecordingEvents, UncertainPoseAloneIsNoTouch) {
  // 4 mm of clearance below 0, 5 mm of which are the poses' uncertainty: the surfaces are 1 mm apart.
  FakeAnalysis apart(session.outline(), [](std::size_t, std::size_t) { return -0.004; });
  apart.runAll();
  RecordingReview other;
  other.open(&apart, session.outline(), std::vector<double>(session.outline().objects.size(), 0.0));
  other.pull();
  EXPECT_FALSE(other.events().empty()) << "inside margins of nothing";
  for (const RecordingEvent& event : other.events()) EXPECT_NE(event.kind, EventKind::kContact);
}

TEST_F(RecordingEvents, PartsLostTogetherAreOneEvent) {
  const auto lost = of(EventKind::kLost);
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost[0].parts, 2u);
  EXPECT_EQ(lost[0].part, static_cast<int>(kLost));
  EXPECT_NEAR(lost[0].t0, 6.0, 1e-9);
  EXPECT_NEAR(lost[0].t1, session.outline().end, 1e-9);
  EXPECT_EQ(subjectText(review, lost[0]).toStdString(), "forearm_right and 1 more");
  EXPECT_TRUE(std::isinf(lost[0].min_clearance));
}

TEST_F(RecordingEvents, MarginsDoNotChangeTouchesAndLosses) {
  const auto touches = of(EventKind::kContact).size(), lost = of(EventKind::kLost).size();
  const auto inside = of(EventKind::kInside).size();
  for (std::size_t i = 0; i < session.outline().objects.size(); ++i)
    review.setMargin(static_cast<int>(i), 0.3);
  review.pull();
  QCoreApplication::processEvents();
  EXPECT_EQ(of(EventKind::kContact).size(), touches);
  EXPECT_EQ(of(EventKind::kLost).size(), lost);
  EXPECT_GT(of(EventKind::kInside).size(), inside);
}

TEST_F(RecordingEvents, StopsAreAddedAndKeysFollowKinds) {
  view::SceneOutline outline = session.outline();
  outline.reacting = {"arm"};
  review.setStops({{{8.0, 8.5}, 0, safety::StopState::kProtectiveStop, {}}}, outline);
  const auto stops = of(EventKind::kStop);
  ASSERT_EQ(stops.size(), 1u);
  EXPECT_EQ(subjectText(review, stops[0]).toStdString(), "arm");
  EXPECT_TRUE(stops[0].story.startsWith(QLatin1String("arm stood from 8.000 s to 8.500 s")));
  EXPECT_EQ(review.nextEvent(0.0, onlyKind(EventKind::kStop)), std::optional(8.0));
  EXPECT_EQ(review.previousEvent(11.0, onlyKind(EventKind::kLost)).value_or(0.0), of(EventKind::kLost)[0].t0);
  EXPECT_FALSE(review.nextEvent(9.0, onlyKind(EventKind::kStop)));
  // Without a kind: those that are shown.
  EXPECT_LT(review.nextEvent(3.5).value_or(9.0), 6.5);
  review.showKinds(onlyKind(EventKind::kStop));
  EXPECT_EQ(review.nextEvent(3.5), std::optional(8.0));
  review.setStops({}, outline);
  EXPECT_TRUE(of(EventKind::kStop).empty());
}

}  // namespace recording_event_test
}  // namespace abstand::ui
