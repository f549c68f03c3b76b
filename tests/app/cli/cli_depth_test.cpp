// The contract of the commands about depth images.
#include "tests/app/program.hpp"
#include "tracking/depth/formats/depth_stream.hpp"

namespace abstand::testing {
namespace cli_depth_test {

TEST_F(Cli, RenderDepthWritesAClip) {
  const std::string clip = (folder_.path() / "clip").string();
  const std::string scene =
      write("ball.yaml",
            "abstand: 1\nobjects:\n  - {name: a, shape: {sphere: {radius: 0.2}}, voxel: "
            "0.02, point: 0.02}\n  - {name: b, shape: {sphere: {radius: 0.2}}, voxel: 0.02, "
            "point: 0.02, pose: {xyz: [0, 1, 0]}}\npairs: {default: all}\n");
  const json j = runJson("render-depth " + scene + " --out " + clip +
                         " --noise none --width 320 --eye 2,0,0.5 --look 0,0,0");
  EXPECT_EQ(j["frames"], 1);
  EXPECT_EQ(j["width"], 320);
  EXPECT_GT(j["measured"], 0.01);
  for (const char* file : {"camera.yaml", "depth.txt", "depth_000000.png"})
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(clip) / file)) << file;
  // What it wrote is a camera file; a clip does not replace the one that it is rendered with.
  const std::string by_its_camera = "render-depth " + scene + " --camera " + clip + "/camera.yaml --out ";
  EXPECT_EQ(runJson(by_its_camera + clip + "_again")["width"], 320);
  EXPECT_EQ(run(by_its_camera + clip).code, 2);
  EXPECT_EQ(run("render-depth " + scene + " --out " + clip + " --eye 1,2").code, 2);
  EXPECT_EQ(run("render-depth " + scene + " --out " + clip + " --eye 0,0,1 --look 0,0,0").code, 2);
  EXPECT_EQ(run("render-depth none.yaml --out " + clip).code, 3);
}

TEST_F(Cli, CoverageStatesWhatIsHidden) {
  const std::string bvh = projectFile("data/scenes/hug_reach.bvh").string();
  const auto scene = [&](const char* name, const std::string& wall) {
    return write(name,
                 "abstand: 1\ndefaults: {voxel: 0.1, point: 0.1}\nhumans:\n  - {name: anna, recording: "
                 "{file: \"" +
                     bvh + "\"}}\n" + wall);
  };
  const std::string open = scene("open.yaml", "");
  const std::string walled =
      scene("walled.yaml",
            "objects:\n  - {name: wall, shape: {cuboid: {size: [0.1, 9, 9]}}, pose: {xyz: [2, 0, 0]}}\n");
  const std::string view = " --eye 4,0,1 --look 0,0,1 --end 0.5 ";
  const std::string csv = (folder_.path() / "shares.csv").string();
  const json seen = runJson("coverage " + open + view + "--csv " + csv);
  EXPECT_EQ(seen["times"], 6);
  EXPECT_EQ(seen["columns"], 320);
  EXPECT_EQ(seen["seen_share"], 0.3);
  ASSERT_EQ(seen["parts"].size(), 14u);
  EXPECT_EQ(seen["parts"][0]["part"], "anna/torso");
  EXPECT_EQ(seen["parts"][0]["seen"], 1.0);
  EXPECT_TRUE(seen["parts"][0]["longest_hidden"].is_null());
  const std::string table = readFile(csv, 1 << 24, true);
  EXPECT_EQ(table.rfind("part,t_s,seen,unknown,out_of_image,out_of_range,robot,thing,self,other_person\n", 0),
            0u);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 14 * 6);
  const json hidden = runJson("coverage " + walled + view);
  for (const json& part : hidden["parts"]) {
    EXPECT_EQ(part["seen"], 0.0);
    EXPECT_EQ(part["times"]["thing"], 1.0);
    EXPECT_EQ(part["longest_hidden"]["cause"], "thing");
    EXPECT_NEAR(part["longest_hidden"]["t1"].get<double>(), 0.5, 1e-9);
  }
  // The same pose in numbers: x of the image is y of the world, y is -z, z is -x.
  const json posed =
      runJson("coverage " + open + " --end 0.5 --pose 4,0,1,-1.5707963267948966,0,1.5707963267948966");
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(posed["pose"][i][k].get<double>(), seen["pose"][i][k].get<double>(), 1e-12) << i << k;
  EXPECT_EQ(posed["parts"], seen["parts"]);
  EXPECT_EQ(runJson("coverage " + open + view + "--farthest 2")["parts"][0]["times"]["out_of_range"], 1.0);
  EXPECT_EQ(runJson("coverage " + open + view + "--sensor kinect_v2")["sensor"]["width"], 512);
  EXPECT_EQ(run("coverage " + open).code, 2);
  EXPECT_EQ(run("coverage " + open + " --eye 1,0,1").code, 2);
  EXPECT_EQ(run("coverage " + open + view + "--pose 0,0,0,0,0,0").code, 2);
  EXPECT_EQ(run("coverage " + open + " --pose 0,0,0").code, 2);
  EXPECT_EQ(run("coverage " + open + view + "--sensor kinect --camera c.yaml").code, 2);
  EXPECT_EQ(run("coverage " + open + view + "--nearest 3 --farthest 2").code, 2);
  EXPECT_EQ(run("coverage none.yaml" + view).code, 3);
  EXPECT_EQ(run("coverage data/scenes/hug_alone.yaml" + view).code, 2);
}

TEST_F(Cli, RenderDepthShowsRecordingAndWritesJointPositions) {
  const std::string clip = (folder_.path() / "clip").string();
  const std::string bvh = projectFile("data/scenes/hug_reach.bvh").string();
  const json j =
      runJson("render-depth --recording " + bvh + " --out " + clip +
              " --body skin --girth 1.1 --clothing 0.01 --body-seed 3 --room --height 1.8 --width 320 "
              "--rate 2 --end 1 --no-cache");
  EXPECT_EQ(j["frames"], 3);
  EXPECT_GT(j["measured"], 0.5);  // the room fills the image
  const json truth = runJson("skeleton " + clip + "/truth.csv");
  EXPECT_EQ(truth["format"], "csv");
  EXPECT_EQ(truth["frames"], 3);
  EXPECT_EQ(truth["gaps"], 0);
  EXPECT_TRUE(truth["missing_parts"].empty());
  EXPECT_EQ(run("render-depth --out " + clip).code, 2);
  EXPECT_EQ(run("render-depth --recording " + bvh + " --girth 1.1 --out " + clip).code, 2);
  EXPECT_EQ(run("render-depth --recording " + bvh + " --body skin --girth 9 --out " + clip).code, 2);
  EXPECT_EQ(run("render-depth --recording none.bvh --out " + clip).code, 3);
}

TEST_F(Cli, RenderDepthWritesPngAndFreenectFormats) {
  const std::string png = (folder_.path() / "png").string(), dump = (folder_.path() / "dump").string();
  const std::string scene = write(
      "ball.yaml",
      "abstand: 1\nobjects:\n  - {name: a, shape: {sphere: {radius: 0.4}}, voxel: 0.05, point: 0.05}\n");
  const std::string view = " --noise none --eye 2,0,0.5 --look 0,0,0";
  runJson("render-depth " + scene + " --out " + png + view);
  EXPECT_EQ(runJson("render-depth " + scene + " --format freenect --out " + dump + view)["frames"], 1);
  tracking::DepthFrame a, b;
  tracking::openDepthStream(png)->next(a);
  const auto stream = tracking::openDepthStream(dump);
  EXPECT_EQ(stream->facts().format, "freenect");
  EXPECT_TRUE(stream->facts().camera_known);
  ASSERT_TRUE(stream->next(b));
  std::size_t seen = 0;
  for (std::size_t i = 0; i < a.image.z.size(); ++i) {
    // Half a millimetre of the PNG, and half a step of a disparity at 2 m.
    EXPECT_NEAR(a.image.z[i], b.image.z[i], 5e-4 + 0.5 * 0.0031 * 4.0 * 1.05);
    seen += b.image.z[i] > 0.0f;
  }
  EXPECT_GT(seen, 10000u);
  EXPECT_EQ(run("render-depth " + scene + " --format freenect --width 320 --out " + dump).code, 2);
}

TEST_F(Cli, TrackedPersonRunsInScene) {
  const std::string clip = (folder_.path() / "clip").string(), csv = (folder_.path() / "person.csv").string();
  const std::string pictures = (folder_.path() / "pictures").string();
  const std::string bvh = projectFile("data/scenes/hug_reach.bvh").string();
  ASSERT_EQ(run("render-depth --recording " + bvh + " --out " + clip +
                " --body skin --width 320 --end 0.4 --no-cache")
                .code,
            0);
  const json j = runJson("track " + clip + " --out " + csv + " --pictures " + pictures);
  EXPECT_EQ(j["frames"], 13);
  EXPECT_EQ(j["tracked"], 13);
  EXPECT_EQ(j["lost"], 0);
  EXPECT_GT(j["fps"], 0.0);
  EXPECT_NEAR(j["height_estimate"], 1.75, 0.08);
  EXPECT_EQ(j["height_source"], "measured");
  EXPECT_TRUE(j["height_interval"].is_null());
  EXPECT_EQ(j["facing"], "camera");
  EXPECT_EQ(j["facing_decided"], false) << "too few images";
  EXPECT_TRUE(j["facing_ratio"].is_null()) << j["facing_ratio"];
  ASSERT_EQ(j["warnings"].size(), 1u) << j["warnings"];
  EXPECT_NE(j["warnings"][0].get<std::string>().find("--facing"), std::string::npos);
  EXPECT_LT(j["residual_mm"], 20.0);
  EXPECT_EQ(j["people"].size(), 1u);
  EXPECT_EQ(j["people"][0]["held"], json::array());
  EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(pictures) / "person1_000012.png"));
  const json skeleton = runJson("skeleton " + csv);
  EXPECT_EQ(skeleton["frames"], 13);
  EXPECT_EQ(skeleton["gaps"], 0);

  const std::string scene = write("person.yaml",
                                  "abstand: 1\nhumans:\n  - {name: p, height: 1.75}\nobjects:\n"
                                  "  - {name: ball, shape: {sphere: {radius: 0.1}}, pose: {xyz: [1, 0, 1]}}\n"
                                  "pairs: {default: between_groups}\n");
  const json ran = runJson("run " + scene + " --recording " + clip);
  EXPECT_EQ(ran["frames"], 13);
  EXPECT_NEAR(ran["min_distance"]["value"].get<double>(),
              runJson("run " + scene + " --recording " + csv)["min_distance"]["value"].get<double>(), 1e-9);

  // Named by the scene, and by a plan.
  const std::string names_clip =
      write("clip.yaml",
            "abstand: 1\nhumans:\n  - {name: p, height: 1.75, recording: {file: clip}}\nobjects:\n"
            "  - {name: ball, shape: {sphere: {radius: 0.1}}, pose: {xyz: [1, 0, 1]}}\n"
            "pairs: {default: between_groups}\n");
  EXPECT_EQ(runJson("run " + names_clip)["min_distance"], ran["min_distance"]);
  const std::string arm =
      "mechanisms:\n  - {name: arm, file: " + projectFile("data/robots/arm6/arm6.urdf").string() + "}\n";
  write("arm.yaml", "abstand: 1\nhumans:\n  - {name: p, height: 1.75, recording: {file: clip}}\n" + arm);
  write("plan.yaml", "abstand_plan: 1\nscenes: [arm.yaml]\nrecordings: [clip]\n");
  EXPECT_EQ(runJson("tune " + (folder_.path() / "plan.yaml").string())["recordings"], 1);
  write("plan.yaml", "abstand_plan: 1\nscenes: [arm.yaml]\nrecordings: [pictures, none]\n");
  const Answer wrong = run("tune " + (folder_.path() / "plan.yaml").string());
  EXPECT_EQ(wrong.code, 3);
  EXPECT_NE(wrong.err.find("plan.yaml:3:24: error: found no file "), std::string::npos) << wrong.err;

  // Of a scene whose things stood there too.
  const std::string cut = (folder_.path() / "cut.csv").string();
  EXPECT_EQ(run("track " + clip + " --scene " + scene + " --out " + cut).code, 0);
  EXPECT_NEAR(
      runJson("run " + scene + " --cut-things --recording " + clip)["min_distance"]["value"].get<double>(),
      runJson("run " + scene + " --recording " + cut)["min_distance"]["value"].get<double>(), 1e-9);
}

TEST_F(Cli, RunCutsOutThingsThatTheImagesShow) {
  const std::string scene =
      write("reach.yaml", "abstand: 1\nhumans:\n  - {name: p, height: 1.75, recording: {file: " +
                              projectFile("data/scenes/hug_reach.bvh").string() +
                              "}}\nobjects:\n  - {name: box, shape: {cuboid: {size: [0.3, 0.3, 1.5]}}, pose: "
                              "{xyz: [0.3, 0.55, 0.75]}}\n"
                              "pairs: {default: between_groups}\n");
  const std::string clip = (folder_.path() / "clip").string();
  ASSERT_EQ(run("render-depth " + scene +
                " --body skin --width 320 --end 0.4 --no-cache --eye 2.8,0,1.2 "
                "--look 0,0,0.9 --out " +
                clip)
                .code,
            0);
  const auto distance = [&](const std::string& options) {
    return runJson("run " + scene + options + " --recording " + clip)["min_distance"]["value"].get<double>();
  };
  const double by_itself = distance("");
  EXPECT_GT(by_itself, 0.0);
  EXPECT_EQ(by_itself, distance(" --cut-things"));
  // Otherwise the box is taken for a part of the person.
  const std::string csv = (folder_.path() / "uncut.csv").string();
  ASSERT_EQ(run("track " + clip + " --out " + csv).code, 0);
  const double uncut = runJson("run " + scene + " --recording " + csv)["min_distance"]["value"].get<double>();
  EXPECT_GT(by_itself, uncut);
  // The CSV has seven digits.
  EXPECT_NEAR(distance(" --no-cut-things"), uncut, 1e-6);
  EXPECT_EQ(run("run " + scene + " --cut-things --no-cut-things --recording " + clip).code, 2);

  const auto removal = [&](const std::string& options) {
    std::vector<std::string> said;
    const json ran = runJson("run " + scene + options + " --recording " + clip);
    for (const json& remark : ran["remarks"])
      if (remark.get<std::string>().find("robots and objects were") != std::string::npos)
        said.push_back(remark);
    return said;
  };
  const std::string what = "clip: the scene's robots and objects were ";
  EXPECT_THAT(removal(""), ::testing::ElementsAre(what + "removed from the images, which show them"));
  EXPECT_THAT(removal(" --cut-things"),
              ::testing::ElementsAre(what + "removed from the images, as specified"));
  EXPECT_THAT(removal(" --no-cut-things"),
              ::testing::ElementsAre(what + "not removed from the images, as specified"));
  // So short a clip leaves the facing undecided, with a large pose uncertainty.
  const Answer checked = run("check " + scene + " --min-distance 0 --json --recording " + clip);
  EXPECT_EQ(checked.code, 1) << checked.err;
  EXPECT_THAT(json::parse(checked.out, nullptr, false)["remarks"].get<std::vector<std::string>>(),
              ::testing::Contains(what + "removed from the images, which show them"));
}

// 8 cm beside its place, as a robot of which a joint is known inaccurately: distances to it are as uncertain.
TEST_F(Cli, RunSaysWhatImagesShowBesideItsPlace) {
  const auto sceneWithBoxAt = [&](const std::string& name, const std::string& y) {
    return write(name, "abstand: 1\nhumans:\n  - {name: p, height: 1.75, recording: {file: " +
                           projectFile("data/scenes/hug_reach.bvh").string() +
                           "}}\nobjects:\n  - {name: box, shape: {cuboid: {size: [0.2, 0.2, 1.5]}}, pose: "
                           "{xyz: [0.3, " +
                           y + ", 0.75]}}\npairs: {default: between_groups}\n");
  };
  const std::string clip = (folder_.path() / "clip").string();
  ASSERT_EQ(run("render-depth " + sceneWithBoxAt("there.yaml", "0.55") +
                " --body skin --width 320 --end 0.4 --no-cache --eye 2.8,0,1.2 --look 0,0,0.9 --out " + clip)
                .code,
            0);
  const auto said = [&](const std::string& scene) {
    const json ran = runJson("run " + scene + " --recording " + clip);
    return std::count_if(ran["reservations"].begin(), ran["reservations"].end(), [](const json& one) {
      return one["kind"] == "recording" &&
             one["text"].get<std::string>().find("mm from where the scene has them") != std::string::npos;
    });
  };
  EXPECT_EQ(said(sceneWithBoxAt("there.yaml", "0.55")), 0);
  EXPECT_EQ(said(sceneWithBoxAt("beside.yaml", "0.63")), 1);
  const json things =
      runJson("track " + clip + " --scene " + sceneWithBoxAt("beside.yaml", "0.63"))["cameras"][0]["things"];
  EXPECT_NEAR(things["displacement"].get<double>(), 0.08, 0.02);
  EXPECT_GT(things["band"].get<double>(), 0.08);
}

TEST_F(Cli, RenderDepthPlacesSeveralCameras) {
  const std::string render = "render-depth --recording " + projectFile("data/scenes/hug_reach.bvh").string() +
                             " --width 320 --end 0 --no-cache ";
  const std::string one = (folder_.path() / "one").string(), all = (folder_.path() / "all").string();
  // Each camera's clip is that of this camera alone, but for the noise of all but the first.
  const std::string eyes = "--eye 2.8,0,1.4 --eye 0,-2.8,1.4 --look 0,0,0.9 --look 0,0,1 ";
  ASSERT_EQ(run(render + eyes + "--noise none --out " + all).code, 0);
  ASSERT_EQ(run(render + "--eye 0,-2.8,1.4 --look 0,0,1 --noise none --out " + one).code, 0);
  for (const char* file : {"camera.yaml", "depth_000000.png", "depth.txt", "truth.csv"})
    EXPECT_EQ(readFile(all + "/camera_2/" + file), readFile(one + "/" + file)) << file;
  // The same cameras by their files.
  const std::string files = "--camera " + all + "/camera_1/camera.yaml," + all + "/camera_2/camera.yaml ";
  const std::string again = (folder_.path() / "again").string();
  const std::string by_files = "render-depth --recording " +
                               projectFile("data/scenes/hug_reach.bvh").string() + " --end 0 --no-cache " +
                               files + "--noise none --out " + again;
  ASSERT_EQ(run(by_files).code, 0);
  EXPECT_EQ(readFile(again + "/camera_1/depth_000000.png"), readFile(all + "/camera_1/depth_000000.png"));
  EXPECT_EQ(readFile(again + "/camera_2/depth_000000.png"), readFile(all + "/camera_2/depth_000000.png"));
  EXPECT_EQ(run(render + eyes + "--look 0,0,1 --out " + one).code, 2);
  EXPECT_EQ(run(render + files + "--out " + one).code, 2) << "--width with --camera";
}

TEST_F(Cli, TrackFitsTwoCamerasTogether) {
  const std::string render = "render-depth --recording " + projectFile("data/scenes/hug_reach.bvh").string() +
                             " --body skin --width 320 --end 0.6 --no-cache --look 0,0,0.9 ";
  const std::string clips = (folder_.path() / "clips").string();
  const std::string front = clips + "/camera_1", side = clips + "/camera_2";
  const json rendered = runJson(render + "--eye 2.8,0,1.4 --eye 0,-2.8,1.4 --out " + clips);
  ASSERT_EQ(rendered["cameras"].size(), 2u);
  EXPECT_EQ(rendered["cameras"][1]["out"], side);
  EXPECT_EQ(rendered["cameras"][1]["frames"], 19);
  const std::string csv = (folder_.path() / "person.csv").string();
  // So short a clip does not decide the facing.
  const std::string both = "track " + front + " " + side + " --facing camera";
  const json j = runJson(both + " --clock 0 --out " + csv);
  EXPECT_EQ(j["frames"], 19);
  EXPECT_EQ(j["tracked"], 19);
  EXPECT_EQ(j["people"].size(), 1u);
  ASSERT_EQ(j["cameras"].size(), 2u);
  for (const json& camera : j["cameras"]) {
    EXPECT_EQ(camera["images"], 19);
    EXPECT_EQ(camera["images_with_people"], 19);
    EXPECT_EQ(camera["moments_without"], 0);
    EXPECT_EQ(camera["clock_known"], true);
  }
  EXPECT_EQ(j["cameras"][1]["file"], side);
  EXPECT_TRUE(j["warnings"].empty()) << j["warnings"];
  EXPECT_EQ(runJson("skeleton " + csv)["gaps"], 0);
  // A camera with more pixels, and the things of a scene cut out of both.
  const std::string fine = (folder_.path() / "fine").string();
  ASSERT_EQ(run("render-depth --recording " + projectFile("data/scenes/hug_reach.bvh").string() +
                " --body skin --width 640 --end 0.6 --no-cache --look 0,0,0.9 --eye 0,-2.8,1.4 --out " + fine)
                .code,
            0);
  const std::string scene = write("things.yaml",
                                  "abstand: 1\nhumans:\n  - {name: p, height: 1.75}\nobjects:\n"
                                  "  - {name: ball, shape: {sphere: {radius: 0.1}}, pose: {xyz: [1, 1, 1]}}\n"
                                  "pairs: {default: between_groups}\n");
  EXPECT_EQ(runJson("track " + front + " " + fine + " --clock 0 --scene " + scene)["tracked"], 19);
  // Half a second does not tell whether the clocks agree.
  const json guessed = runJson(both);
  EXPECT_EQ(guessed["cameras"][1]["clock_known"], false);
  EXPECT_EQ(guessed["cameras"][1]["clock_offset"], 0.0);
  EXPECT_EQ(guessed["warnings"].size(), 1u) << guessed["warnings"];
  EXPECT_THAT(run(both + " --clock 0").out, ::testing::HasSubstr("camera 2: " + side + ", 19 images"));
  // A clock that is far off: nothing is seen together.
  EXPECT_EQ(runJson(both + " --clock 10")["frames"], 38);
  EXPECT_EQ(run(both + " --clock 1,2").code, 2);
  EXPECT_EQ(run(both + " --clock soon").code, 2);
  EXPECT_EQ(run(both + " --camera " + front + "/camera.yaml").code, 2);
  EXPECT_EQ(run(both + " live:kinect").code, 2);
  EXPECT_EQ(run("track live:kinect live:kinect:2 --clock 0").code, 2);
  EXPECT_EQ(run("track live:kinect live:kinect:2 --camera " + front + "/camera.yaml").code, 2);
  EXPECT_THAT(run("track live:kinect live:kinect:1").err, ::testing::HasSubstr("found live:kinect:1 twice"));
  tracking::DepthCamera nowhere = tracking::loadDepthCamera(front + "/camera.yaml");
  nowhere.X_WC = Transform::Identity();
  const std::string lens = write("lens.yaml", tracking::describeDepthCamera(nowhere));
  EXPECT_EQ(run(both + " --camera " + front + "/camera.yaml," + lens).code, 2) << "a camera without a pose";
}

TEST_F(Cli, TrackWarnsThatStatureIsUnmeasured) {
  const std::string clip = (folder_.path() / "clip").string(), csv = (folder_.path() / "person.csv").string();
  const std::string bvh = projectFile("data/scenes/hug_reach.bvh").string();
  // The legs are below the image.
  ASSERT_EQ(run("render-depth --recording " + bvh + " --out " + clip +
                " --body skin --width 320 --end 0.4 --eye 1.7,0,1.5 --look 0,0,1.4 --no-cache")
                .code,
            0);
  const json j = runJson("track " + clip + " --usual-body --out " + csv);
  EXPECT_TRUE(j["height_estimate"].is_null()) << j["height_estimate"];
  EXPECT_EQ(j["height_source"], "interval");
  EXPECT_GE(j["height_interval"][0], 1.0);
  EXPECT_EQ(j["height_interval"][1], 2.1);
  EXPECT_EQ(j["facing_decided"], false) << "with --usual-body nothing is compared";
  EXPECT_EQ(j["warnings"].size(), 2u) << j["warnings"];
  const Answer text = run("track " + clip + " --usual-body --facing camera --height 1.75");
  EXPECT_EQ(text.code, 0);
  EXPECT_NE(text.out.find("height: 1.750 m, as given"), std::string::npos) << text.out;
  EXPECT_EQ(text.err.find("warning"), std::string::npos) << text.err;
  EXPECT_NE(run("track " + clip + " --usual-body").err.find("warning: the stature is unknown, between"),
            std::string::npos);
}

TEST_F(Cli, SkeletonWritesNullForUnknownValues) {
  // A single point moves no part: there is no stature, and no rate.
  const std::string csv = write("one.csv", "t,head.x,head.y,head.z\n0,0,0,1.6\n");
  const Answer a = run("skeleton " + csv + " --json");
  const json j = json::parse(a.out, nullptr, false);
  ASSERT_TRUE(j.is_object()) << a.out << a.err;
  for (const char* key : {"stature", "rate"}) EXPECT_TRUE(j[key].is_null()) << key << ": " << j[key];
}

TEST_F(Cli, TrackReportsBadArguments) {
  const std::string csv = (folder_.path() / "person.csv").string();
  for (const char* bad : {"track", "track data --height 9", "track data --person 0", "track data --rate x"})
    EXPECT_EQ(run(bad).code, 2) << bad;
  EXPECT_EQ(run("track no/such --out " + csv).code, 3);
  EXPECT_EQ(run("track data/scenes --out " + csv).code, 3);
  EXPECT_EQ(run("track data/scenes/hug_reach.bvh --out " + csv).code, 3);
  EXPECT_FALSE(std::filesystem::exists(csv));
}

}  // namespace cli_depth_test
}  // namespace abstand::testing
