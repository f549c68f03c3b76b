// The window on a real session: what it says of margins is what the command line says.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QTest>

#include <nlohmann/json.hpp>

#include "app/depth/open_session.hpp"
#include "core/base/text_file.hpp"
#include "core/margin/proposed_margin.hpp"
#include "tests/ui/modal_answer.hpp"
#include "tests/ui/slide_studio.hpp"
#include "ui/document/document.hpp"
#include "ui/model/event_text.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/pair_matrix.hpp"
#include "ui/panels/proposal_dialog.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/style/actions.hpp"

namespace abstand::studio {
namespace studio_session_test {

using State = view::AnalysisNews::State;

struct StudioSession : SlideStudio {
  StudioSession() : SlideStudio({.robot = 0.5, .person = 0.3, .stops_at = 1.8, .seconds = 4.0}) {}
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
  /// As the window's session has it.
  view::SceneOutline outline() const {
    return depth::openSession(scene_file::loadScene(scene), {})->outline();
  }
  /// By the sliders of all parts of a group, mm.
  void drag(const char* group, int millimetres) {
    window.panels()
        .margins->groupRow(QString::fromLatin1(group))
        ->findChild<QSlider*>()
        ->setValue(millimetres);
  }
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

/// Answers the dialog of the assumptions: numbers as its boxes show them.
void answerAssumptions(const ui::MainWindow& window, const std::map<std::string, double>& numbers) {
  const ui::ModalAnswer answer("what_if_settings", [&](QWidget* dialog) {
    for (const auto& [name, value] : numbers)
      dialog->findChild<QDoubleSpinBox*>(QString::fromStdString(name))->setValue(value);
    static_cast<QDialog*>(dialog)->accept();
  });
  window.actions()[ui::ActionId::kWhatIf]->trigger();
  EXPECT_TRUE(answer.answered());
}

TEST_F(StudioSession, AssumptionsMatchTune) {
  open();
  ASSERT_TRUE(analysed());
  drag("person", 120);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.review().marginOf(0, 0) > 0.119; }, kLimitMs));
  const auto expectAs = [&](const std::string& options) {
    SCOPED_TRACE(options);
    QCoreApplication::processEvents();  // judged before the next turn of the event loop
    const auto answer = tune("--margins 0.12 " + options);
    for (const auto& row : answer["margins"]) {
      if (row["part"] != "whole_body") continue;
      const margin::MarginOutcome& outcome = window.review().review().outcome;
      EXPECT_EQ(outcome.stops, row["stops"].get<long>());
      EXPECT_EQ(outcome.false_stops, row["false_stops"].get<long>());
      EXPECT_EQ(outcome.missed_stops, row["missed_stops"].get<long>());
      EXPECT_NEAR(outcome.stoppedShare(), row["stopped_share"].get<double>(), 1e-12);
    }
    const auto proposals = margin::proposeMargins(*window.review().store(), window.review().options());
    for (std::size_t i = 0; i < proposals.size(); ++i)
      if (std::isfinite(proposals[i].margin)) {
        EXPECT_EQ(proposals[i].margin, answer["proposed"][i]["margin"].get<double>());
      }
  };
  const auto analysedAgain = [&](long before) {
    return QTest::qWaitFor([&] { return window.review().opened() > before; }, kLimitMs) && analysed();
  };
  expectAs("");
  const margin::MarginOutcome usual = window.review().review().outcome;
  // The restart time needs no other distances: the outcome is there at once.
  long opened = window.review().opened();
  answerAssumptions(window, {{"restart_time", 0.7}});
  EXPECT_EQ(window.document().work().what_if.restart_time, 0.7);
  EXPECT_EQ(window.review().opened(), opened);
  EXPECT_EQ(window.review().options().restart_time, 0.7);
  EXPECT_GE(window.review().review().outcome.stopped_time, usual.stopped_time);
  expectAs("--restart-time 0.7");
  answerAssumptions(
      window, {{"reaction_time", 0.5}, {"deceleration", 0.8}, {"limit", 20.0}, {"calibration_error", 5.0}});
  ASSERT_TRUE(analysedAgain(opened));
  expectAs(
      "--restart-time 0.7 --reaction-time 0.5 --deceleration 0.8 --limit 0.02 --calibration-error 0.005");
  EXPECT_NE(window.review().review().outcome.missed_stops, usual.missed_stops) << "the assumptions matter";
  EXPECT_TRUE(window.panels().timeline->whatIf()->toolTip().contains("reaction time 0.5 s"));
  opened = window.review().opened();
  window.actions()[ui::ActionId::kUndo]->trigger();
  window.actions()[ui::ActionId::kUndo]->trigger();
  EXPECT_EQ(window.document().work().what_if, ui::WhatIfSettings());
  ASSERT_TRUE(analysedAgain(opened));
  expectAs("");
}

TEST_F(StudioSession, UncheckedPairsAreLeftOut) {
  open();
  ASSERT_TRUE(analysed());
  drag("person", 120);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.review().marginOf(0, 0) > 0.119; }, kLimitMs));
  QCoreApplication::processEvents();
  ASSERT_GT(window.review().review().outcome.stops, 0);
  // The pairs of the part that breaks its margin first are unticked.
  const margin::StoreLayout layout = window.review().store()->layout();
  const std::size_t nearest = window.review().review().events.front().part;
  const std::vector<std::pair<int, int>> pairs = outline().pairs;
  std::string excluded;
  int unticked = 0;
  const long opened = window.review().opened();
  const std::size_t lanes = layout.parts.size();
  for (const auto& [part, link] : layout.pairs) {
    if (part != nearest) continue;
    const int pair = window.review().pairOf(part, link);
    ASSERT_GE(pair, 0);
    const auto [a, b] = pairs[static_cast<std::size_t>(pair)];
    Q_EMIT window.panels().matrix->checkWanted(a, b, false);
    excluded += (unticked++ ? ", [" : "[") + layout.parts[part].name + ", " + layout.links[link].name + "]";
  }
  EXPECT_EQ(window.review().leftOut(), unticked);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.review().opened() > opened; }, kLimitMs));
  ASSERT_TRUE(analysed());
  EXPECT_EQ(window.review().store()->layout().parts.size(), lanes - 1) << "a part without pairs has no lane";
  for (const auto& part : window.review().store()->layout().parts)
    EXPECT_NE(part.name, layout.parts[nearest].name);
  const std::string text = readFile(scene, 1 << 20, true);
  scene = folder.write("fewer.yaml", text + "pairs: {exclude: [" + excluded + "]}\n");
  const auto row = tuned("0.12");
  const margin::MarginOutcome& outcome = window.review().review().outcome;
  EXPECT_EQ(outcome.stops, row["stops"].get<long>());
  EXPECT_EQ(outcome.missed_stops, row["missed_stops"].get<long>());
  EXPECT_NEAR(outcome.stoppedShare(), row["stopped_share"].get<double>(), 1e-12);
  EXPECT_TRUE(window.panels().timeline->whatIf()->text().contains("left out"))
      << window.panels().timeline->whatIf()->text().toStdString();
  while (window.document().steps().canUndo()) window.document().steps().undo();
  EXPECT_EQ(window.review().leftOut(), 0);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return window.review().store() && window.review().store()->layout().parts.size() == lanes; },
      kLimitMs));
}

TEST_F(StudioSession, WithoutACheckedPairTheAnalysisSaysSo) {
  open();
  ASSERT_TRUE(analysed());
  const margin::StoreLayout layout = window.review().store()->layout();
  window.document().edit("none", [&](ui::Work& work) {
    for (const auto& [part, link] : layout.pairs)
      for (const auto& [a, b] : {std::pair(layout.parts[part].name, layout.links[link].name),
                                 std::pair(layout.links[link].name, layout.parts[part].name)})
        work.moved[{QString::fromStdString(a), QString::fromStdString(b)}] = QString();
  });
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.review().state() == State::kFailed; }, kLimitMs));
  EXPECT_FALSE(window.review().store());
  EXPECT_EQ(window.review().leftOut(), static_cast<int>(layout.pairs.size()));
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
