// The gate: whatever was not known never passes, and every output says what it was.
#include "tests/app/cli/check_command.hpp"

namespace abstand::testing {
namespace cli_gate_test {

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

}  // namespace cli_gate_test
}  // namespace abstand::testing
