// "Open a live depth camera" in the window: fakenect plays a recording at its own rate through the driver's
// interface.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <QAction>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/ui/studio_window.hpp"
#include "ui/live_camera_commands.hpp"
#include "ui/model/pair_level.hpp"
#include "ui/panels/live_camera_dialog.hpp"
#include "ui/style/actions.hpp"

namespace abstand::studio {
namespace studio_camera_test {

constexpr int kLimitMs = 60000;  // nothing takes so long
constexpr int kRounds = 60;      // of 3 s: three such waits
constexpr int kImagesPerSecond = 15;
constexpr double kPersonMoves = 0.1;  // m, of a hand within the clip

bool hasFakenect() { return std::string(ABSTAND_FAKENECT).size() > 0; }

struct StudioCamera : StudioWindow {
  StudioCamera() {
    folder.write(
        "visit.yaml",
        "abstand: 1\ndefaults: {voxel: 0.02, point: 0.02}\nhumans:\n  - {name: visitor, height: 1.75}\n"
        "objects:\n"
        "  - {name: plate, shape: {cuboid: {size: [0.5, 0.5, 0.1]}}, pose: {xyz: [-1.5, 0, 0.5]}}\n");
    qputenv("PATH",
            std::filesystem::path(ABSTAND_PROGRAM).parent_path().string().c_str() + (":" + qgetenv("PATH")));
    qputenv("ABSTAND_CACHE", (folder.path() / "cache").c_str());
  }
  ~StudioCamera() override {
    qunsetenv("FAKENECT_PATH");
    qunsetenv("LD_LIBRARY_PATH");
  }
  /// Of somebody who reaches, for cameras at these places.
  void render(const std::string& places, const char* into) {
    folder.write(
        "shown.yaml",
        "abstand: 1\ndefaults: {voxel: 0.02, point: 0.02}\nhumans:\n  - {name: visitor, height: 1.75}\n");
    const std::string command =
        "'" ABSTAND_PROGRAM "' render-depth '" + in("shown.yaml").toStdString() + "' --recording '" +
        testing::projectFile("data/scenes/hug_reach.bvh").string() +
        "' --format freenect --body skin --room --rate " + std::to_string(kImagesPerSecond) +
        " --end 3 --quiet " + places + " --out '" + in(into).toStdString() + "'";
    ASSERT_EQ(WEXITSTATUS(std::system(command.c_str())), 0);
  }
  void plugIn() {
    render("", "dump");
    // The driver says how its fake is found: by the loader's path, under the true library's name.
    qputenv("FAKENECT_PATH", in("dump").toUtf8());
    qputenv("LD_LIBRARY_PATH", std::filesystem::path(ABSTAND_FAKENECT).parent_path().c_str());
  }
  /// Plays the recording backwards and forwards that many times more, so that the camera stays connected for
  /// as long as a busy machine needs. The images are linked, not copied.
  void prolong(const char* clip, int times) {
    const std::filesystem::path dump = folder.path() / clip;
    std::vector<std::string> names;
    std::ifstream index(dump / "INDEX.txt");
    for (std::string name; index >> name;) names.push_back(name);
    ASSERT_GT(names.size(), 1u);
    std::ofstream more(dump / "INDEX.txt", std::ios::app);
    const std::size_t last = names.size() - 1;
    for (std::size_t i = last + 1; i < (static_cast<std::size_t>(times) + 1) * last; ++i) {
      const std::size_t forth = i % (2 * last);
      const double t = static_cast<double>(i) / kImagesPerSecond;
      char name[80];
      std::snprintf(name, sizeof name, "d-%.6f-%.0f.pgm", t, 1e6 * t);
      std::filesystem::create_hard_link(dump / names[std::min(forth, 2 * last - forth)], dump / name);
      more << name << '\n';
    }
  }
  void openDialog() {
    window.actions()[ui::ActionId::kLiveCamera]->trigger();
    dialog = window.liveCamera().dialog();
    ASSERT_TRUE(dialog);
  }
  ui::LiveCameraRequest request() const {
    return {in("visit.yaml"), in("dump/camera.yaml"), QStringLiteral("visitor"), 1.75, false};
  }
  bool starts() {
    dialog->setRequest(request(), {});
    if (!dialog->startButton()->isEnabled()) return false;
    return opens([this] { dialog->startButton()->click(); });
  }
  /// Of the person in the window; nullopt: it is not known where it is.
  std::optional<Vector3d> seen(std::size_t part) const {
    const auto& objects = window.moment().objects;
    if (part >= objects.size() || objects[part].pose_state != scene::PoseState::kFresh) return {};
    return objects[part].X_WB.translation();
  }
  /// Of a program that this one has started and that has the word in its command line; 0: none.
  static pid_t processOf(const std::string& word) {
    const std::string own = std::to_string(QCoreApplication::applicationPid());
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      std::string stat, line;
      std::getline(std::ifstream(entry.path() / "stat"), stat);
      std::getline(std::ifstream(entry.path() / "cmdline"), line);
      // proc(5): "pid (name) state ppid ...".
      std::istringstream rest(stat.substr(std::min(stat.size(), stat.rfind(')') + 1)));
      std::string state, parent;
      if (rest >> state >> parent && parent == own && line.find(word) != std::string::npos)
        return std::stoi(entry.path().filename());
    }
    return 0;
  }
  static bool isRunning(const std::string& word) { return processOf(word) != 0; }
  /// Of the dialog; it is deleted when it is closed.
  bool answered() {
    return QTest::qWaitFor([&] { return !window.liveCamera().dialog() || !dialog->waiting(); }, kLimitMs);
  }

  ui::LiveCameraDialog* dialog{nullptr};
};

TEST_F(StudioCamera, PersonMovesInTheWindow) {
  if (!hasFakenect()) GTEST_SKIP() << "libfreenect0.5, which has fakenect";
  plugIn();
  openDialog();
  ASSERT_TRUE(starts()) << problem
                        << (window.liveCamera().dialog() ? dialog->sentence()->text().toStdString() : "");
  EXPECT_FALSE(window.liveCamera().dialog() && window.liveCamera().dialog()->isVisible());
  EXPECT_EQ(work().scene, in("visit.yaml"));
  ASSERT_TRUE(window.moment().objects.size() > 2);
  const std::size_t parts = window.moment().objects.size() - 1;  // the last object is the plate
  // Each part's way while it is known where it is: the farthest of them moves as the hands of the recording
  // do.
  std::vector<std::optional<Vector3d>> first(parts);
  double way = 0.0;
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        for (std::size_t i = 0; i < parts; ++i)
          if (const auto at = seen(i)) {
            if (!first[i]) first[i] = at;
            way = std::max(way, (*at - *first[i]).norm());
          }
        return way > kPersonMoves;
      },
      kLimitMs))
      << way;
  // The person of the recording stands at the origin.
  const auto pelvis = std::find_if(first.begin(), first.end(), [](const auto& p) { return p.has_value(); });
  ASSERT_NE(pelvis, first.end());
  EXPECT_LT((*pelvis)->head<2>().norm(), 1.5);

  // The recording ends: the camera was unplugged. That is said, and nothing of the person counts as known.
  QMessageBox* said = nullptr;
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return (said = window.findChild<QMessageBox*>()) != nullptr; }, kLimitMs));
  EXPECT_TRUE(said->text().contains("found the camera disconnected")) << said->text().toStdString();
  said->close();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        for (std::size_t i = 0; i < parts; ++i)
          if (!scene::isPoseLost(window.moment().objects[i].pose_state)) return false;
        return true;
      },
      kLimitMs));
  // Another scene ends the server.
  EXPECT_TRUE(isRunning("serve"));
  ASSERT_TRUE(opens([&] { window.openFile(in("scene.yaml")); })) << problem;
  EXPECT_FALSE(isRunning("serve"));
}

TEST_F(StudioCamera, RobotsStandStillOnlyIfTheUserSaysSo) {
  if (!hasFakenect()) GTEST_SKIP() << "libfreenect0.5, which has fakenect";
  plugIn();
  prolong("dump", kRounds);
  folder.write("slide.mech", "chain\n    frame   1   0      0          d    0\nend_chain\n");
  folder.write(
      "robot.yaml",
      "abstand: 1\ndefaults: {voxel: 0.02, point: 0.02}\npairs: {default: between_groups, within_people: "
      "exclude}\nmechanisms:\n  - name: slide\n    file: slide.mech\n"
      "    base: {xyz: [-4, 0, 0]}\n    reaction: {stop: {distance: 0.02}}\n    links: [{name: ball, "
      "frame: 1, shape: {sphere: {radius: 0.1}}}]\n"
      "humans:\n  - {name: visitor, height: 1.75}\n");
  const auto ball = [&] { return window.moment().objects.at(0); };
  // Each part of the person has a pair with the ball, in their order.
  const auto isKnown = [&] {
    const view::SceneSnapshot& now = window.moment();
    for (std::size_t k = 0; k < now.pairs.size(); ++k) {
      const ui::PairLevel level = ui::pairLevel(now, now.pairs[k], {0, static_cast<int>(k) + 1});
      if (level != ui::PairLevel::kLost && level != ui::PairLevel::kUnknown) return true;
    }
    return false;
  };
  const auto state = [&] { return window.moment().robots.at(0).state; };
  QAction* reset = window.actions()[ui::ActionId::kResetStops];
  for (const bool still : {false, true}) {
    openDialog();
    ui::LiveCameraRequest wanted = request();
    wanted.scene = in("robot.yaml");
    wanted.still = still;
    dialog->setRequest(wanted, {});
    ASSERT_TRUE(opens([this] { dialog->startButton()->click(); })) << problem;
    if (still) {
      // The server may count the robot as lost for a moment where the machine is busy.
      EXPECT_TRUE(QTest::qWaitFor([&] { return isKnown(); }, kLimitMs)) << "the person comes to be seen";
      EXPECT_NEAR(ball().X_WB.translation().x(), -4.0, 1e-9);
      // The tracker hangs: the robot stops, and it goes on only after a reset.
      const pid_t tracker = processOf("live:kinect");
      ASSERT_GT(tracker, 0);
      ASSERT_EQ(::kill(tracker, SIGSTOP), 0);
      EXPECT_TRUE(QTest::qWaitFor([&] { return state() == safety::StopState::kWaitingForReset; }, kLimitMs));
      ASSERT_EQ(::kill(tracker, SIGCONT), 0);
      ASSERT_TRUE(reset->isEnabled());
      EXPECT_TRUE(QTest::qWaitFor(
          [&] {
            reset->trigger();
            return state() == safety::StopState::kRunning;
          },
          kLimitMs));
    } else {
      EXPECT_TRUE(QTest::qWaitFor([&] { return seen(1).has_value(); }, kLimitMs)) << "a part of the person";
      EXPECT_TRUE(scene::isPoseLost(ball().pose_state));
      EXPECT_EQ(window.moment().pairs.size() + 1, window.moment().objects.size());
      EXPECT_FALSE(reset->isEnabled()) << "this window does not speak for the robot";
      EXPECT_FALSE(isKnown()) << "no pair counts as apart while the robot may be anywhere";
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
}

TEST_F(StudioCamera, SecondCameraGoesOnWhereTheFirstIsUnplugged) {
  if (std::string(ABSTAND_FAKE_KINECTS).empty()) GTEST_SKIP() << "libfreenect.h";
  render("--eye 2.8,0,1.4 --eye 0,-2.8,1.4 --look 0,0,0.9", "clips");
  // The first camera goes after a second.
  prolong("clips/camera_2", kRounds);
  const std::filesystem::path clips = folder.path() / "clips";
  std::ifstream index(clips / "camera_1/INDEX.txt");
  std::string few;
  std::string name;
  for (int i = 0; i < kImagesPerSecond && index >> name; ++i) few += name + "\n";
  index.close();
  std::ofstream(clips / "camera_1/INDEX.txt") << few;
  qputenv("FAKE_KINECT",
          ("play:" + (clips / "camera_1").string() + ",play:" + (clips / "camera_2").string()).c_str());
  qputenv("LD_LIBRARY_PATH", std::filesystem::path(ABSTAND_FAKE_KINECTS).parent_path().c_str());
  openDialog();
  ui::LiveCameraRequest wanted = request();
  wanted.camera = in("clips/camera_1/camera.yaml");
  wanted.second = in("clips/camera_2/camera.yaml");
  dialog->setRequest(wanted, {});
  EXPECT_EQ(dialog->request().second, wanted.second);
  ASSERT_TRUE(opens([this] { dialog->startButton()->click(); }))
      << problem << (window.liveCamera().dialog() ? dialog->sentence()->text().toStdString() : "");
  QStringList said;
  const auto hasSaid = [&](const char* camera) {
    for (QMessageBox* box : window.findChildren<QMessageBox*>()) {
      said << box->text();
      box->close();
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return !said.filter(QLatin1String(camera)).isEmpty();
  };
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return hasSaid("live:kinect: found the camera disconnected"); }, kLimitMs))
      << said.join('|').toStdString();
  EXPECT_TRUE(QTest::qWaitFor([&] { return seen(1).has_value(); }, kLimitMs)) << "by the second camera";
  qunsetenv("FAKE_KINECT");
}

TEST_F(StudioCamera, WithoutCameraTheReasonIsOneLine) {
  folder.write("nobody.yaml",
               "width: 640\nheight: 480\nfx: 580\nfy: 580\ncx: 319.5\ncy: 239.5\n"
               "depth_scale: 1000\nT_WC: {xyz: [3, 0, 1], rpy: [-1.5708, 0, 1.5708]}\n");
  openDialog();
  EXPECT_FALSE(dialog->startButton()->isEnabled()) << "without a camera file";
  ui::LiveCameraRequest wanted = request();
  wanted.camera = in("nobody.yaml");
  dialog->setRequest(wanted, {});
  dialog->startButton()->click();
  ASSERT_TRUE(dialog->waiting());
  ASSERT_TRUE(answered());
  ASSERT_TRUE(window.liveCamera().dialog()) << "a camera is connected to this computer";
  const QString sentence = dialog->sentence()->text();
  EXPECT_TRUE(sentence.startsWith("live:kinect: error: found no ")) << sentence.toStdString();
  EXPECT_FALSE(sentence.contains('\n'));
  EXPECT_FALSE(isRunning("serve"));
  EXPECT_TRUE(dialog->startButton()->isEnabled()) << "it can be tried again";
  // A scene that cannot be read is said by the server.
  wanted.scene = in("nothing.yaml");
  dialog->setRequest(wanted, {});
  dialog->startButton()->click();
  ASSERT_TRUE(answered());
  EXPECT_TRUE(dialog->sentence()->text().contains("nothing.yaml"))
      << dialog->sentence()->text().toStdString();
}

TEST_F(StudioCamera, ClosingTheDialogStops) {
  openDialog();
  dialog->setRequest(request(), {});
  dialog->startButton()->click();
  EXPECT_TRUE(QTest::qWaitFor([] { return isRunning("serve"); }, kLimitMs));
  dialog->close();
  EXPECT_FALSE(isRunning("serve"));
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  openDialog();
  EXPECT_EQ(dialog->request().person, "visitor") << "the last question is offered again";
}

}  // namespace studio_camera_test
}  // namespace abstand::studio
