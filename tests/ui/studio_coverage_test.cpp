// "Plan a depth camera" in the window, against the command line.
#include <sys/wait.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QToolTip>
#include <nlohmann/json.hpp>

#include "core/base/number.hpp"
#include "core/base/text_file.hpp"
#include "tests/ui/modal_answer.hpp"
#include "tests/ui/studio_window.hpp"
#include "tracking/depth/camera/depth_camera.hpp"
#include "ui/coverage_commands.hpp"
#include "ui/document/project_file.hpp"
#include "ui/model/playback.hpp"
#include "ui/panels/coverage_dialog.hpp"
#include "ui/panels/coverage_strip.hpp"
#include "ui/panels/sensor_editor.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/format.hpp"

namespace abstand::studio {
namespace studio_coverage_test {

using ui::HiddenBy;

constexpr double kShare = 1e-6;  // of numbers that went through JSON as floats

struct StudioCoverage : StudioWindow {
  /// A person walks from x = 0.0 to 0.19 m, seen from y = 4 m beside a wall that covers x > 0.1 m half way.
  StudioCoverage() {
    writeUpright("walk.csv", 0.0);
    scene = folder.write(
        "coverage.yaml",
        "abstand: 1\ndefaults: {voxel: 0.1, point: 0.1}\npairs: {default: none}\n"
        "humans:\n  - {name: anna, recording: {file: walk.csv}}\n"
        "objects:\n  - {name: wall, shape: {cuboid: {size: [2, 0.1, 6]}}, pose: {xyz: [1.1, 2, 0]}}\n");
  }
  void SetUp() override {
    ASSERT_TRUE(opens([&] { window.openFile(QString::fromStdString(scene.string())); })) << problem;
  }
  static ui::SensorPlan plan() {
    ui::SensorPlan plan;
    plan.xyz = {0.1, 4.0, 1.0};
    plan.azimuth = -0.5 * kPi;
    return plan;
  }
  void place(const ui::SensorPlan& where) {
    window.document().edit("place", [&](ui::Work& work) { work.sensor = where; });
  }
  void openDialog() {
    window.actions()[ui::ActionId::kPlanSensor]->trigger();
    dialog = window.coverage().dialog();
    ASSERT_TRUE(dialog);
  }
  bool answered() {
    return QTest::qWaitFor([&] { return !dialog->waiting(); }, kLoadMs);
  }
  void click(const char* word) {
    for (QPushButton* button : dialog->findChildren<QPushButton*>())
      if (button->text().remove('&').contains(QLatin1String(word))) return button->click();
    FAIL() << word;
  }
  nlohmann::json coverage(const ui::SensorPlan& where, const std::string& more = {}) {
    const Vector3d eye = where.xyz, ahead = where.X_W().linear().col(2), look = eye + ahead;
    const auto list = [](const Vector3d& p) {
      return formatDouble(p.x()) + "," + formatDouble(p.y()) + "," + formatDouble(p.z());
    };
    const auto out = folder.path() / "coverage.json";
    const std::string command = "'" ABSTAND_PROGRAM "' coverage '" + scene.string() + "' --eye=" + list(eye) +
                                " --look=" + list(look) + " " + more + " --json >'" + out.string() + "'";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 0) << command;
    return nlohmann::json::parse(readFile(out, 1 << 28, true));
  }
  void expectAnswer(const nlohmann::json& expected) {
    const ui::CoverageReport& report = dialog->report();
    ASSERT_EQ(report.parts.size(), expected["parts"].size()) << dialog->sentence()->text().toStdString();
    for (std::size_t i = 0; i < report.parts.size(); ++i) {
      const ui::CoveragePart& part = report.parts[i];
      const nlohmann::json& as = expected["parts"][i];
      EXPECT_EQ(part.name.toStdString(), as["part"].get<std::string>());
      std::size_t k = 0;
      for (const char* cause :
           {"seen", "unknown", "out_of_image", "out_of_range", "robot", "thing", "self"}) {
        EXPECT_NEAR(part.times[k], as["times"][cause].get<double>(), kShare) << part.name.toStdString();
        EXPECT_NEAR(part.surface[k++], as["surface"][cause].get<double>(), kShare);
      }
      ASSERT_EQ(part.spans.size(), as["spans"].size()) << part.name.toStdString();
      for (std::size_t s = 0; s < part.spans.size(); ++s)
        EXPECT_NEAR(part.spans[s].from, as["spans"][s]["t0"].get<double>(), 1e-9);
    }
  }
  int rowOf(const char* name) const {
    for (int row = 0; row < dialog->table()->rowCount(); ++row)
      if (dialog->table()->item(row, 0)->text() == QLatin1String(name)) return row;
    return -1;
  }

  std::filesystem::path scene;
  ui::CoverageDialog* dialog{nullptr};
};

TEST_F(StudioCoverage, TableIsThatOfTheCommand) {
  place(plan());
  openDialog();
  EXPECT_TRUE(dialog->waiting());
  ASSERT_TRUE(answered());
  const nlohmann::json expected = coverage(plan());
  expectAnswer(expected);
  // The person walks behind the wall: the trunk is hidden at the end, not in the beginning.
  const int torso = rowOf("anna/torso");
  ASSERT_GE(torso, 0);
  const ui::CoveragePart& part = dialog->report().parts[static_cast<std::size_t>(torso)];
  EXPECT_GT(part.surface[static_cast<std::size_t>(HiddenBy::kThing)], 0.2);
  EXPECT_EQ(dialog->table()->item(torso, ui::CoverageDialog::columnOf(HiddenBy::kSeen))->text(),
            QString("%1 %").arg(ui::fixed(100.0 * part.times[0], 1)));
  const ui::CoverageSpan* longest = nullptr;
  for (const ui::CoveragePart& each : dialog->report().parts)
    for (const ui::CoverageSpan& span : each.spans)
      if (!longest || span.to - span.from > longest->to - longest->from) longest = &span;
  ASSERT_TRUE(longest);
  EXPECT_TRUE(dialog->sentence()->text().contains(
      QString("(%1)").arg(ui::secondsWithUnit(longest->to - longest->from))))
      << dialog->sentence()->text().toStdString();
  // Causes that do not occur have no column.
  EXPECT_TRUE(dialog->table()->isColumnHidden(ui::CoverageDialog::columnOf(HiddenBy::kOtherPerson)));
}

TEST_F(StudioCoverage, ClickOnSpanGoesThere) {
  ui::SensorPlan away = plan();
  away.azimuth = 0.5 * kPi;
  place(away);
  openDialog();
  ASSERT_TRUE(answered());
  const int torso = rowOf("anna/torso");
  const ui::CoveragePart& part = dialog->report().parts[static_cast<std::size_t>(torso)];
  ASSERT_EQ(part.spans.size(), 1u) << "the camera looks away all the time";
  EXPECT_EQ(part.spans[0].cause, HiddenBy::kOutOfImage);
  window.playback().seek(1.0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(window.moment().t - 1.0) < 1e-9; }, kLoadMs));
  QTableWidget& table = *dialog->table();
  table.scrollToItem(table.item(torso, ui::CoverageDialog::stripColumn()));
  const QRect cell = table.visualItemRect(table.item(torso, ui::CoverageDialog::stripColumn()));
  ASSERT_GT(cell.width(), 40);
  QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, cell.center());
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return std::abs(window.moment().t - part.spans[0].from) < 1e-9; }, kLoadMs));
  // Enter in a row goes to the longest time hidden, too.
  window.playback().seek(1.0);
  Q_EMIT table.cellActivated(torso, 0);
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return std::abs(window.moment().t - part.spans[0].from) < 1e-9; }, kLoadMs));
}

TEST_F(StudioCoverage, EditsAreUndoneAndComputedAnew) {
  place(plan());
  openDialog();
  ASSERT_TRUE(answered());
  const double seen = dialog->report().parts[0].times[0];
  // Behind the person: nothing is between.
  QDoubleSpinBox* y = dialog->editor()->box(1);
  y->setValue(-4.0 * ui::lengthFactor());
  dialog->editor()->box(3)->setValue(90.0);
  EXPECT_TRUE(dialog->waiting()) << "what was shown was of another pose";
  EXPECT_EQ(dialog->table()->rowCount(), 0);
  ASSERT_TRUE(answered());
  EXPECT_EQ(work().sensor->xyz.y(), -4.0);
  EXPECT_NEAR(work().sensor->azimuth, 0.5 * kPi, 1e-12);
  EXPECT_EQ(dialog->report().parts[0].times[0], 1.0);
  expectAnswer(coverage(*work().sensor));
  window.document().steps().undo();
  ASSERT_TRUE(answered());
  EXPECT_EQ(work().sensor, plan());
  EXPECT_EQ(dialog->report().parts[0].times[0], seen);
  EXPECT_NEAR(dialog->editor()->box(1)->value(), 4.0 * ui::lengthFactor(), 1e-9);
}

TEST_F(StudioCoverage, ThingThatIsMovedCounts) {
  place(plan());
  openDialog();
  ASSERT_TRUE(answered());
  EXPECT_GT(dialog->report().parts[0].surface[static_cast<std::size_t>(HiddenBy::kThing)], 0.2);
  window.document().edit("move", [](ui::Work& work) { work.things["wall"].xyz = {1.1, -5.0, 0.0}; });
  EXPECT_TRUE(dialog->waiting());
  ASSERT_TRUE(answered());
  EXPECT_EQ(dialog->report().parts[0].surface[static_cast<std::size_t>(HiddenBy::kThing)], 0.0);
}

TEST_F(StudioCoverage, SensorIsTakenFromTheView) {
  EXPECT_TRUE(window.viewport().sensorCorners().empty());
  window.viewport().setCameraView({{0.1, 0.0, 1.0}, 3.5, 0.7, 0.25});
  openDialog();
  ASSERT_TRUE(work().sensor);
  // It looks at the focus of the view from the eye.
  const Transform X_W = work().sensor->X_W();
  const Vector3d focus = X_W * Vector3d(0, 0, 3.5);
  const ui::CameraView view = window.viewport().cameraView();
  EXPECT_LT((focus - view.focus).norm(), 1e-9);
  EXPECT_NEAR(X_W.linear().col(0).z(), 0.0, 1e-12) << "level rows";
  EXPECT_LT(X_W.linear().col(1).z(), 0.0) << "the image is not upside down";
  ASSERT_TRUE(answered());
  expectAnswer(coverage(*work().sensor));
}

TEST_F(StudioCoverage, FieldOfViewIsDrawn) {
  place(plan());
  const std::vector<Vector3d> corners = window.viewport().sensorCorners();
  ASSERT_EQ(corners.size(), 8u);
  // A Kinect v1 at (0.1, 4, 1) that looks along -y: at 8 m the image is 640 / 580 * 8 m wide and 480 / 580 *
  // 8 m high; the right of the image is towards -x.
  const double half_width = 320.0 / 580.0 * 8.0, half_height = 240.0 / 580.0 * 8.0;
  EXPECT_LT((corners[4] - Vector3d(0.1 + half_width, -4.0, 1.0 + half_height)).norm(), 1e-9);
  EXPECT_LT((corners[6] - Vector3d(0.1 - half_width, -4.0, 1.0 - half_height)).norm(), 1e-9);
  EXPECT_NEAR(corners[0].y(), 3.5, 1e-12);
  openDialog();
  ui::SensorPlan second = plan();
  second.sensor = "kinect_v2";
  place(second);
  EXPECT_NEAR(window.viewport().sensorCorners()[4].y(), -0.5, 1e-9);
  ASSERT_TRUE(answered());
  expectAnswer(coverage(second, "--sensor kinect_v2"));
  click("Remove");
  EXPECT_FALSE(work().sensor);
  EXPECT_TRUE(window.viewport().sensorCorners().empty());
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_FALSE(window.coverage().dialog());
  window.document().steps().undo();
  EXPECT_EQ(window.viewport().sensorCorners().size(), 8u);
}

TEST_F(StudioCoverage, ProjectKeepsTheSensor) {
  ui::SensorPlan kept = plan();
  kept.sensor = "kinect_v2";
  kept.elevation = -0.123456789012345;
  kept.roll = 0.1;
  place(kept);
  const QString file = in("kept.abstand");
  ui::writeProject(window.document().project(), file);
  const std::string text = readFile(file.toStdString(), 1 << 20);
  const ui::Project read = ui::readProject(file);
  EXPECT_EQ(read.work.sensor, kept);
  EXPECT_EQ(ui::projectText(read, QFileInfo(file).absolutePath()), text);
  ASSERT_TRUE(opens([&] { studio.openProject(read, file, false); })) << problem;
  EXPECT_EQ(work().sensor, kept);
  EXPECT_EQ(window.viewport().sensorCorners().size(), 8u);
}

TEST_F(StudioCoverage, CameraFileGivesLensAndPose) {
  place(plan());
  openDialog();
  tracking::DepthCamera camera;
  camera.width = 320;
  camera.height = 240;
  camera.fx = camera.fy = 290.0;
  camera.cx = 150.0;
  camera.cy = 119.5;
  camera.X_WC = tracking::lookingAt({0.3, 3.5, 1.6}, {0.1, 0.0, 1.0}) * fromXyzRpy({0, 0, 0}, {0, 0, 0.2});
  const std::string file = folder.write("camera.yaml", tracking::describeDepthCamera(camera)).string();
  const auto choose = [&](const std::string& chosen) {
    const ui::ModalAnswer answer = ui::ModalAnswer::choose("open_camera", QString::fromStdString(chosen));
    click("camera file");
    EXPECT_TRUE(answer.answered());
  };
  choose(file);
  ASSERT_TRUE(work().sensor->lens);
  EXPECT_EQ(work().sensor->sensor, "file");
  EXPECT_TRUE(work().sensor->X_W().isApprox(camera.X_WC, 1e-12)) << "with the roll of the file";
  EXPECT_TRUE(dialog->editor()->kinds()->currentText().startsWith("camera.yaml: 320 x 240"));
  ASSERT_TRUE(answered());
  const auto out = folder.path() / "file.json";
  const std::string command = "'" ABSTAND_PROGRAM "' coverage '" + scene.string() + "' --camera '" + file +
                              "' --json >'" + out.string() + "'";
  ASSERT_EQ(WEXITSTATUS(std::system(command.c_str())), 0);
  expectAnswer(nlohmann::json::parse(readFile(out, 1 << 28, true)));
  // The field of view is that of the lens, which is not symmetric: the left edge of the image is nearer to
  // its centre.
  const Vector3d left = camera.X_WC.inverse() * window.viewport().sensorCorners()[4];
  EXPECT_NEAR(left.x(), 8.0 * (-0.5 - 150.0) / 290.0, 1e-9);

  // The project keeps it.
  const QString project = in("lens.abstand");
  ui::writeProject(window.document().project(), project);
  EXPECT_EQ(ui::readProject(project).work.sensor, work().sensor);
  // A file without a pose gives its lens only.
  std::string text = tracking::describeDepthCamera(camera);
  folder.write("lens.yaml", text.substr(0, text.find("T_WC")));
  place(plan());
  choose(in("lens.yaml").toStdString());
  EXPECT_EQ(work().sensor->xyz, plan().xyz);
  EXPECT_EQ(work().sensor->azimuth, plan().azimuth);
  EXPECT_EQ(work().sensor->lens->cx, 150.0);
  // Another kind leaves the file among the choices; undo brings its lens back.
  ui::SensorPlan other = *work().sensor;
  other.sensor = "kinect";
  place(other);
  EXPECT_EQ(dialog->editor()->kinds()->count(), 3);
  EXPECT_TRUE(dialog->editor()->kinds()->currentText().startsWith("Kinect v1"));
  window.document().steps().undo();
  EXPECT_TRUE(dialog->editor()->kinds()->currentText().startsWith("lens.yaml"));
  // What is no camera file changes nothing, and says so.
  const ui::SensorPlan before = *work().sensor;
  choose(scene.string());
  EXPECT_EQ(*work().sensor, before);
  auto* problem_box = window.findChild<QMessageBox*>();
  ASSERT_TRUE(problem_box);
  EXPECT_TRUE(problem_box->text().contains("a camera file")) << problem_box->text().toStdString();
  problem_box->close();
}

TEST(SensorPlan, PoseIsKept) {
  for (const double azimuth : {-3.0, 0.0, 1.2})
    for (const double elevation : {-0.5 * kPi, -1.0, 0.0, 0.7})
      for (const double roll : {-2.5, 0.0, 0.4}) {
        ui::SensorPlan plan;
        plan.xyz = {1.0, -2.0, 3.0};
        plan.azimuth = azimuth;
        plan.elevation = elevation;
        plan.roll = roll;
        EXPECT_TRUE(ui::withPose({}, plan.X_W()).X_W().isApprox(plan.X_W(), 1e-12))
            << azimuth << " " << elevation << " " << roll;
      }
}

TEST_F(StudioCoverage, StoppingAndClosingEndTheWork) {
  const QSignalSpy cancelled(&window.coverage(), &ui::CoverageCommands::cancelled);
  place(plan());
  openDialog();
  const int before = cancelled.size();
  click("Stop");
  EXPECT_FALSE(dialog->waiting());
  EXPECT_EQ(cancelled.size(), before + 1);
  QTest::qWait(600);
  EXPECT_EQ(dialog->table()->rowCount(), 0) << "nothing comes after a stop";
  dialog->editor()->box(0)->stepUp();
  ASSERT_TRUE(answered());
  EXPECT_EQ(dialog->table()->rowCount(), 14);
}

}  // namespace studio_coverage_test
}  // namespace abstand::studio
