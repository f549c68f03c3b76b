// "Propose speeds" in the window: the table, the motion files, and stopping, against the command line.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <QAction>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <nlohmann/json.hpp>

#include "core/base/text_file.hpp"
#include "tests/ui/modal_answer.hpp"
#include "tests/ui/slide_studio.hpp"
#include "ui/document/document.hpp"
#include "ui/model/playback.hpp"
#include "ui/panels/speed_dialog.hpp"
#include "ui/speed_commands.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/format.hpp"

namespace abstand::studio {
namespace studio_speeds_test {

struct StudioSpeeds : SlideStudio {
  // The ball ends 1.1 m before the person, who stands.
  StudioSpeeds() : SlideStudio({.robot = 0.3, .person = 0.0, .seconds = 4.0}) {
    qputenv("PATH", QFileInfo(ABSTAND_PROGRAM).absolutePath().toLocal8Bit() + ":" + qgetenv("PATH"));
    open();
    window.actions()[ui::ActionId::kProposeSpeeds]->trigger();
    dialog = window.speeds().dialog();
  }
  void click(const char* word) {
    for (QPushButton* button : dialog->findChildren<QPushButton*>())
      if (button->text().remove('&').contains(QLatin1String(word))) return button->click();
    FAIL() << word;
  }
  bool answered() {
    return QTest::qWaitFor([&] { return !dialog->waiting(); }, kLimitMs);
  }
  nlohmann::json tune(const std::string& options) {
    const auto out = folder.path() / "tune.json";
    const std::string command = "'" ABSTAND_PROGRAM "' tune '" + scene.string() + "' " + options +
                                " --json >'" + out.string() + "' 2>/dev/null";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 0);
    return nlohmann::json::parse(readFile(out, 1 << 28, true));
  }
  QString cell(int row, int column) const { return dialog->table()->item(row, column)->text(); }

  ui::SpeedDialog* dialog{nullptr};
};

TEST_F(StudioSpeeds, TableIsThatOfTune) {
  ASSERT_TRUE(dialog);
  // So slow that the person limits the robot.
  window.document().edit("slow", [](ui::Work& work) {
    work.what_if.reaction_time = 0.6;
    work.separation.options.stopping_time = 0.8;
  });
  dialog->findChild<QDoubleSpinBox*>("segment")->setValue(0.5);
  click("Compute");
  EXPECT_TRUE(dialog->waiting());
  ASSERT_TRUE(answered());
  const auto answer = tune("--segment 0.5 --reaction-time 0.6 --separation stopping_time=0.8");
  const auto& speeds = answer["speeds"];
  ASSERT_EQ(dialog->table()->rowCount(), static_cast<int>(speeds.size()))
      << dialog->sentence()->text().toStdString();
  int limited = 0;
  for (int i = 0; i < dialog->table()->rowCount(); ++i) {
    const auto& expected = speeds[static_cast<std::size_t>(i)];
    EXPECT_EQ(cell(i, 1), QString("%1 %").arg(ui::fixed(100.0 * expected["speed_scale"].get<double>(), 0)));
    EXPECT_TRUE(cell(i, 0).startsWith(ui::secondsWithUnit(expected["t0"].get<double>())));
    if (expected["limited_by"].is_null()) continue;
    ++limited;
    EXPECT_TRUE(
        cell(i, 2).contains(QString::fromStdString(expected["limited_by"]["part"].get<std::string>())));
  }
  EXPECT_GT(limited, 0);
  // A double click goes to the moment that limits a segment.
  int last = dialog->table()->rowCount() - 1;
  while (last >= 0 && speeds[static_cast<std::size_t>(last)]["limited_by"].is_null()) --last;
  ASSERT_GE(last, 0);
  Q_EMIT dialog->table()->cellActivated(last, 0);
  const double t = speeds[static_cast<std::size_t>(last)]["limited_by"]["t"].get<double>();
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(window.playback().time() - t) < 0.02; }, kLimitMs));
}

TEST_F(StudioSpeeds, AssumptionsOfTheWindowCount) {
  window.document().edit("slow", [](ui::Work& work) {
    work.what_if.reaction_time = 0.6;
    work.separation.options.stopping_time = 0.8;
  });
  click("Compute");
  ASSERT_TRUE(answered());
  const auto slow = tune("--reaction-time 0.6 --separation stopping_time=0.8");
  const auto usual = tune("");
  EXPECT_NE(slow["speeds"], usual["speeds"]) << "the assumptions matter here";
  for (int i = 0; i < dialog->table()->rowCount(); ++i)
    EXPECT_EQ(cell(i, 1),
              QString("%1 %").arg(ui::fixed(
                  100.0 * slow["speeds"][static_cast<std::size_t>(i)]["speed_scale"].get<double>(), 0)));
}

TEST_F(StudioSpeeds, ProvenMotionIsSaved) {
  const auto out = folder.path() / "motions";
  std::filesystem::create_directory(out);
  const ui::ModalAnswer answer =
      ui::ModalAnswer::choose("speed_folder", QString::fromStdString(out.string()));
  click("Save motion");
  EXPECT_TRUE(answer.answered());
  ASSERT_TRUE(answered());
  const auto file = out / "permitted_speeds" / "slide.csv";
  ASSERT_TRUE(exists(file)) << dialog->sentence()->text().toStdString();
  EXPECT_TRUE(dialog->sentence()->text().contains("slide.csv"));
  const std::string text = readFile(file, 1 << 24, true);
  EXPECT_EQ(text.rfind("t,q0", 0), 0U) << text.substr(0, 40);
}

TEST_F(StudioSpeeds, StoppingAndClosingEndTheWork) {
  const QSignalSpy cancelled(&window.speeds(), &ui::SpeedCommands::cancelled);
  click("Compute");
  click("Stop");
  EXPECT_FALSE(dialog->waiting());
  EXPECT_EQ(cancelled.size(), 1);
  EXPECT_EQ(dialog->table()->rowCount(), 0);
  click("Compute");
  dialog->close();
  EXPECT_EQ(cancelled.size(), 2);
}

}  // namespace studio_speeds_test
}  // namespace abstand::studio
