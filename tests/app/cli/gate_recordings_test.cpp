// The gate: recordings without a person, cut, guessed or doubtful.
#include "tests/app/cli/check_command.hpp"

namespace abstand::testing {
namespace cli_gate_test {

// A recording that moves nobody would pass whatever it shows.
TEST_F(CheckCommand, RejectsRecordingWithoutPerson) {
  person({});
  const std::string recording = " --no-cache --recording " + (folder_.path() / "p.csv").string();
  const std::string nobody = scene(kThings);
  for (const std::string& command :
       {"run " + nobody + recording, "check " + nobody + recording + " --min-distance 0.01",
        "render-depth " + nobody + " --out " + (folder_.path() / "clip").string() + " --recording " +
            (folder_.path() / "p.csv").string()}) {
    const Answer a = run(command);
    EXPECT_EQ(a.code, 2) << command << a.err;
    EXPECT_NE(a.err.find("s.yaml: found no person"), std::string::npos) << a.err;
  }
  EXPECT_EQ(
      run("run " + scene(std::string("humans:\n  - {name: p, height: 1.75}\n") + kThings) + recording).code,
      0);
}

/// The shipped recording, told in its head to have so many frames, and cut after `kept`.
std::string cutBvh(int claimed, int kept) {
  const std::string whole = readFile(projectFile("data/scenes/hug_reach.bvh"));
  const auto frames = whole.find("Frames:");
  std::string text = whole.substr(0, frames) + "Frames: " + std::to_string(claimed) + "\n";
  std::size_t at = whole.find('\n', frames) + 1;
  for (int lines = 0; lines < kept + 1; ++lines) {
    const auto end = whole.find('\n', at) + 1;
    text += whole.substr(at, end - at);
    at = end;
  }
  return text;
}

TEST_F(CheckCommand, TruncatedRecordingIsReportedAndDoesNotPass) {
  const std::string text =
      scene("humans:\n  - {name: p, height: 1.75, recording: {file: p.bvh, units: cm, up: y}}\n" +
            std::string(kThings) + kBetween);
  write("p.bvh", cutBvh(31, 31));
  const std::string command = "check " + text + " --no-cache --min-distance 0.01 --json";
  EXPECT_EQ(run(command).code, 0);
  EXPECT_EQ(run(command + " --strict").code, 0) << run(command + " --strict").out;

  write("p.bvh", cutBvh(101, 31));
  const std::string junit = (folder_.path() / "j.xml").string(), html = (folder_.path() / "r.html").string();
  const Answer a = run(command + " --junit " + junit + " --report " + html);
  EXPECT_EQ(a.code, 1);
  const json document = json::parse(a.out), found = find(document, "frames_missing");
  ASSERT_FALSE(found.is_null()) << a.out;
  EXPECT_NEAR(found["share"].get<double>(), 70.0 / 101.0, 1e-12);
  for (const auto& output : {readFile(junit), readFile(html), run("run " + text + " --no-cache").out})
    EXPECT_NE(output.find("70 of 101 frames are missing"), std::string::npos) << output;
  EXPECT_FALSE(find(runJson("run " + text + " --no-cache"), "frames_missing").is_null());
}

TEST_F(CheckCommand, StrictFailsOnGuessesAndOpenMeshes) {
  write("p.bvh", cutBvh(31, 31));
  write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n");
  const std::string text = scene(
      "humans:\n  - {name: p, height: 1.75, recording: {file: p.bvh}}\nobjects:\n"
      "  - {name: tent, mesh: open.obj, pose: {xyz: [4, 0, 0]}}\n" +
      std::string(kBetween));
  const std::string command = "check " + text + " --no-cache --min-distance 0.01 --json";
  const Answer plain = run(command);
  EXPECT_EQ(plain.code, 0) << plain.out;
  for (const char* kind : {"units_guess", "up_guess", "mesh"})
    EXPECT_EQ(find(json::parse(plain.out), kind).value("fails", ""), "strict") << kind;
  EXPECT_EQ(run(command + " --strict").code, 1);
}

/// A recording in centimetres that states metres, one with an artificial pose, and one with a lost bone:
/// check says so.
TEST_F(CheckCommand, DoubtfulRecordingsRaiseReservations) {
  const auto check = [&](const std::string& recording, const std::string& kind, const std::string& text) {
    const std::string command =
        "check " +
        scene("humans:\n  - {name: p, height: 1.75, recording: {" + recording + "}}\n" + kThings + kBetween) +
        " --no-cache --min-distance 0.001 --json";
    const json document = json::parse(run(command).out);
    EXPECT_TRUE(document["passed"].get<bool>()) << recording;
    bool is_said = false;
    for (const auto& r : document["reservations"])
      if (r["kind"] == kind && r["text"].get<std::string>().find(text) != std::string::npos) {
        is_said = true;
        EXPECT_EQ(r["fails"], "strict");
      }
    EXPECT_TRUE(is_said) << document["reservations"];
    EXPECT_EQ(run(command + " --strict").code, 1) << recording;
  };
  person([](auto& frames) {
    for (auto& f : frames)
      for (Vector3d& p : f.p) p *= 100.0;
  });
  check("file: p.csv", "recording", "in cm it would be 1.748 m: set the units to cm");
  person([](auto& frames) {
    for (std::size_t i = 0; i < 3; ++i)
      for (const double side : {1.0, -1.0}) {
        using J = humanmodel::Joint;
        auto& f = frames[i];
        const int to_right = side > 0.0 ? 0 : 4;
        const auto on = [&](J left) { return static_cast<J>(static_cast<int>(left) + to_right); };
        f.set(on(J::kElbowLeft), f[on(J::kShoulderLeft)] + Vector3d(0.0, side * 0.3, 0.0));
        f.set(on(J::kWristLeft), f[on(J::kElbowLeft)] + Vector3d(0.0, side * 0.25, 0.0));
      }
  });
  check("file: p.csv", "recording", "frames 1 to 3 are a T-pose");
  const auto cmu = debianBvh("01_01.bvh");
  if (!std::filesystem::exists(cmu)) GTEST_SKIP() << cmu;
  check("file: " + cmu.string(), "repair_guess", "the file lacks a bone after 'Spine1'");
  check("file: " + cmu.string() + ", repair: false", "recording", "not repaired: the file lacks a bone");
}

}  // namespace cli_gate_test
}  // namespace abstand::testing
