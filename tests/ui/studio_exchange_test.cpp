// Files for other programs: a stretch of a recording, and pairs as SRDF.
#include <QAction>
#include <QFile>

#include "app/studio/pair_file.hpp"
#include "app/studio/range_file.hpp"
#include "core/base/error.hpp"
#include "tests/ui/fake_session.hpp"
#include "tests/ui/modal_answer.hpp"
#include "tests/ui/studio_window.hpp"
#include "tracking/registry/open_recording.hpp"
#include "ui/style/actions.hpp"

namespace abstand::studio {
namespace studio_exchange_test {

constexpr double kStored = 1e-6;  // m: compact recordings have whole micrometres

struct StudioExchangeTest : StudioWindow {};

TEST_F(StudioExchangeTest, ARangeReopensWithTheSameFrames) {
  ASSERT_TRUE(opens([&] { studio.openScene(in("scene.yaml"), QString(), 0.0); })) << problem;
  window.document().edit("range", [](ui::Work& work) { work.range = ui::TimeRange{0.45, 1.25}; });
  const QString file = in("range.rec");
  const auto answer = ui::ModalAnswer::choose("save_range", file);
  window.actions()[ui::ActionId::kSaveRange]->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(file); }, kLoadMs));
  const tracking::Recording whole = tracking::openRecording((folder.path() / "walk.csv").string());
  const tracking::Recording range = tracking::openRecording(file.toStdString());
  ASSERT_EQ(range.frames.size(), 8U) << "0.5 s to 1.2 s";
  for (std::size_t i = 0; i < range.frames.size(); ++i) {
    const auto& frame = range.frames[i];
    const auto& original = whole.frames[i + 5];
    EXPECT_NEAR(frame.t, original.t, 1e-6);
    for (std::size_t j = 0; j < frame.p.size(); ++j) {
      const Vector3d a = frame.p[j], b = original.p[j];
      EXPECT_EQ(a.allFinite(), b.allFinite());
      if (a.allFinite() && b.allFinite()) {
        EXPECT_NEAR((a - b).norm(), 0.0, 2.0 * kStored);
      }
    }
  }
  ASSERT_TRUE(opens([&] { studio.openRecording(file); })) << problem;
}

TEST_F(StudioExchangeTest, ARangeOfNothingIsRefused) {
  ui::Work work;
  work.scene = in("scene.yaml");
  EXPECT_THROW(writeRange(work, {}, "anna", {100.0, 101.0}, in("none.rec")), UsageError);
  EXPECT_THROW(writeRange(work, {}, "nobody", {0.0, 1.0}, in("none.rec")), UsageError);
  EXPECT_FALSE(QFile::exists(in("none.rec")));
}

TEST(PairFile, PairsComeBackAsTheyWere) {
  const ui::FakeSession session;
  view::SceneOutline outline = session.outline();
  // Two links that the scene checks.
  outline.unchecked.erase(outline.unchecked.begin() + 1);
  outline.pairs.emplace_back(0, 2);
  ui::Work work;
  work.moved[{"arm/link0", "arm/link2"}] = QString();
  const robot_file::Srdf srdf = uncheckedPairs(outline, work, "arm");
  ASSERT_EQ(srdf.disabled.size(), 10U) << "all pairs of five links";
  const auto reason = [&](const std::string& a, const std::string& b) {
    for (const auto& pair : srdf.disabled)
      if (pair.link1 == a && pair.link2 == b) return pair.reason;
    return std::string("none");
  };
  EXPECT_EQ(reason("link0", "link1"), "Adjacent");
  EXPECT_EQ(reason("link0", "link2"), "User");
  EXPECT_EQ(reason("link0", "link3"), "Default");
  ui::Work again;
  const robot_file::Srdf read = robot_file::parseSrdf(robot_file::srdfText(srdf), "arm.srdf");
  EXPECT_EQ(disablePairs(read, outline, "arm", again), 1U);
  EXPECT_EQ(again.moved, work.moved);
  EXPECT_EQ(disablePairs(read, outline, "other", again), 0U);
}

}  // namespace studio_exchange_test
}  // namespace abstand::studio
