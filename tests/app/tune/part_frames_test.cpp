// Frames of merged recordings, from memory and from their files.
#include <gtest/gtest.h>

#include "app/tune/margin_events.hpp"
#include "app/tune/result_file.hpp"
#include "app/tune/tune_answer.hpp"
#include "core/base/error.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::tune {
namespace part_frames_test {

/// A result as `tune --out` writes it.
void writeResult(const testing::ScratchFolder& folder, const testing::SlideSpeeds& speeds,
                 const std::string& name) {
  const auto session = testing::openSlide(folder, speeds);
  ContentHash hash;
  hash.add(name.data(), name.size());
  std::filesystem::create_directories(folder.path() / "results");
  ResultWriter writer(folder.path() / "results" / (name + ".h5"), hash.value());
  TuneOptions options;
  options.pass.keep_frames = false;
  options.pass.on_frame = [&](const SettledFrame& frame, const PassResult& names) {
    writer.frame(frame, names);
  };
  writer.commit(tuneRecording(*session, options, {}, name), options);
}

TuneAnswer answerOf(const testing::ScratchFolder& folder, std::size_t held_frames) {
  TuneAnswer answer;
  MergedResults merged = mergeResults({folder.path()}, held_frames);
  answer.options = merged.options;
  answer.recordings = std::move(merged.recordings);
  answerQuestions({{0.0, 0.1, 0.5}, 1.0, {}, SpeedRule::kBoth}, answer);
  return answer;
}

class MergedFrames : public ::testing::Test {
 protected:
  void SetUp() override {
    writeResult(folder_, {}, "stands");
    writeResult(folder_, {.robot = 0.4, .person = 0.3, .stops_at = 2.0}, "comes");
  }
  testing::ScratchFolder folder_;
};

TEST_F(MergedFrames, GiveTheSameAnswerFromFiles) {
  const TuneAnswer held = answerOf(folder_, HeldFrames::kUsual), files = answerOf(folder_, 0);
  for (const TunedRecording& r : held.recordings) EXPECT_EQ(r.pass.parts.front().track.frames(), r.frames);
  for (const TunedRecording& r : files.recordings) EXPECT_EQ(r.pass.parts.front().track.frames(), 0u);
  ASSERT_EQ(held.table.rows.size(), files.table.rows.size());
  for (std::size_t i = 0; i < held.table.rows.size(); ++i) {
    const margin::MarginOutcome &a = held.table.rows[i].outcome, &b = files.table.rows[i].outcome;
    EXPECT_EQ(held.table.rows[i].part, files.table.rows[i].part);
    EXPECT_EQ(a.stops, b.stops);
    EXPECT_EQ(a.stopped_time, b.stopped_time);
    EXPECT_EQ(a.min_clearance, b.min_clearance);
  }
  for (std::size_t i = 0; i < held.table.proposed.size(); ++i) {
    const ProposedMargin &a = held.table.proposed[i], &b = files.table.proposed[i];
    EXPECT_EQ(a.margin, b.margin);
    EXPECT_EQ(a.needed, b.needed);
    ASSERT_EQ(a.decided_by.has_value(), b.decided_by.has_value());
    if (a.decided_by) {
      EXPECT_EQ(a.decided_by->t, b.decided_by->t);
    }
  }
  for (std::size_t i = 0; i < held.closest.size(); ++i) EXPECT_EQ(held.closest[i].t, files.closest[i].t);
  for (std::size_t i = 0; i < held.speeds.size(); ++i)
    EXPECT_EQ(held.speeds[i].speed_scale, files.speeds[i].speed_scale);
  for (std::size_t i = 0; i < held.strategies.size(); ++i)
    EXPECT_EQ(held.strategies[i].outcome.stopped_time, files.strategies[i].outcome.stopped_time);
  for (std::size_t i = 0; i < held.exposure.phases.size(); ++i)
    EXPECT_EQ(held.exposure.phases[i].time, files.exposure.phases[i].time);
  for (std::size_t r = 0; r < held.recordings.size(); ++r) {
    const auto a = marginEvents(held.recordings[r], 0.3, {}), b = marginEvents(files.recordings[r], 0.3, {});
    ASSERT_EQ(a.size(), b.size());
    EXPECT_FALSE(a.empty());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].t0, b[i].t0);
  }
}

TEST_F(MergedFrames, AreReadPartAfterPart) {
  const TuneAnswer files = answerOf(folder_, 0);
  for (const TunedRecording& r : files.recordings) {
    const PartFrames all(r);
    PartByPart parts(r);
    ASSERT_EQ(parts.size(), all.parts().size());
    // Backwards, so that no part can be what is left of the one before.
    for (std::size_t p = parts.size(); p-- > 0;) {
      const PartClearance &one = parts.part(p), &expected = all.parts()[p];
      EXPECT_EQ(one.part, expected.part);
      EXPECT_EQ(one.track.t, expected.track.t);
      EXPECT_EQ(one.track.clearance, expected.track.clearance);
      EXPECT_EQ(one.track.between, expected.track.between);
      EXPECT_EQ(one.track.braking, expected.track.braking);
      EXPECT_EQ(one.distance, expected.distance);
      EXPECT_EQ(one.link, expected.link);
      EXPECT_EQ(one.robot_speed, expected.robot_speed);
      EXPECT_EQ(one.separation.speed_scale, expected.separation.speed_scale);
      EXPECT_EQ(one.contact_scale, expected.contact_scale);
      EXPECT_EQ(one.contact.size(), expected.contact.size());
    }
  }
}

TEST_F(MergedFrames, RefuseAFileThatWasReplaced) {
  const TuneAnswer files = answerOf(folder_, 0);
  std::filesystem::rename(folder_.path() / "results" / "stands.h5", folder_.path() / "results" / "comes.h5");
  const TunedRecording& comes = files.recordings.front();
  ASSERT_EQ(comes.recording, "comes");
  EXPECT_THROW(PartFrames{comes}, ParseError);
  EXPECT_THROW(PartByPart{comes}, ParseError);
}

}  // namespace part_frames_test
}  // namespace abstand::tune
