// The window on a real session: what it says of margins is what the command line says.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

#include <nlohmann/json.hpp>

#include "app/studio/studio.hpp"
#include "core/base/text_file.hpp"
#include "core/margin/proposed_margin.hpp"
#include "tests/app/tune/slide_scene.hpp"
#include "ui/model/event_text.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/proposal_dialog.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/style/actions.hpp"

namespace abstand::studio {
namespace studio_session_test {

constexpr int kLimitMs = 240000;  // nothing takes so long, under a sanitizer either
using State = view::AnalysisNews::State;

struct StudioSession : ::testing::Test {
  StudioSession() {
    QSettings().clear();
    qputenv("ABSTAND_CACHE", (folder.path() / "cache").c_str());
    scene = testing::writeSlide(folder, {.robot = 0.5, .person = 0.3, .stops_at = 1.8, .seconds = 4.0});
    window.resize(1400, 1000);
    window.show();
    studio = std::make_unique<Studio>(window);
  }
  bool analysed() {
    return QTest::qWaitFor([this] { return window.review().state() == State::kDone; }, kLimitMs);
  }
  void open() {
    QSignalSpy ready(studio.get(), &Studio::ready);
    studio->openScene(QString::fromStdString(scene.string()), {}, 0.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !ready.isEmpty(); }, kLimitMs));
  }
  /// The row of `abstand tune` for all parts with this margin (m).
  nlohmann::json tuned(const std::string& margin) {
    const auto answer = tune("--margins " + margin);
    for (const auto& row : answer["margins"])
      if (row["part"] == "whole_body") return row;
    return {};
  }
  /// The answer of `abstand tune` with these options.
  nlohmann::json tune(const std::string& options) {
    const auto out = folder.path() / "tune.json";
    const std::string command = "'" ABSTAND_PROGRAM "' tune '" + scene.string() + "' " + options +
                                " --json >'" + out.string() + "' 2>'" + (folder.path() / "err").string() +
                                "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return nlohmann::json::parse(readFile(out, 1 << 28, true));
  }
  /// By the sliders of all parts of a group, mm.
  void drag(const char* group, int millimetres) {
    window.panels()
        .margins->groupRow(QString::fromLatin1(group))
        ->findChild<QSlider*>()
        ->setValue(millimetres);
  }

  testing::ScratchFolder folder;
  std::filesystem::path scene;
  ui::MainWindow window;
  std::unique_ptr<Studio> studio;
};

TEST_F(StudioSession, DraggedMarginsMatchTune) {
  open();
  ASSERT_TRUE(analysed()) << window.review().problem().toStdString();
  const ui::RecordingReview& review = window.review();
  long stops = 0;
  for (const auto& [person, robot] : {std::pair{0, 0}, {50, 0}, {120, 30}, {0, 250}, {300, 300}}) {
    drag("person", person);
    drag("slide", robot);
    const double margin = 1e-3 * person + 1e-3 * robot;
    ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(review.marginOf(0, 0) - margin) < 1e-9; }, kLimitMs));
    QCoreApplication::processEvents();
    const auto row = tuned(std::to_string(1e-3 * (person + robot)));
    const margin::MarginOutcome& outcome = review.review().outcome;
    EXPECT_EQ(outcome.stops, row["stops"].get<long>());
    EXPECT_EQ(outcome.false_stops, row["false_stops"].get<long>());
    EXPECT_EQ(outcome.missed_stops, row["missed_stops"].get<long>());
    EXPECT_NEAR(outcome.stoppedShare(), row["stopped_share"].get<double>(), 1e-12);
    EXPECT_EQ(window.panels().timeline->whatIf()->text(), ui::whatIfText(review));
    stops += outcome.stops;
  }
  EXPECT_GT(stops, 0);
}

TEST_F(StudioSession, ProposedMarginsMatchTune) {
  open();
  ASSERT_TRUE(analysed());
  const auto answer = tune("");
  const auto proposals = margin::proposeMargins(*window.review().store(), {});
  ASSERT_EQ(proposals.size(), answer["proposed"].size());
  const auto& layout = window.review().store()->layout();
  int decided = 0;
  for (const auto& proposal : proposals) {
    const std::string name = layout.parts[proposal.parts.front()].name;
    SCOPED_TRACE(name);
    const auto row = std::find_if(answer["proposed"].begin(), answer["proposed"].end(), [&](const auto& p) {
      return "person/" + p["part"].template get<std::string>() == name;
    });
    ASSERT_TRUE(row != answer["proposed"].end());
    EXPECT_EQ(proposal.margin, (*row)["margin"].get<double>());
    ASSERT_EQ(proposal.decided_by.has_value(), !(*row)["decided_by"].is_null());
    if (!proposal.decided_by) continue;
    ++decided;
    EXPECT_EQ(proposal.decided_by->t, (*row)["decided_by"]["t"].get<double>());
    EXPECT_EQ(layout.links[proposal.decided_by->link].name, (*row)["decided_by"]["link"].get<std::string>());
    constexpr double kRounded = 1e-3;  // m: the store keeps errors as half floats
    EXPECT_NEAR(proposal.decided_by->bound, (*row)["uncertainty"]["bound"].get<double>(), kRounded);
    EXPECT_NEAR(proposal.decided_by->pose, (*row)["uncertainty"]["pose"].get<double>(), kRounded);
    EXPECT_NEAR(proposal.decided_by->sampling, (*row)["uncertainty"]["sampling"].get<double>(), kRounded);
  }
  EXPECT_GT(decided, 0);
  // Applied, they miss no stop, as tune says of the set.
  window.actions()[ui::ActionId::kNoMargins]->trigger();
  window.actions()[ui::ActionId::kProposeMargins]->trigger();
  window.findChild<ui::ProposalDialog*>()->accept();
  QCoreApplication::processEvents();
  const auto set = std::find_if(answer["margin_sets"].begin(), answer["margin_sets"].end(),
                                [](const auto& s) { return s["name"] == "per_part"; });
  ASSERT_TRUE(set != answer["margin_sets"].end());
  EXPECT_EQ(window.review().review().outcome.missed_stops, 0);
  EXPECT_EQ(window.review().review().outcome.stops, (*set)["stops"].get<long>());
}

TEST_F(StudioSession, CurvePointsMatchTune) {
  open();
  ASSERT_TRUE(analysed());
  window.actions()[ui::ActionId::kNoMargins]->trigger();
  QCoreApplication::processEvents();
  const auto& parts = window.review().store()->layout().parts;
  const auto answer = tune("--margins 0:0.3:0.05");
  int compared = 0;
  for (const auto& row : answer["margins"])
    for (std::size_t part = 0; part < parts.size(); ++part) {
      if (parts[part].name != "person/" + row["part"].get<std::string>()) continue;
      const margin::MarginOutcome outcome = window.review().outcomeOf(part, row["margin"].get<double>());
      EXPECT_EQ(outcome.stops, row["stops"].get<long>());
      EXPECT_EQ(outcome.false_stops, row["false_stops"].get<long>());
      EXPECT_EQ(outcome.missed_stops, row["missed_stops"].get<long>());
      EXPECT_NEAR(outcome.stoppedShare(), row["stopped_share"].get<double>(), 1e-12);
      ++compared;
    }
  EXPECT_EQ(compared, 14 * 7);
}

TEST_F(StudioSession, CommandLineReadsSetOfWindow) {
  open();
  ASSERT_TRUE(analysed());
  drag("person", 120);
  drag("slide", 40);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.review().marginOf(0, 0) > 0.159; }, kLimitMs));
  QCoreApplication::processEvents();
  window.actions()[ui::ActionId::kCopyMargins]->trigger();
  const auto file = folder.write("set.yaml", QApplication::clipboard()->text().toStdString());
  const auto sets = tune("--margin-set '" + file.string() + "'")["margin_sets"];
  const auto& set = sets.back();
  EXPECT_EQ(set["name"].get<std::string>(), file.string());
  const margin::MarginOutcome& outcome = window.review().review().outcome;
  EXPECT_GT(outcome.stops, 0);
  EXPECT_EQ(outcome.stops, set["stops"].get<long>());
  EXPECT_EQ(outcome.missed_stops, set["missed_stops"].get<long>());
  EXPECT_NEAR(outcome.stoppedShare(), set["stopped_share"].get<double>(), 1e-3);
}

TEST_F(StudioSession, OpeningAnotherSceneEndsAnalysis) {
  open();
  EXPECT_TRUE(window.review().available());
  open();
  ASSERT_TRUE(analysed());
  const auto wall = folder.write("wall.yaml",
                                 "abstand: 1\ndefaults: {voxel: 0.1, point: 0.1}\nobjects:\n"
                                 "  - {name: wall, shape: {cuboid: {size: [0.2, 1, 1]}}}\n");
  scene = wall;
  open();
  EXPECT_FALSE(window.review().available());
  studio.reset();
  EXPECT_FALSE(window.review().available());
}

TEST_F(StudioSession, EventsNeedNoPlayback) {
  open();
  ASSERT_TRUE(analysed());
  drag("person", 300);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.review().marginOf(0, 0) > 0.29; }, kLimitMs));
  QCoreApplication::processEvents();
  const auto event = window.review().nextEvent(0.0);
  ASSERT_TRUE(event);
  window.playback().seek(*event);
  // The live session shows the same moment, with a pair whose margin is broken or near.
  ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(window.playback().time() - *event) < 1e-9; }, kLimitMs));
}

}  // namespace studio_session_test
}  // namespace abstand::studio
