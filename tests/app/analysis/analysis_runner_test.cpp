#include "app/analysis/analysis_runner.hpp"

#include <gtest/gtest.h>

#include "app/tune/margin_events.hpp"
#include "app/tune/margin_table.hpp"
#include "tests/app/analysis/stored_recording.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::analysis {
namespace analysis_runner_test {

using State = view::AnalysisNews::State;
using testing::StoredRecording;

constexpr double kFloat = 1e-6;  // m: of what is stored in four bytes, below 8 m
constexpr double kHalf = 1e-3;   // share: of what is stored in two bytes

class Analysis : public ::testing::Test {
 protected:
  testing::ScratchFolder folder_;
  std::unique_ptr<session::Session> session_ =
      testing::openSlide(folder_, {.robot = 0.5, .person = 0.2, .stops_at = 1.5, .seconds = 4.0});
};

TEST_F(Analysis, MatchesTuneResults) {
  const auto request = requestFor(*session_, {});
  ASSERT_TRUE(request);
  const StoredRecording stored = testing::analysed(*request);
  EXPECT_EQ(stored.last.state, State::kDone) << stored.last.problem;
  ASSERT_TRUE(stored.store);
  const auto tuned = tune::tuneRecording(*session_, {}, {}, "slide");
  ASSERT_EQ(stored.store->frames(), tuned.frames);
  EXPECT_EQ(stored.last.done, tuned.frames);
  ASSERT_EQ(stored.store->layout().parts.size(), tuned.pass.parts.size());
  for (const tune::PartClearance& part : tuned.pass.parts) {
    const auto& parts = stored.store->layout().parts;
    const auto at = std::find_if(parts.begin(), parts.end(),
                                 [&](const auto& body) { return body.name.ends_with("/" + part.part); });
    ASSERT_NE(at, parts.end());
    const auto k = static_cast<std::size_t>(at - parts.begin());
    for (std::size_t i = 0; i < tuned.frames; ++i) {
      const margin::ClearanceChunk::Nearest nearest = stored.store->nearest(k, i);
      EXPECT_EQ(stored.store->t(i), part.track.t[i]);
      EXPECT_LE(nearest.clearance, part.track.clearance[i]);
      EXPECT_NEAR(nearest.clearance, part.track.clearance[i], kFloat);
      EXPECT_NEAR(nearest.distance, part.distance[i], kHalf);
      EXPECT_LE(nearest.braking, part.track.braking[i]);
      EXPECT_LE(nearest.between, part.track.between[i]);
      if (std::isfinite(part.track.between[i])) {
        EXPECT_NEAR(nearest.between, part.track.between[i], kHalf * (1.0 + std::abs(nearest.between)));
      }
      EXPECT_FALSE(nearest.unknown);
    }
  }
}

TEST_F(Analysis, JudgesMarginsLikeTune) {
  const StoredRecording stored = testing::analysed(*requestFor(*session_, {}));
  const std::vector<tune::TunedRecording> recordings{tune::tuneRecording(*session_, {}, {}, "slide")};
  const std::size_t objects = session_->scene().objects().size();
  std::size_t events = 0;
  for (const double margin : {0.0, 0.05, 0.2, 0.4, 1.0}) {
    // Half of it for the person, half for the robot, as in the window.
    const margin::MarginReview review =
        margin::review(*stored.store, std::vector<double>(objects, 0.5 * margin), {});
    const tune::MarginTable table = tune::marginTable(recordings, {margin}, {});
    const auto row = std::find_if(table.rows.begin(), table.rows.end(),
                                  [](const auto& r) { return r.part == tune::kWholeBody; });
    ASSERT_NE(row, table.rows.end());
    EXPECT_EQ(review.outcome.stops, row->outcome.stops);
    EXPECT_EQ(review.outcome.false_stops, row->outcome.false_stops);
    EXPECT_EQ(review.outcome.missed_stops, row->outcome.missed_stops);
    EXPECT_EQ(review.outcome.stopped_time, row->outcome.stopped_time);
    EXPECT_EQ(review.outcome.time, row->outcome.time);
    std::vector<margin::ReviewEvent> found;
    for (const margin::ReviewEvent& event : review.events)
      if (event.kind != margin::ReviewEvent::Kind::kNear) found.push_back(event);
    const std::vector<tune::MarginEvent> expected = tune::marginEvents(recordings.front(), margin, {});
    ASSERT_EQ(found.size(), expected.size()) << margin;
    events += found.size();
    // Of those that begin together the parts may be in another order.
    for (std::size_t n = 0; n < found.size(); ++n) {
      EXPECT_EQ(found[n].t0, expected[n].t0);
      const std::string name = stored.store->layout().parts[found[n].part].name;
      const auto same = std::find_if(expected.begin(), expected.end(), [&](const auto& e) {
        return e.t0 == found[n].t0 && name.ends_with("/" + e.recording->pass.parts[e.part].part);
      });
      ASSERT_NE(same, expected.end());
      EXPECT_EQ(found[n].t1, same->t1);
      EXPECT_EQ(found[n].false_stop, same->false_stop);
      EXPECT_EQ(found[n].missed, same->missed);
      EXPECT_EQ(stored.store->layout().links[found[n].link].name, recordings[0].pass.links[same->link]);
    }
  }
  EXPECT_GT(events, 5u);
}

TEST_F(Analysis, RunsInBackgroundUntilStopped) {
  AnalysisRunner runner;
  const auto first = runner.start(*requestFor(*session_, {}));
  const auto second = runner.start(*requestFor(*session_, {}));
  EXPECT_TRUE(first->cancelled());
  StoredRecording stored;
  while (stored.last.state != State::kDone && stored.last.state != State::kFailed) {
    std::this_thread::yield();
    testing::takeNews(*second, stored);
  }
  EXPECT_EQ(stored.last.state, State::kDone) << stored.last.problem;
  EXPECT_EQ(stored.store->frames(), stored.last.frames);
  while (runner.running() > 0) std::this_thread::yield();
  view::AnalysisNews nothing;
  EXPECT_FALSE(second->take(nothing));
  runner.start(*requestFor(*session_, {}));
  runner.stop();
  while (runner.running() > 0) std::this_thread::yield();
}

TEST_F(Analysis, SharesStructuresWithSession) {
  const auto request = requestFor(*session_, {});
  const auto second = depth::openSession(request->scene, request->options);
  ASSERT_EQ(second->scene().objects().size(), session_->scene().objects().size());
  for (std::size_t i = 0; i < second->scene().objects().size(); ++i)
    EXPECT_EQ(second->scene().objects()[i].spec.structure, session_->scene().objects()[i].spec.structure);
}

TEST_F(Analysis, ReportsMissingRecording) {
  AnalysisRequest request = *requestFor(*session_, {});
  request.options.recording = folder_.path() / "none.csv";
  const StoredRecording stored = testing::analysed(request);
  EXPECT_EQ(stored.last.state, State::kFailed);
  EXPECT_NE(stored.last.problem.find("none.csv"), std::string::npos) << stored.last.problem;
}

TEST(AnalysisRequestFor, RequiresPersonAndRobot) {
  testing::ScratchFolder folder;
  const auto scene = folder.write("two.yaml", R"(abstand: 1
defaults: {voxel: 0.02, point: 0.02}
objects:
  - {name: a, shape: {sphere: {radius: 0.05}}}
  - {name: b, shape: {sphere: {radius: 0.05}}, pose: {xyz: [1, 0, 0]}}
)");
  session::SessionOptions options;
  options.cache = false;
  options.threads = 1;
  EXPECT_FALSE(requestFor(*depth::openSession(scene_file::loadScene(scene), options), {}));
}

}  // namespace analysis_runner_test
}  // namespace abstand::analysis
