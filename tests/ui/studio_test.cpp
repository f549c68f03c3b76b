// The desktop program as a script uses it: one picture, and an end with a code that says what was wrong.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>

#include "core/base/text_file.hpp"
#include "tests/app/tune/slide_scene.hpp"
#include "tests/support/paths.hpp"

namespace abstand::ui {
namespace studio_test {

namespace fs = std::filesystem;

struct StudioProgram : ::testing::Test {
  struct Answer {
    int code;
    std::string err;
  };
  StudioProgram() {
    folder.write("scene.yaml",
                 "abstand: 1\ndefaults: {voxel: 0.1, point: 0.1}\nobjects:\n"
                 "  - {name: wall, shape: {cuboid: {size: [0.2, 1, 1]}}, pose: {xyz: [-0.5, 0, 0]}}\n");
  }
  /// In the folder, with settings and structures of its own.
  Answer run(const std::string& arguments) {
    const auto err = in("stderr");
    const int status =
        std::system(("cd '" + folder.path().string() + "' && HOME='" + folder.path().string() +
                     "' XDG_CONFIG_HOME='" + in("config").string() + "' timeout 100 '" ABSTAND_STUDIO "' " +
                     arguments + " 2>'" + err.string() + "'")
                        .c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readFile(err, 1 << 20, true)};
  }
  fs::path in(const std::string& name) const { return folder.path() / name; }
  testing::ScratchFolder folder;
};

TEST_F(StudioProgram, ProbePrintsFigures) {
  const Answer good = run("scene.yaml --size 500x400 --probe 0.5 >probe.json");
  ASSERT_EQ(good.code, 0) << good.err;
  const QJsonObject figures =
      QJsonDocument::fromJson(QByteArray::fromStdString(readFile(in("probe.json")))).object();
  EXPECT_TRUE(figures.contains("pictures_per_second")) << "nothing moves in this scene";
  EXPECT_GT(figures["processor_ms_per_picture"].toObject()["gui"].toDouble(), 0.0);
  EXPECT_GT(figures["processor_ms_per_picture"].toObject()["loop"].toDouble(), 0.0);
  EXPECT_TRUE(figures.contains("cycle_us"));
  EXPECT_TRUE(figures["stalls_playing"].toObject().contains("above_50_ms"));
  EXPECT_GT(figures["resident_mb"].toObject()["end"].toDouble(), 0.0);
  EXPECT_GT(figures["first_picture_s"].toDouble(), 0.0);
  const QJsonObject response = figures["response"].toObject();
  EXPECT_EQ(response["not_shown"].toInt(-1), 0);
  EXPECT_FALSE(response.contains("seek_ms")) << "nothing moves in this scene";
  EXPECT_EQ(run("--probe 1").code, 2);
}

TEST_F(StudioProgram, ProbeAsksForMomentsAndMargins) {
  testing::writeSlide(folder, {.seconds = 1.0});
  const Answer good = run("slide.yaml --size 1000x800 --probe 0.2 >probe.json");
  ASSERT_EQ(good.code, 0) << good.err;
  const QJsonObject figures =
      QJsonDocument::fromJson(QByteArray::fromStdString(readFile(in("probe.json")))).object();
  const QJsonObject response = figures["response"].toObject();
  EXPECT_EQ(response["not_shown"].toInt(-1), 0);
  for (const char* what : {"seek_ms", "margin_ms"}) {
    const QJsonObject times = response[what].toObject();
    EXPECT_GT(times["median"].toDouble(), 0.0) << what;
    EXPECT_LE(times["median"].toDouble(), times["p99"].toDouble()) << what;
    EXPECT_LE(times["p99"].toDouble(), times["max"].toDouble()) << what;
  }
}

TEST_F(StudioProgram, SoakMeasuresMemoryWhileItWorks) {
  testing::writeSlide(folder, {.seconds = 1.0});
  const Answer good = run("slide.yaml --size 1000x800 --soak 4 >soak.json");
  ASSERT_EQ(good.code, 0) << good.err;
  const QJsonObject figures =
      QJsonDocument::fromJson(QByteArray::fromStdString(readFile(in("soak.json")))).object();
  EXPECT_GT(figures["frames"].toInt(), 0);
  EXPECT_GT(figures["commands"].toInt(), 0);
  EXPECT_EQ(figures["openings"].toInt(), 1);
  const QJsonArray over_time = figures["t_s_resident_mb_allocated_mb"].toArray();
  ASSERT_GT(over_time.size(), 2);
  const QJsonArray last = over_time.last().toArray();
  EXPECT_GT(last[1].toDouble(), 1.0);
  EXPECT_GT(last[1].toDouble(), last[2].toDouble()) << "what is allocated is part of what is resident";
  EXPECT_TRUE(figures["resident_mb_per_hour"].isDouble());
  EXPECT_EQ(run("--soak 1").code, 2);
}

TEST_F(StudioProgram, UsesRequestedLanguage) {
  EXPECT_EQ(run("--help --language de >help").code, 0);
  EXPECT_NE(readFile(in("help")).find("Sprache der Texte"), std::string::npos);
  EXPECT_EQ(run("--help --language=en >help").code, 0);
  EXPECT_NE(readFile(in("help")).find("language of texts"), std::string::npos);
  const Answer wrong = run("--language fr");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_NE(wrong.err.find("--language: found 'fr', expected system, en or de"), std::string::npos)
      << wrong.err;
}

TEST_F(StudioProgram, ScreenshotFollowsOutputRules) {
  fs::create_symlink("target.png", in("link.png"));
  const Answer good = run("scene.yaml --size 400x300 --screenshot link.png");
  EXPECT_EQ(good.code, 0) << good.err;
  EXPECT_TRUE(fs::is_symlink(in("link.png")));
  EXPECT_FALSE(QImage(QString::fromStdString(in("target.png").string())).isNull());

  const std::string scene = readFile(in("scene.yaml"));
  fs::create_symlink("scene.yaml", in("scene.png"));
  const Answer input = run("scene.yaml --screenshot scene.png");
  EXPECT_EQ(input.code, 2);
  EXPECT_NE(input.err.find("scene.png: found a file that is also an input"), std::string::npos) << input.err;
  EXPECT_EQ(readFile(in("scene.yaml")), scene);

  fs::create_symlink("/dev/full", in("full.png"));
  EXPECT_EQ(run("scene.yaml --screenshot full.png").code, 4);
  fs::create_directory(in("folder.png"));
  const Answer folder_name = run("none.yaml --screenshot folder.png");
  EXPECT_EQ(folder_name.code, 2) << "before the scene is opened: " << folder_name.err;
}

TEST_F(StudioProgram, FindsRobotsInPackages) {
  fs::create_directories(in("ros/pkg/meshes"));
  folder.write("ros/pkg/package.xml", "<package><name>pkg</name></package>");
  folder.write("ros/pkg/meshes/a.obj",
               "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  folder.write(
      "r.urdf",
      "<robot name='r'><link name='a'><collision><geometry><mesh filename='package://pkg/meshes/a.obj'/>"
      "</geometry></collision></link></robot>");
  folder.write(
      "robot.yaml",
      "abstand: 1\ndefaults: {voxel: 0.05, point: 0.05}\nmechanisms:\n  - {name: m, file: r.urdf}\n");
  const Answer nowhere = run("robot.yaml --screenshot a.png");
  EXPECT_EQ(nowhere.code, 3);
  EXPECT_NE(nowhere.err.find("package://pkg/meshes/a.obj"), std::string::npos) << nowhere.err;
  const Answer found = run("robot.yaml --package-path none --package-path ros --screenshot a.png");
  EXPECT_EQ(found.code, 0) << found.err;
  EXPECT_TRUE(fs::exists(in("a.png")));
}

TEST_F(StudioProgram, RecordingAloneOpensAndSceneNeedsPerson) {
  folder.write("p.csv", "t,pelvis.x,pelvis.y,pelvis.z,neck.x,neck.y,neck.z\n0,0,0,1,0,0,1.5\n");
  const Answer alone = run("p.csv --screenshot alone.png");
  EXPECT_EQ(alone.code, 0) << alone.err;
  const Answer nobody = run("scene.yaml --recording p.csv --screenshot a.png");
  EXPECT_EQ(nobody.code, 3);
  EXPECT_NE(nobody.err.find("found no person"), std::string::npos) << nobody.err;
  EXPECT_FALSE(fs::exists(in("a.png")));
}

TEST_F(StudioProgram, OpensProject) {
  folder.write("p.abstand", "{\"abstand_project\": 1, \"scene\": \"scene.yaml\"}\n");
  const Answer good = run("p.abstand --screenshot a.png");
  EXPECT_EQ(good.code, 0) << good.err;
  folder.write("lost.abstand", "{\"abstand_project\": 1, \"scene\": \"gone.yaml\"}\n");
  const Answer lost = run("lost.abstand --screenshot b.png");
  EXPECT_EQ(lost.code, 3);
  EXPECT_NE(lost.err.find("gone.yaml"), std::string::npos) << lost.err;
  folder.write("bad.abstand", "{\"abstand_project\": 7}\n");
  EXPECT_EQ(run("bad.abstand --screenshot b.png").code, 3);
  EXPECT_FALSE(fs::exists(in("b.png")));
}

TEST_F(StudioProgram, VersionAndHelpNeedNoDisplay) {
  for (const char* option : {"--version", "--help"}) {
    const int status =
        std::system((std::string("env -u DISPLAY -u WAYLAND_DISPLAY timeout 100 '" ABSTAND_STUDIO "' ") +
                     option + " >/dev/null 2>&1")
                        .c_str());
    EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 0) << option;
  }
}

}  // namespace studio_test
}  // namespace abstand::ui
