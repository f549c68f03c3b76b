// abstand calibrate, with every kind of reference.
#include "tests/app/program.hpp"
#include "tests/tracking/depth/calibration/board_picture.hpp"
#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/formats/colour_png.hpp"

namespace abstand::testing {
namespace cli_calibrate_test {

TEST_F(Cli, CalibrateByRoomSeenByTwoCameras) {
  const auto box = [](const char* name, const char* size, const char* p) {
    return std::string("  - {name: ") + name + ", shape: {cuboid: {size: [" + size + "]}}, pose: {xyz: [" +
           p + "]}}\n";
  };
  const std::string room =
      write("room.yaml",
            "abstand: 1\ndefaults: {voxel: 0.05, point: 0.05}\npairs: {default: none}\nobjects:\n" +
                box("floor", "8, 8, 0.1", "0, 0, -0.05") + box("wall", "0.1, 8, 3", "-1.85, 0, 1.5") +
                box("other", "8, 0.1, 3", "0, 1.85, 1.5") + box("bench", "0.7, 1.4, 0.9", "-1.3, 0.2, 0.45") +
                box("box", "0.4, 0.3, 0.5", "0, 1, 0.25"));
  const std::string render =
      "render-depth " + room + " --width 320 --start 0 --end 0.1 --no-cache --look -0.4,0.4,0.7 ";
  const std::string front = (folder_.path() / "front").string(), side = (folder_.path() / "side").string();
  ASSERT_EQ(run(render + "--eye 2.4,-0.6,1.6 --out " + front).code, 0);
  ASSERT_EQ(run(render + "--eye 1.0,-2.2,1.9 --seed 2 --out " + side).code, 0);
  tracking::DepthCamera camera = tracking::loadDepthCamera(side + "/camera.yaml");
  const Transform truth = camera.X_WC;
  camera.X_WC = truth * fromXyzRpy({0.06, -0.05, 0.06}, {0.1, -0.12, 0.06});
  const std::string rough = write("rough.yaml", tracking::describeDepthCamera(camera));
  const std::string placed = (folder_.path() / "placed.yaml").string();
  const std::string calibrate = "calibrate " + side + " --room " + front;
  const json j = runJson(calibrate + " --camera " + rough + " --out " + placed);
  const tracking::DepthCamera found = tracking::loadDepthCamera(placed);
  EXPECT_LT((found.X_WC.translation() - truth.translation()).norm(), 0.015) << j;
  EXPECT_LT(Quaterniond(found.X_WC.linear()).angularDistance(Quaterniond(truth.linear())), unit::deg(0.4));
  EXPECT_EQ(found.spread, j["spread"].get<double>());
  EXPECT_GT(j["agreeing"], 0.9);
  EXPECT_NEAR(j["moved"], std::sqrt(0.06 * 0.06 + 0.05 * 0.05 + 0.06 * 0.06), 0.015);
  EXPECT_EQ(j["T_WC"].size(), 12u);
  EXPECT_THAT(run(calibrate).out, ::testing::HasSubstr("agree on"));

  camera.X_WC = Transform::Identity();
  const std::string lens = write("lens.yaml", tracking::describeDepthCamera(camera));
  const Answer no_start = run(calibrate + " --camera " + lens);
  EXPECT_EQ(no_start.code, 2);
  EXPECT_THAT(no_start.err, ::testing::HasSubstr("without a camera pose"));
  // The camera looks elsewhere: refused, and nothing is written.
  camera.X_WC = truth * fromXyzRpy({0.0, 0.0, 0.0}, {0.0, 3.0, 0.0});
  const std::string wrong = write("wrong.yaml", tracking::describeDepthCamera(camera));
  const std::string none = (folder_.path() / "none.yaml").string();
  const Answer refused = run(calibrate + " --camera " + wrong + " --out " + none);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, ::testing::HasSubstr("--room: found "));
  EXPECT_FALSE(std::filesystem::exists(none));
  EXPECT_EQ(run(calibrate + " --person " + front).code, 2);
  EXPECT_EQ(run("calibrate --room " + front).code, 2);
  EXPECT_EQ(run("calibrate " + side + " --room nothing").code, 3);
}

// The walls of both images are those of one room, so that the pose of a camera follows from the other one.
TEST_F(Cli, RenderedRoomIsTheSameForAllCameras) {
  const std::string clip = (folder_.path() / "clip").string();
  const std::string render = "render-depth --recording " + projectFile("data/scenes/hug_reach.bvh").string() +
                             " --room --width 320 --end 0 --out " + clip + " --look 0,0,0.9 ";
  ASSERT_EQ(run(render + "--eye 2.4,-0.6,1.6 --eye 1.4,-2.2,1.9").code, 0);
  const json j = runJson("calibrate " + clip + "/camera_2 --room " + clip + "/camera_1");
  EXPECT_GT(j["agreeing"], 0.9);
  EXPECT_LT(j["moved"], 0.02) << "m; the pose was right";
  const std::string camera = clip + "/camera_1/camera.yaml";
  const Answer same =
      run("render-depth --recording data/scenes/hug_reach.bvh --out x --eye 2,0,1 --look 0,0,1 --camera " +
          camera + "," + camera);
  EXPECT_EQ(same.code, 2);
  EXPECT_THAT(same.err, ::testing::HasSubstr("one place"));
}

TEST_F(Cli, CalibrateByPersonSeenByTwoCameras) {
  constexpr double kPlaced = 0.15;  // m, by a person who stays at one place
  const std::string render = "render-depth --recording " + projectFile("data/scenes/hug_reach.bvh").string() +
                             " --body skin --width 320 --room --no-cache --look 0,0,0.9 ";
  const std::string front = (folder_.path() / "front").string(), side = (folder_.path() / "side").string();
  ASSERT_EQ(run(render + "--end 3 --eye 2.8,0,1.4 --out " + front).code, 0);
  ASSERT_EQ(run(render + "--end 3 --eye 1.8,-2.2,1.4 --out " + side).code, 0);
  const std::string placed = (folder_.path() / "placed.yaml").string();
  const json j = runJson("calibrate " + side + " --person " + front + " --out " + placed);
  const Transform X_WC = tracking::loadDepthCamera(placed).X_WC;
  const Transform truth = tracking::loadDepthCamera(side + "/camera.yaml").X_WC;
  EXPECT_LT((X_WC.translation() - truth.translation()).norm(), kPlaced);
  EXPECT_NEAR(tracking::loadDepthCamera(placed).spread, j["spread"].get<double>(), 1e-6);
  EXPECT_GT(j["used"], 500);
  EXPECT_EQ(j["exchanged"], false);
  EXPECT_THAT(j["warnings"].dump(), ::testing::HasSubstr("record a walking person"));
  // What is refused, and why.
  const std::string brief = (folder_.path() / "brief").string();
  ASSERT_EQ(run(render + "--end 0.6 --eye 2.8,0,1.4 --out " + brief).code, 0);
  EXPECT_THAT(run("calibrate " + brief + " --person " + front).err,
              ::testing::HasSubstr("less than a second"));
  EXPECT_EQ(run("calibrate " + side + " --person " + front + " --links " + front).code, 2);
  EXPECT_EQ(run("calibrate --person " + front).code, 2);
  EXPECT_EQ(run("calibrate " + side + " --person nothing.csv").code, 3);
}

TEST_F(Cli, CalibrateFindsCameraPoseFromPoints) {
  const std::string camera = write(
      "kinect.yaml", "width: 640\nheight: 480\nfx: 580\nfy: 580\ncx: 319.5\ncy: 239.5\ndepth_scale: 1000\n");
  // The camera looks along world x from (1, 2, 3): its z is x, its x is -y, its y is -z.
  const std::string points =
      write("points.csv", "cx,cy,cz,wx,wy,wz\n0,0,1,2,2,3\n1,0,1,2,1,3\n0,1,1,2,2,2\n0,0,2,3,2,3.001\n");
  const std::string placed = (folder_.path() / "placed.yaml").string();
  const json j = runJson("calibrate " + points + " --camera " + camera + " --out " + placed);
  EXPECT_EQ(j["points"], 4);
  EXPECT_LT(j["rms"].get<double>(), 1e-3);
  EXPECT_GT(j["spread"].get<double>(), 0.0);
  EXPECT_NEAR(j["T_WC"][3].get<double>(), 1.0, 2e-3);
  EXPECT_NEAR(j["T_WC"][2].get<double>(), 1.0, 2e-3);
  EXPECT_NE(readFile(placed).find("spread:"), std::string::npos);
  EXPECT_EQ(run("calibrate " + points + " --camera none.yaml").code, 3);
  EXPECT_EQ(run("calibrate " + camera + " --camera " + camera).code, 3);
  EXPECT_EQ(run("calibrate " + points).code, 2);
  EXPECT_EQ(run("calibrate " + placed + "x --camera " + placed).code, 3);
}

/// As an infrared camera's image.
void save(const tracking::GreyImage& grey, const std::filesystem::path& file) {
  tracking::ColourImage image(grey.width, grey.height);
  for (std::size_t i = 0; i < grey.pixels.size(); ++i) image.pixels[i].fill(grey.pixels[i]);
  tracking::saveColourPng(image, file);
}

TEST_F(Cli, CalibrateByAChessboard) {
  const tracking::Chessboard board{8, 5, 0.03};
  const Transform X_WO = fromXyzRpy({0.4, -0.2, 0.75}, {0.0, 0.0, 0.5});
  const tracking::DepthCamera truth = cameraBefore(board, X_WO, 0.7, 0.5, 0.3, 0.2);
  const auto image = folder_.path() / "board.png", placed = folder_.path() / "placed.yaml";
  save(pictureOf(truth, board, X_WO), image);
  const std::string camera = write("kinect.yaml", tracking::describeDepthCamera(tracking::DepthCamera{}));
  const std::string chessboard = "calibrate --chessboard " + image.string();
  const std::string lens = " --camera " + camera, place = " --square 0.03 --board 0.4,-0.2,0.75,0,0,0.5";
  const json j = runJson(chessboard + " --squares 8x5" + place + lens + " --out " + placed.string());
  EXPECT_EQ(j["corners"], 28);
  EXPECT_LT(j["rms_px"].get<double>(), 0.2);
  const tracking::DepthCamera found = tracking::loadDepthCamera(placed);
  EXPECT_LT((found.X_WC.translation() - truth.X_WC.translation()).norm(), 0.003);
  EXPECT_EQ(found.spread, j["spread"].get<double>());
  // Inner corners instead of squares.
  const Answer corners = run(chessboard + " --squares 7x4" + place + lens);
  EXPECT_EQ(corners.code, 3);
  EXPECT_NE(corners.err.find("counts squares, not inner corners"), std::string::npos) << corners.err;
  for (const std::string& bad : std::vector<std::string>{
           " --squares 8x5 --square 0.03" + lens, " --squares 8x8" + place + lens,
           " --squares 8" + place + lens, " --squares 8x5" + place,
           " --squares 8x5" + place + " --intrinsics", " --squares 8x5" + place + " --board 0,0,0" + lens,
           " --squares 8x5 --square 0.03 --board 1,2" + lens,
           " --squares 8x5 --square 0 --board 0,0,0" + lens})
    EXPECT_EQ(run(chessboard + bad).code, 2) << bad;
  EXPECT_EQ(run("calibrate --chessboard " + camera + " --squares 8x5" + place + lens).code, 3);
  const std::string small =
      write("small.yaml", "width: 320\nheight: 240\nfx: 290\nfy: 290\ncx: 160\ncy: 120\ndepth_scale: 1000\n");
  EXPECT_EQ(run(chessboard + " --squares 8x5" + place + " --camera " + small).code, 3);
  EXPECT_EQ(run("calibrate points.csv --squares 8x5 --camera " + camera).code, 2);
}

TEST_F(Cli, CalibrateMeasuresTheLens) {
  const tracking::Chessboard board{8, 5, 0.03};
  const Transform X_WO = fromXyzRpy({0.4, -0.2, 0.75}, {0.0, 0.0, 0.5});
  std::string images;
  tracking::DepthCamera first;
  for (int i = 0; i < 5; ++i) {
    const tracking::DepthCamera camera = cameraBefore(board, X_WO, 0.5, 0.6, 1.3 * i, 0.4 * i);
    if (i == 0) first = camera;
    const auto file = folder_.path() / ("board" + std::to_string(i) + ".png");
    save(pictureOf(camera, board, X_WO), file);
    images += " " + file.string();
  }
  const auto placed = folder_.path() / "placed.yaml";
  const json j = runJson("calibrate --chessboard" + images +
                         " --squares 8x5 --square 0.03 --board 0.4,-0.2,0.75,0,0,0.5 --intrinsics --out " +
                         placed.string());
  EXPECT_NEAR(j["intrinsics"]["fx"].get<double>(), 580.0, 6.0);
  const tracking::DepthCamera found = tracking::loadDepthCamera(placed);
  EXPECT_EQ(found.fx, j["intrinsics"]["fx"].get<double>());
  // A lens that is a hundredth off puts the camera a hundredth of its distance off.
  EXPECT_LT((found.X_WC.translation() - first.X_WC.translation()).norm(), 0.01);
}

TEST_F(Cli, CalibrateByRobotLinks) {
  const std::string clip = (folder_.path() / "clip").string(), scene = "data/scenes/arm6.yaml";
  runJson("render-depth " + scene + " --out " + clip +
          " --end 0 --width 320 --eye 1.6,0.6,0.9 --look 0.1,0,0.4");
  const tracking::DepthCamera truth = tracking::loadDepthCamera(folder_.path() / "clip" / "camera.yaml");
  tracking::DepthCamera start = truth;
  start.X_WC = truth.X_WC * fromXyzRpy({0.05, -0.06, 0.05}, {0.08, -0.1, 0.06});
  const std::string rough = write("rough.yaml", tracking::describeDepthCamera(start));
  const auto placed = folder_.path() / "placed.yaml";
  const std::string calibrate = "calibrate " + scene + " --links " + clip;
  const json j = runJson(calibrate + " --robot arm6 --camera " + rough + " --out " + placed.string());
  EXPECT_EQ(j["robot"], "arm6");
  EXPECT_EQ(j["images"], 1);
  EXPECT_GT(j["explained"].get<double>(), 0.9);
  const tracking::DepthCamera found = tracking::loadDepthCamera(placed);
  // A tenth of the way that it was off, and less than a step of the Kinect's depth.
  EXPECT_LT((found.X_WC.translation() - truth.X_WC.translation()).norm(), 0.008);
  EXPECT_EQ(found.spread, j["spread"].get<double>());
  EXPECT_NEAR(j["moved"].get<double>(), std::sqrt(0.0086), 0.008);
  tracking::DepthCamera unplaced = truth;
  unplaced.X_WC = Transform::Identity();
  const std::string nowhere =
      write("nowhere.yaml", tracking::describeDepthCamera(unplaced).substr(
                                0, tracking::describeDepthCamera(unplaced).find("T_WC")));
  for (const std::string& bad :
       std::vector<std::string>{calibrate + " --robot nobody", calibrate + " --camera " + nowhere,
                                "calibrate " + scene + " --robot arm6", "calibrate --links " + clip,
                                calibrate + " --chessboard a.png"})
    EXPECT_EQ(run(bad).code, 2) << bad;
  EXPECT_EQ(run("calibrate " + scene + " --links data/scenes").code, 3);
  EXPECT_EQ(run("calibrate data/scenes/arm6.yaml --camera " + rough).code, 3);
}

}  // namespace cli_calibrate_test
}  // namespace abstand::testing
