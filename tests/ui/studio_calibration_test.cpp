// "Calibrate a depth camera" in the window, against the command line and the truth.
#include <sys/wait.h>

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/studio/calibration_job.hpp"
#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "humanmodel/part_uncertainty.hpp"
#include "tests/tracking/depth/calibration/board_picture.hpp"
#include "tests/ui/modal_answer.hpp"
#include "tests/ui/studio_window.hpp"
#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/formats/colour_png.hpp"
#include "ui/calibration_commands.hpp"
#include "ui/panels/calibration_dialog.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/format.hpp"

namespace abstand::studio {
namespace studio_calibration_test {

using ui::CalibrationMode;
using ui::CalibrationRequest;

struct StudioCalibration : StudioWindow {
  StudioCalibration() {
    qputenv("PATH",
            std::filesystem::path(ABSTAND_PROGRAM).parent_path().string().c_str() + (":" + qgetenv("PATH")));
    folder.write("kinect.yaml", tracking::describeDepthCamera({}));
    // The camera looks along world x from (1, 2, 3): its z is x, its x is -y, its y is -z.
    folder.write("points.csv",
                 "cx,cy,cz,wx,wy,wz\n0,0,1,2,2,3\n1,0,1,2,1,3\n0,1,1,2,2,2\n0,0,2,3,2,3.004\n1,1,2,3,1,2\n");
    openDialog();
  }
  void openDialog() {
    window.actions()[ui::ActionId::kCalibrate]->trigger();
    dialog = window.calibration().dialog();
  }
  bool answered() {
    return QTest::qWaitFor([&] { return !dialog->waiting(); }, kLoadMs);
  }
  CalibrationRequest points() const {
    CalibrationRequest request;
    request.mode = CalibrationMode::kPoints;
    request.clip = in("points.csv");
    request.camera = in("kinect.yaml");
    return request;
  }
  void ask(const CalibrationRequest& request) {
    dialog->setRequest(request);
    ASSERT_TRUE(dialog->computeButton()->isEnabled());
    dialog->computeButton()->click();
    ASSERT_TRUE(dialog->waiting());
  }
  QString cell(const QString& name) const {
    for (int row = 0; row < dialog->table()->rowCount(); ++row)
      if (dialog->table()->item(row, 0)->text() == name) return dialog->table()->item(row, 1)->text();
    return {};
  }
  int run(const std::string& arguments, const char* out = "/dev/null") {
    return WEXITSTATUS(
        std::system(("'" ABSTAND_PROGRAM "' " + arguments + " >'" + out + "' 2>/dev/null").c_str()));
  }
  Transform poseIn(const QString& camera) const {
    return tracking::loadDepthCamera(camera.toStdString()).X_WC;
  }
  /// What the dialog saves.
  std::string saved() {
    const QString file = in("saved.yaml");
    const ui::ModalAnswer answer = ui::ModalAnswer::choose("save_camera", file);
    dialog->saveButton()->click();
    EXPECT_TRUE(answer.answered());
    return readFile(file.toStdString(), 1 << 20);
  }

  ui::CalibrationDialog* dialog{nullptr};
};

TEST_F(StudioCalibration, PointsGiveResidualAndTheFileOfTheCommand) {
  ASSERT_TRUE(dialog);
  EXPECT_FALSE(dialog->computeButton()->isEnabled()) << "without files";
  EXPECT_FALSE(dialog->saveButton()->isEnabled());
  ask(points());
  ASSERT_TRUE(answered());
  const std::string placed = in("placed.yaml").toStdString(), json = in("answer.json").toStdString();
  ASSERT_EQ(run("calibrate '" + in("points.csv").toStdString() + "' --camera '" +
                    in("kinect.yaml").toStdString() + "' --out '" + placed + "' --json",
                json.c_str()),
            0);
  const auto expected = nlohmann::json::parse(readFile(json, 1 << 20));
  EXPECT_EQ(cell("Residual (RMS)"), ui::lengthText(expected["rms"].get<double>(), 2))
      << dialog->sentence()->text().toStdString();
  EXPECT_EQ(cell("Uncertainty of the pose"), ui::lengthText(expected["spread"].get<double>(), 2));
  EXPECT_EQ(cell("Points used"), "5");
  EXPECT_TRUE(
      cell("Largest residual").endsWith(QString("in line %1").arg(expected["worst_line"].get<int>())));
  const double widening = humanmodel::kSpreadQuantile * expected["spread"].get<double>();
  EXPECT_TRUE(dialog->sentence()->text().contains("at most " + ui::lengthText(widening, 2)));
  EXPECT_EQ(saved(), readFile(placed, 1 << 20));
  const tracking::DepthCamera camera = tracking::loadDepthCamera(in("saved.yaml").toStdString());
  EXPECT_LT((camera.X_WC.translation() - Vector3d(1, 2, 3)).norm(), 0.004);
}

TEST_F(StudioCalibration, ChessboardGivesPixels) {
  const tracking::Chessboard board{8, 5, 0.03};
  const Vector3d xyz(0.4, -0.2, 0.75), rpy(0.0, 0.0, 0.5);
  const Transform X_WO = fromXyzRpy(xyz, rpy);
  const tracking::DepthCamera truth = testing::cameraBefore(board, X_WO, 0.7, 0.5, 0.3, 0.2);
  const tracking::GreyImage grey = testing::pictureOf(truth, board, X_WO);
  tracking::ColourImage image(grey.width, grey.height);
  for (std::size_t i = 0; i < grey.pixels.size(); ++i) image.pixels[i].fill(grey.pixels[i]);
  tracking::saveColourPng(image, folder.path() / "board.png");
  CalibrationRequest request;
  request.mode = CalibrationMode::kChessboard;
  request.images = QStringList{in("board.png")};
  request.camera = in("kinect.yaml");
  request.board_xyz = xyz;
  request.board_rpy = rpy;
  ask(request);
  ASSERT_TRUE(answered());
  EXPECT_TRUE(cell("Residual (RMS)").endsWith("pixels")) << dialog->sentence()->text().toStdString();
  EXPECT_TRUE(cell("Largest residual").endsWith("board.png"));
  EXPECT_EQ(cell("Points used"), "28");
  saved();
  const tracking::DepthCamera found = tracking::loadDepthCamera(in("saved.yaml").toStdString());
  // The accuracy of the command's test, with a pose of the board that is rounded to 0.1 mm and 0.1 degrees.
  EXPECT_LT((found.X_WC.translation() - truth.X_WC.translation()).norm(), 0.003);
}

TEST_F(StudioCalibration, RoomThatAnotherCameraSees) {
  const auto box = [](const char* name, const char* size, const char* p) {
    return std::string("  - {name: ") + name + ", shape: {cuboid: {size: [" + size + "]}}, pose: {xyz: [" +
           p + "]}}\n";
  };
  folder.write("room.yaml",
               "abstand: 1\ndefaults: {voxel: 0.05, point: 0.05}\npairs: {default: none}\nobjects:\n" +
                   box("floor", "8, 8, 0.1", "0, 0, -0.05") + box("wall", "0.1, 8, 3", "-1.85, 0, 1.5") +
                   box("other", "8, 0.1, 3", "0, 1.85, 1.5") + box("box", "0.4, 0.3, 0.5", "0, 1, 0.25"));
  const std::string render = "render-depth '" + in("room.yaml").toStdString() +
                             "' --width 320 --start 0 --end 0.1 --no-cache --look -0.4,0.4,0.7 ";
  ASSERT_EQ(run(render + "--eye 2.4,-0.6,1.6 --out '" + in("front").toStdString() + "'"), 0);
  ASSERT_EQ(run(render + "--eye 1.0,-2.2,1.9 --seed 2 --out '" + in("side").toStdString() + "'"), 0);
  tracking::DepthCamera camera = tracking::loadDepthCamera(in("side/camera.yaml").toStdString());
  const Transform truth = camera.X_WC;
  camera.X_WC = truth * fromXyzRpy({0.06, -0.05, 0.06}, {0.1, -0.12, 0.06});
  folder.write("rough.yaml", tracking::describeDepthCamera(camera));
  CalibrationRequest request;
  request.mode = CalibrationMode::kRoom;
  request.clip = in("side");
  request.reference = in("front");
  request.camera = in("rough.yaml");
  ask(request);
  ASSERT_TRUE(answered());
  EXPECT_TRUE(cell("Agreement in the common view").endsWith("%")) << dialog->sentence()->text().toStdString();
  EXPECT_FALSE(cell("Distance from the first pose").isEmpty());
  saved();
  // The accuracy of the command's test.
  EXPECT_LT((poseIn(in("saved.yaml")).translation() - truth.translation()).norm(), 0.015);
}

TEST_F(StudioCalibration, PersonWhomAnotherCameraSees) {
  const std::string render = "render-depth --recording '" +
                             testing::projectFile("data/scenes/hug_reach.bvh").string() +
                             "' --body skin --width 320 --room --no-cache --look 0,0,0.9 --end 2 ";
  ASSERT_EQ(run(render + "--eye 2.8,0,1.4 --out '" + in("front").toStdString() + "'"), 0);
  ASSERT_EQ(run(render + "--eye 1.8,-2.2,1.4 --out '" + in("side").toStdString() + "'"), 0);
  CalibrationRequest request;
  request.mode = CalibrationMode::kPerson;
  request.clip = in("side");
  request.reference = in("front");
  ask(request);
  ASSERT_TRUE(answered());
  EXPECT_FALSE(cell("Way of the person").isEmpty()) << dialog->sentence()->text().toStdString();
  EXPECT_FALSE(cell("Offset of the clock").isEmpty());
  EXPECT_TRUE(dialog->sentence()->text().contains("record a walking person"))
      << "a person who stays at one place is warned of: " << dialog->sentence()->text().toStdString();
  saved();
  // The accuracy of the command's test, with a person who stays at one place.
  EXPECT_LT((poseIn(in("saved.yaml")).translation() - poseIn(in("side/camera.yaml")).translation()).norm(),
            0.15);
}

TEST_F(StudioCalibration, PathsAreTypedByKeyboard) {
  CalibrationRequest request;
  request.mode = CalibrationMode::kPoints;
  dialog->setRequest(request);
  ASSERT_FALSE(dialog->computeButton()->isEnabled());
  auto* points_field = dialog->findChild<QWidget*>("calibration_points");
  auto* camera_field = dialog->findChild<QWidget*>("calibration_camera");
  ASSERT_TRUE(points_field && camera_field);
  for (const auto& [field, name] :
       {std::pair{points_field, "points.csv"}, std::pair{camera_field, "kinect.yaml"}}) {
    field->setFocus();
    QWidget* taken = dialog->focusWidget();
    ASSERT_TRUE(taken);
    EXPECT_TRUE(field->isAncestorOf(taken)) << "the field passes the keyboard on to its line";
    QTest::keyClicks(taken, in(name));
  }
  EXPECT_EQ(dialog->request().clip, in("points.csv"));
  EXPECT_EQ(dialog->request().camera, in("kinect.yaml"));
  ASSERT_TRUE(dialog->computeButton()->isEnabled());
  QTest::keyClick(dialog->focusWidget(), Qt::Key_Return);
  EXPECT_TRUE(dialog->waiting()) << "the return key computes";
  ASSERT_TRUE(answered());
  EXPECT_TRUE(dialog->saveButton()->isEnabled());
}

TEST_F(StudioCalibration, RobotOfTheSceneIsChosen) {
  EXPECT_EQ(dialog->request().robot, "");
  const std::string robot = testing::projectFile("data/scenes/rail.mech").string();
  folder.write("arm.yaml",
               "abstand: 1\ndefaults: {voxel: 0.05, point: 0.05}\nmechanisms:\n"
               "  - name: rail\n    file: " +
                   robot +
                   "\n    links:\n"
                   "      - {name: rail/block, frame: 1, shape: {cuboid: {size: [0.5, 0.4, 0.3]}}}\n");
  ASSERT_TRUE(opens([&] { window.openFile(in("arm.yaml")); })) << problem;
  openDialog();
  CalibrationRequest request;
  request.mode = CalibrationMode::kLinks;
  request.robot = "rail";
  request.clip = in("clip");
  ASSERT_EQ(run("render-depth '" + in("arm.yaml").toStdString() + "' --out '" + in("clip").toStdString() +
                "' --width 320 --eye 1.9,0.4,0.9 --look 0,0,0 --no-cache --start 0 --end 0"),
            0);
  ask(request);
  ASSERT_TRUE(answered());
  EXPECT_EQ(dialog->request().robot, "rail");
  EXPECT_FALSE(cell("Visible surface of the robot that was found").isEmpty())
      << dialog->sentence()->text().toStdString();
  saved();
  const Transform found = tracking::loadDepthCamera(in("saved.yaml").toStdString()).X_WC;
  const Transform truth = tracking::loadDepthCamera(folder.path() / "clip" / "camera.yaml").X_WC;
  // One image of one block, with the noise of a Kinect at 2 m.
  EXPECT_LT((found.translation() - truth.translation()).norm(), 0.03);
}

TEST_F(StudioCalibration, ProblemIsThatOfTheCommand) {
  folder.write("line.csv", "cx,cy,cz,wx,wy,wz\n0,0,1,2,2,3\n0,0,2,3,2,3\n0,0,3,4,2,3\n");
  CalibrationRequest request = points();
  request.clip = in("line.csv");
  ask(request);
  ASSERT_TRUE(answered());
  EXPECT_TRUE(dialog->sentence()->text().contains("collinear")) << dialog->sentence()->text().toStdString();
  EXPECT_EQ(dialog->table()->rowCount(), 0);
  EXPECT_FALSE(dialog->saveButton()->isEnabled());
}

TEST_F(StudioCalibration, AnswerBelongsToItsFields) {
  ask(points());
  ASSERT_TRUE(answered());
  ASSERT_TRUE(dialog->saveButton()->isEnabled());
  CalibrationRequest other = points();
  other.clip = in("others.csv");
  dialog->setRequest(other);
  EXPECT_FALSE(dialog->saveButton()->isEnabled()) << "what was found is of another table";
  EXPECT_EQ(dialog->table()->rowCount(), 0);
}

TEST_F(StudioCalibration, StopAndCloseEndTheWork) {
  const QSignalSpy cancelled(&window.calibration(), &ui::CalibrationCommands::cancelled);
  ask(points());
  for (QPushButton* button : dialog->findChildren<QPushButton*>())
    if (button->text().remove('&') == "Stop") button->click();
  EXPECT_FALSE(dialog->waiting());
  EXPECT_EQ(cancelled.size(), 1);
  QTest::qWait(500);
  EXPECT_EQ(dialog->table()->rowCount(), 0) << "nothing comes after a stop";
  ask(points());
  dialog->close();
  EXPECT_EQ(cancelled.size(), 2);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  openDialog();
  EXPECT_EQ(dialog->request().clip, in("points.csv")) << "the last question is offered again";
}

TEST(CalibrationAnswer, DocumentWithoutPoseIsRefused) {
  EXPECT_THROW(calibrationOf("{}"), UsageError);
  EXPECT_THROW(calibrationOf("nothing"), UsageError);
  const ui::CalibrationAnswer answer = calibrationOf(
      R"({"T_WC": [1,0,0,7,0,1,0,8,0,0,1,9], "rms": 0.5, "spread": 2.0, "warnings": ["slow"], "clock": -0.25})");
  EXPECT_EQ(answer.xyz, Vector3d(7, 8, 9));
  EXPECT_EQ(answer.residual, 0.5);
  EXPECT_FALSE(answer.in_pixels);
  EXPECT_NEAR(answer.widening, 2.0 * humanmodel::kSpreadQuantile, 1e-12);
  ASSERT_EQ(answer.facts.size(), 1u);
  EXPECT_EQ(answer.facts[0].kind, ui::CalibrationFact::Kind::kClock);
  EXPECT_EQ(answer.facts[0].value, -0.25);
  EXPECT_EQ(answer.warnings, QStringList{"slow"});
}

}  // namespace studio_calibration_test
}  // namespace abstand::studio
