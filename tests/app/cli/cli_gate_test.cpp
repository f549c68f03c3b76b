// The gate: whatever was not known never passes, and every output says what it was.
#include <functional>

#include "humanmodel/human_model.hpp"
#include "tests/app/program.hpp"
#include "tracking/table/skeleton_csv.hpp"

namespace abstand::testing {
namespace cli_gate_test {

constexpr int kFrames = 11;
constexpr double kStep = 0.1;  // s

const char* const kHead = "abstand: 1\ndefaults: {voxel: 0.05, point: 0.05, outer_layers: 1}\n";
const char* const kThings =
    "objects:\n  - {name: wall, shape: {cuboid: {size: [0.2, 1, 1]}}, pose: {xyz: [-4, 0, 0]}}\n"
    "  - {name: ball, shape: {sphere: {radius: 0.1}}, pose: {xyz: [4, 0, 1]}}\n";
const char* const kPerson = "humans:\n  - {name: p, height: 1.75, recording: {file: p.csv}}\n";
const char* const kBetween = "pairs: {default: between_groups}\n";
const char* const kJoint =
    "<joint name='j' type='revolute'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/>"
    "<limit lower='-1' upper='1' velocity='1' effort='1'/></joint>";

/// What a case changes in the person's frames.
using Change = std::function<void(std::vector<humanmodel::SkeletonFrame>&)>;

void lose(humanmodel::SkeletonFrame& frame, std::initializer_list<humanmodel::Joint> joints) {
  for (const humanmodel::Joint j : joints)
    frame.set(j, Vector3d::Constant(kNaN), humanmodel::JointState::kMissing);
}

void loseAll(humanmodel::SkeletonFrame& frame) {
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    frame.set(static_cast<humanmodel::Joint>(j), Vector3d::Constant(kNaN), humanmodel::JointState::kMissing);
}

std::string row(const char* t, const std::string& pose) { return std::string(t) + "," + pose + "\n"; }

const std::string kGood = "1,0,0,4,0,1,0,0,0,0,1,1";

/// The ball at x = 4 m, but for the rows in the middle.
std::string ballRows(const std::string& middle, const char* first = kGood.c_str()) {
  std::string csv = "t";
  for (const char* c : {"r00", "r01", "r02", "tx", "r10", "r11", "r12", "ty", "r20", "r21", "r22", "tz"})
    csv += std::string(",ball.") + c;
  return csv + "\n" + row("0", first) + row("0.5", middle) + row("1", kGood);
}

struct Unknown {
  const char* name;
  const char* kind;   ///< of the reservation that fails
  std::string scene;  ///< without head
  std::string poses;  ///< a table, or none
  std::string robot;  ///< r.urdf, or none
  Change change;      ///< of the person's frames
  double t0, t1;      ///< s, of the reservation; NaN: it has none
};

class CheckCommand : public Cli {
 protected:
  void person(const Change& change) {
    std::vector<humanmodel::SkeletonFrame> frames(kFrames, humanmodel::makeHuman({}).rest);
    for (int i = 0; i < kFrames; ++i) frames[static_cast<std::size_t>(i)].t = i * kStep;
    if (change) change(frames);
    tracking::Recording recording;
    recording.frames = std::move(frames);
    tracking::writeSkeletonCsv(folder_.path() / "p.csv", recording);
  }
  std::string scene(const std::string& text) { return write("s.yaml", kHead + text); }
  /// The first reservation of that kind, or null.
  static json find(const json& document, const std::string& kind) {
    for (const auto& r : document["reservations"])
      if (r["kind"] == kind) return r;
    return nullptr;
  }
};

std::vector<Unknown> unknowns() {
  const std::string with_person = std::string(kPerson) + kThings + kBetween;
  const std::string robot = "mechanisms:\n  - {name: m, file: r.urdf";
  const std::string with_robot = robot + "}\n" + kThings + kBetween;
  const std::string nan = "nan,0,0,4,0,1,0,0,0,0,1,1", far = "1,0,0,1e9,0,1,0,0,0,0,1,1",
                    skew = "2,0,0,4,0,1,0,0,0,0,1,1";
  const std::string half =
      std::string(
          "<robot name='r'><link name='a'><collision><geometry><box size='0.1 0.1 0.1'/></geometry>"
          "</collision></link><link name='b'><visual><geometry><mesh filename='absent.dae'/></geometry>"
          "</visual></link>") +
      kJoint + "</robot>";
  const std::string bare =
      std::string("<robot name='r'><link name='a'/><link name='b'/>") + kJoint + "</robot>";
  const std::string whole =
      std::string(
          "<robot name='r'><link name='a'><collision><geometry><box size='0.1 0.1 0.1'/></geometry>"
          "</collision></link><link name='b'><collision><geometry><box size='0.1 0.1 0.1'/></geometry>"
          "</collision></link>") +
      kJoint + "</robot>";
  return {
      {"refused, not a number", "refused_pose", kThings, ballRows(nan), "", {}, 0.5, 0.5},
      {"refused, no rotation", "refused_pose", kThings, ballRows(skew), "", {}, 0.5, 0.5},
      {"refused, a million kilometres away", "refused_pose", kThings, ballRows(far), "", {}, 0.5, 0.5},
      {"no pose at first", "refused_pose", kThings, ballRows(nan, nan.c_str()), "", {}, 0.0, 0.5},
      {"stale", "stale_pose", with_person, "", "",
       [](auto& f) {
         for (std::size_t i = 3; i < 6; ++i)
           lose(f[i],
                {humanmodel::Joint::kElbowLeft, humanmodel::Joint::kWristLeft, humanmodel::Joint::kHandLeft});
       },
       0.3, 0.5},
      {"nobody for a while", "no_person", with_person, "", "",
       [](auto& f) {
         for (std::size_t i = 4; i < 8; ++i) loseAll(f[i]);
       },
       0.4, 0.7},
      {"unmapped part", "unmapped_part", with_person, "", "",
       [](auto& f) {
         for (auto& frame : f) lose(frame, {humanmodel::Joint::kAnkleRight, humanmodel::Joint::kToeRight});
       },
       kNaN, kNaN},
      {"poses end early",
       "outside_recording",
       with_person,
       "t,ball.r00,ball.r01,ball.r02,ball.tx,ball.r10,ball.r11,ball.r12,ball.ty,ball.r20,ball.r21,"
       "ball.r22,ball.tz\n" +
           row("0", kGood) + row("0.1", kGood),
       "",
       {},
       0.3,
       1.0},
      {"robot without a body", "no_body", with_robot, "", bare, {}, kNaN, kNaN},
      {"robot with an empty list of links",
       "no_body",
       robot + ", links: []}\n" + kThings + kBetween,
       "",
       bare,
       {},
       kNaN,
       kNaN},
      {"link without a body", "missing_body", with_robot, "", half, {}, kNaN, kNaN},
      {"link that the scene does not list",
       "missing_body",
       robot + ", links: [{name: x, frame: a, shape: {sphere: {radius: 0.1}}}]}\n" + kThings + kBetween,
       "",
       whole,
       {},
       kNaN,
       kNaN},
      {"nothing to check",
       "no_pairs",
       std::string(kThings) + "pairs: {default: none}\n",
       "",
       "",
       {},
       kNaN,
       kNaN},
  };
}

TEST_F(CheckCommand, UnknownDataNeverPasses) {
  for (const Unknown& u : unknowns()) {
    SCOPED_TRACE(u.name);
    person(u.change);
    if (!u.robot.empty()) write("r.urdf", u.robot);
    std::string command = "check " + scene(u.scene) + " --no-cache --min-distance 0.01";
    if (!u.poses.empty()) command += " --poses " + write("poses.csv", u.poses);
    const std::string junit = (folder_.path() / "j.xml").string(),
                      html = (folder_.path() / "r.html").string();
    for (const char* strict : {"", " --strict"}) {
      const Answer a = run(command + strict + " --json --junit " + junit + " --report " + html);
      ASSERT_EQ(a.code, 1) << a.err << a.out;
      const json document = json::parse(a.out);
      EXPECT_FALSE(document["passed"]);
      const json found = find(document, u.kind);
      ASSERT_FALSE(found.is_null()) << document["reservations"];
      EXPECT_EQ(found["fails"], "always");
      if (std::isnan(u.t0)) {
        EXPECT_TRUE(found["t0"].is_null()) << found;
      } else {
        EXPECT_NEAR(found["t0"].get<double>(), u.t0, 1e-9) << found;
        EXPECT_NEAR(found["t1"].get<double>(), u.t1, 1e-9) << found;
        EXPECT_GT(found["share"].get<double>(), 0.0);
        EXPECT_LT(found["share"].get<double>(), 1.0);
      }
      const std::string xml = readFile(junit);
      EXPECT_NE(xml.find("<failure type=\"" + std::string(u.kind)), std::string::npos) << xml;
      EXPECT_EQ(xml.find("failures=\"0\""), std::string::npos);
      EXPECT_NE(readFile(html).find("Not passed"), std::string::npos);
      EXPECT_NE(readFile(html).find(u.kind), std::string::npos);
    }
    const Answer text = run(command);
    EXPECT_NE(text.out.find(std::string("reservation (") + u.kind), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("not passed"), std::string::npos) << text.out;
  }
}

TEST_F(CheckCommand, CompleteDataPasses) {
  person({});
  write("r.urdf", std::string("<robot name='r'><link name='a'/><link name='b'><collision><geometry>"
                              "<box size='0.1 0.1 0.1'/></geometry></collision></link>") +
                      kJoint + "</robot>");
  write("half.urdf",
        std::string("<robot name='r'><link name='a'><visual><geometry><mesh filename='absent.dae'/>"
                    "</geometry></visual></link><link name='b'/>") +
            kJoint + "</robot>");
  const std::string text = std::string(kPerson) + kThings + kBetween +
                           "mechanisms:\n  - {name: m, file: r.urdf, base: {xyz: [0, 4, 0]}}\n"
                           "  - {name: frame, file: half.urdf, geometry: none}\n"
                           "  - {name: named, file: half.urdf, bodiless: [a], geometry: none}\n";
  const Answer a = run("check " + scene(text) + " --no-cache --strict --min-distance 0.01 --json");
  EXPECT_EQ(a.code, 0) << a.out << a.err;
  const json document = json::parse(a.out);
  EXPECT_TRUE(document["passed"]);
  for (const auto& r : document["reservations"]) EXPECT_EQ(r["fails"], "never") << r;
  EXPECT_FALSE(find(document, "bodiless").is_null()) << "said all the same";

  // As it was understood it says the same again.
  const Answer dry = run("check --dry-run " + scene(text));
  EXPECT_NE(dry.out.find("geometry: none"), std::string::npos) << dry.out;
  EXPECT_EQ(run("check --dry-run " + write("again.yaml", dry.out)).out, dry.out);
}

TEST_F(CheckCommand, LinksDeclaredWithoutGeometryPass) {
  write("r.urdf", std::string("<robot name='r'><link name='a'><collision><geometry><box size='0.1 0.1 0.1'/>"
                              "</geometry></collision></link><link name='b'><visual><geometry>"
                              "<mesh filename='absent.dae'/></geometry></visual></link>") +
                      kJoint + "</robot>");
  const std::string check = " --no-cache --min-distance 0.01";
  const std::string text = "mechanisms:\n  - {name: m, file: r.urdf";
  const std::string rest = std::string("}\n") + kThings + kBetween;
  EXPECT_EQ(run("check " + scene(text + rest) + check).code, 1);
  EXPECT_EQ(run("check " + scene(text + ", bodiless: [b]" + rest) + check).code, 0);
  const Answer typo = run("check " + scene(text + ", bodiless: [c]" + rest) + check);
  EXPECT_EQ(typo.code, 3);
  EXPECT_NE(typo.err.find("s.yaml:4:"), std::string::npos) << typo.err;
  // `run` goes on, and says it in one line.
  const Answer ran = run("run " + scene(text + rest) + " --no-cache");
  EXPECT_EQ(ran.code, 0);
  const auto line = ran.out.find("1 of 2 links of m have no body");
  ASSERT_NE(line, std::string::npos) << ran.out;
  EXPECT_EQ(ran.out.find("1 of 2 links", line + 1), std::string::npos) << ran.out;
}

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

// The thesis's files say where the centre of a link is; a mesh that stands elsewhere is not that link.
TEST_F(CheckCommand, MisplacedLinkMeshRaisesReservation) {
  write("r.mech",
        "chain\n frame 1 0 0 0 theta\nend_chain\nlimits\n limit 1 -1 1 1 1\nend_limits\n"
        "link\n id 1\n center 1 0 0 0.5  0 1 0 0  0 0 1 0\nend_link\n");
  write("cube.obj",
        "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
        "f 1 4 3\nf 1 3 2\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 "
        "5\nf 4 5 8\n");
  const auto check = [&](const std::string& place) {
    return "check " +
           scene(
               "mechanisms:\n  - {name: m, file: r.mech, links: [{name: cube, frame: 1, mesh: cube.obj, "
               "scale: "
               "0.1" +
               place + "}]}\n" + kThings + kBetween) +
           " --no-cache --min-distance 0.01";
  };
  const json away = runJson(check(""));
  const json found = find(away, "link_center");
  ASSERT_FALSE(found.is_null()) << away["reservations"];
  EXPECT_EQ(found["fails"], "strict");
  EXPECT_NE(
      found["text"].get<std::string>().find("cube: its centre is 0.500 m from the one that r.mech states"),
      std::string::npos)
      << found;
  EXPECT_EQ(run(check("") + " --strict").code, 1);
  // Somebody has put it there: to know, but no doubt.
  const json posed = find(runJson(check(", pose: {xyz: [0.2, 0, 0]}")), "link_center");
  ASSERT_FALSE(posed.is_null());
  EXPECT_EQ(posed["fails"], "never");
  EXPECT_EQ(run(check(", pose: {xyz: [0.2, 0, 0]}") + " --strict").code, 0);
  for (const char* there : {", pose: center", ", pose: {xyz: [0.5, 0, 0]}", ", pose: {xyz: [0.495, 0, 0]}"})
    EXPECT_TRUE(find(runJson(check(there)), "link_center").is_null()) << there;
}

TEST_F(CheckCommand, ReportsMinDistancePerClassAndSelfPairsOnRequest) {
  person({});
  write("r.urdf",
        "<robot name='r'><link name='a'><collision><geometry><box size='0.1 0.1 0.1'/></geometry></collision>"
        "</link></robot>");
  const std::string bodies =
      std::string(kPerson) + kThings + "mechanisms:\n  - {name: m, file: r.urdf, base: {xyz: [0, 2, 0]}}\n";
  const std::string first_scene = scene(bodies);
  const json j = runJson("run " + first_scene + " --no-cache");
  EXPECT_EQ(j["pairs"], 14 * 3 + 2 + 1);
  const json& least = j["min_distance_by_class"];
  EXPECT_TRUE(least["person_robot"]["a"] == "m/a" || least["person_robot"]["b"] == "m/a") << least;
  EXPECT_EQ(least["robot_robot"], nullptr);
  for (const char* key : {"person_robot", "person_thing", "robot_thing"}) {
    ASSERT_TRUE(least[key].is_object()) << key;
    EXPECT_GE(least[key]["value"], j["min_distance"]["value"]) << key;
  }
  EXPECT_EQ(least["person_robot"]["value"], j["min_distance"]["value"]);
  EXPECT_GT(j["min_distance"]["value"], 1.0) << "not within the person";
  const std::string text = run("run " + first_scene + " --no-cache").out;
  const auto people = text.find("minimum distance person to robot: "),
             things = text.find("minimum distance robot to thing: ");
  EXPECT_TRUE(people != std::string::npos && things != std::string::npos && people < things) << text;
  const Answer gate = run("check " + first_scene + " --no-cache --min-distance 0.01 --json");
  EXPECT_EQ(json::parse(gate.out)["min_distance_by_class"], least);

  const json asked = runJson("run " + scene(bodies + "pairs: {within_people: include}\n") + " --no-cache");
  EXPECT_EQ(asked["pairs"], 14 * 3 + 2 + 1 + 14 * 13 / 2 - 13);
  EXPECT_LT(asked["min_distance"]["value"], 0.5);
  EXPECT_EQ(asked["min_distance_by_class"], least) << "parts of one person are in no class";
}

TEST_F(CheckCommand, ReportsMarginForcesAsVirtual) {
  const auto ball = [&](const char* x) {
    return scene(
        std::string("objects:\n  - {name: wall, shape: {cuboid: {size: [0.2, 1, 1]}}, margin: 0.1}\n") +
        "  - {name: ball, shape: {sphere: {radius: 0.1}}, pose: {xyz: [" + x + ", 0, 0]}}\n");
  };
  const std::string apart = "run " + ball("0.25") + " --no-cache";
  EXPECT_EQ(runJson(apart)["peak_force_at"]["virtual"], true);
  EXPECT_NE(run(apart).out.find("peak virtual (margin) force: "), std::string::npos);
  const std::string inside = "run " + ball("0.15") + " --no-cache";
  EXPECT_EQ(runJson(inside)["peak_force_at"]["virtual"], false);
  EXPECT_NE(run(inside).out.find("peak force: "), std::string::npos);
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

TEST_F(CheckCommand, StrictFailuresAppearInJUnitWithReason) {
  // 0.11 m apart, known to a millimetre or so.
  const std::string text =
      "objects:\n  - {name: wall, shape: {cuboid: {size: [0.2, 1, 1]}}}\n"
      "  - {name: ball, shape: {sphere: {radius: 0.1}}, pose: {xyz: [0.31, 0, 0]}}\n";
  const double d = runJson("run " + scene(text) + " --no-cache")["min_distance"]["value"];
  const std::string limit = std::to_string(d - 2e-6);  // six digits behind the point
  const std::string junit = (folder_.path() / "j.xml").string(), html = (folder_.path() / "r.html").string();
  const std::string command = "check " + scene(text) + " --no-cache --min-distance " + limit + " --junit " +
                              junit + " --report " + html;
  ASSERT_EQ(run(command).code, 0);
  EXPECT_NE(readFile(junit).find("failures=\"0\""), std::string::npos);
  ASSERT_EQ(run(command + " --strict").code, 1);
  EXPECT_NE(readFile(junit).find("failures=\"1\""), std::string::npos) << readFile(junit);
  EXPECT_NE(readFile(junit).find("error bound"), std::string::npos);
  EXPECT_NE(readFile(html).find("Not passed"), std::string::npos);
}

}  // namespace cli_gate_test
}  // namespace abstand::testing
