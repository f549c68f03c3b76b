// The contract of the commands about robots.
#include "tests/app/program.hpp"

namespace abstand::testing {
namespace cli_robots_test {

TEST_F(Cli, RunAppliesReactionUnlessSwitchedOff) {
  write("slide.mech",
        "mapping\ndof 0 1\nend_mapping\nchain\nframe 1 0 90 d 0\nend_chain\ninertia\nbody 1 2 0 0 0 0.002 "
        "0.002 0.002 0 0 "
        "0\nend_inertia\n");
  const std::string scene = write(
      "slide.yaml",
      "abstand: 1\ndefaults: {voxel: 0.01, point: 0.01}\nmechanisms:\n  - name: slide\n    file: slide.mech\n"
      "    reaction: {repulsion: {range: 0.2, force: 100}, stop: {distance: 0.1}}\n"
      "    links: [{name: ball, frame: 1, shape: {sphere: {radius: 0.05}}}]\n"
      "objects: [{name: thing, shape: {sphere: {radius: 0.05}}, pose: {xyz: [0, 0.11, 0]}}]\n");
  const std::string poses =
      write("still.csv",
            "t,thing.r00,thing.r01,thing.r02,thing.tx,thing.r10,thing.r11,thing.r12,thing.ty,"
            "thing.r20,thing.r21,thing.r22,thing.tz\n0,1,0,0,0,0,1,0,0.11,0,0,1,0\n"
            "0.5,1,0,0,0,0,1,0,0.11,0,0,1,0\n");
  const std::string joints = (folder_.path() / "joints.csv").string();
  const std::string command = "run " + scene + " --no-cache --poses " + poses;
  const json off = runJson(command + " --react off");
  EXPECT_FALSE(off.contains("robots"));
  const json on = runJson(command + " --profile --joints-out " + joints);
  EXPECT_EQ(on["cycles"], 501);
  for (const char* what : {"processor", "empty", "empty_processor"})
    EXPECT_EQ(on["profile_us"][what]["overruns"].is_number(), true) << what;
  const json& robot = on["robots"].at(0);
  EXPECT_EQ(robot["mechanism"], "slide");
  EXPECT_EQ(robot["control"], "torque");
  EXPECT_EQ(robot["stops"].at(0)["reason"], "distance");
  EXPECT_TRUE(robot["min_distance_person"].is_null());
  EXPECT_GT(robot["most_off_plan"], 0.01);
  EXPECT_NE(readFile(joints, 1 << 20, true)
                .find("slide.q0,slide.effort0,slide.planned0,slide.torque0,slide.speed_scale,slide.state\n"),
            std::string::npos);
  const json live = runJson(command + " --mode live");
  EXPECT_EQ(live["cycles"], 501);
  EXPECT_EQ(live["robots"].at(0)["stops"].at(0)["reason"], "distance");
  EXPECT_EQ(run(command + " --react maybe").code, 2);

  // What if: the potential pushes with half the force, and with none.
  const double whole = on["robots"][0]["peak_torque"];
  const json half = runJson(command + " --gain 0.5"), none = runJson(command + " --gain 0");
  EXPECT_NEAR(half["robots"][0]["peak_torque"].get<double>(), 0.5 * whole, 1e-9 * whole);
  EXPECT_EQ(none["robots"][0]["peak_torque"], 0.0);
  EXPECT_EQ(run(command + " --gain -1").code, 2);
  EXPECT_EQ(run(command + " --person-speed 0").code, 2);

  // The gate sees every millisecond: nearer than 2 cm at first only, or all the time.
  const std::string gate = "check " + scene + " --no-cache --min-distance 0.02 --json --poses " + poses;
  const auto moves = run(gate), stands = run(gate + " --react off");
  EXPECT_EQ(moves.code, 1);
  EXPECT_EQ(stands.code, 1);
  const json moved = json::parse(moves.out), stood = json::parse(stands.out);
  EXPECT_EQ(stood["violations"].at(0)["end"], 0.5);
  EXPECT_FALSE(stood.contains("reactions"));
  EXPECT_LT(moved["violations"].at(0)["end"], 0.3);
  EXPECT_EQ(moved["frames"], 2);
  EXPECT_EQ(moved["reactions"].at(0)["robots"].at(0)["mechanism"], "slide");
  EXPECT_EQ(run(gate + " --react maybe").code, 2);
}

TEST_F(Cli, RobotCommandsAcceptPackagePath) {
  for (const char* command : {"fk", "dynamics", "build", "convert", "pairs", "render-depth", "calibrate",
                              "track", "run", "serve", "check"})
    EXPECT_NE(run(command + std::string(" --help")).out.find("--package-path"), std::string::npos) << command;

  std::filesystem::create_directories(folder_.path() / "src/parts");
  write("src/parts/ball.obj",
        "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const std::string robot =
      write("r.urdf",
            "<robot name='r'><link name='a'><collision><geometry><mesh "
            "filename='package://parts/ball.obj'/></geometry></collision></link></robot>");
  const std::string packages = " --package-path " + (folder_.path() / "src").string();
  EXPECT_EQ(run("fk " + robot + packages).code, 0);
  EXPECT_EQ(run("dynamics " + robot + " --solid a:package://parts/ball.obj:1000" + packages).code, 0);
  const std::string build = "build package://parts/ball.obj --voxel 0.02 --point 0.02 --no-cache";
  EXPECT_EQ(runJson(build + packages)["structures"][0]["name"], "ball");
  const Answer lost = run(build);
  EXPECT_EQ(lost.code, 3);
  EXPECT_NE(lost.err.find("--package-path"), std::string::npos) << lost.err;
  const std::string scene = write("s.yaml", "abstand: 1\nmechanisms: [{name: r, file: r.urdf}]\n");
  EXPECT_EQ(run("serve " + scene + " --layout --no-cache" + packages).code, 0);
}

TEST_F(Cli, MeshInMillimetresGetsScaleHint) {
  const std::string mesh =
      write("big.obj", "v 0 0 0\nv 160 0 0\nv 0 160 0\nv 0 0 160\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const Answer a = run("build " + mesh + " --voxel 0.005 --point 0.005 --no-cache");
  EXPECT_NE(a.code, 0);
  EXPECT_NE(a.err.find("160 m large: probably millimetres"), std::string::npos) << a.err;
  EXPECT_NE(a.err.find("--scale"), std::string::npos) << a.err;
  const Answer scene =
      run("run " + write("s.yaml", "abstand: 1\nobjects: [{name: big, mesh: big.obj}]\n") + " --no-cache");
  EXPECT_NE(scene.code, 0);
  EXPECT_NE(scene.err.find("scale: 0.001"), std::string::npos) << scene.err;
}

const char* kDynamics =
    "dynamics data/robots/lwr/lwr4.mech --q 0,0.5,0,-1.2,0,0.8,0 "
    "--solid 2:data/robots/lwr/link2.stl:1500 --solid 7:data/robots/lwr/link7.stl:1500 ";

TEST_F(Cli, DynamicsGivesEffortsMassMatrixAndEffectiveMasses) {
  const json still = runJson(kDynamics + std::string("--effective 7:0,0,2 --effective 1:0,0,1"));
  EXPECT_EQ(still["dof"], 7);
  ASSERT_EQ(still["links"].size(), 7u);
  // The file's mass and the solid's: 1,000 and 1,500 kg/m^3 of the same mesh.
  EXPECT_NEAR(still["links"].at(6)["mass"].get<double>(), 2.5 * 0.415992597, 1e-6);
  EXPECT_EQ(still["efforts"], still["gravity_efforts"]);
  EXPECT_EQ(still["kinetic_energy"], 0.0);
  EXPECT_GT(still["effective_masses"].at(0)["mass"], 0.0);
  EXPECT_TRUE(still["effective_masses"].at(1)["mass"].is_null());
  // tau = M qdd + bias.
  const json moving = runJson(kDynamics + std::string("--qd 1,0,0,-1,0,0,0 --qdd 0,2,0,0,0,0,0"));
  for (std::size_t k = 0; k < 7; ++k)
    EXPECT_NEAR(
        moving["efforts"].at(k).get<double>(),
        moving["bias_efforts"].at(k).get<double>() + 2.0 * moving["mass_matrix"].at(k).at(1).get<double>(),
        1e-9);
  EXPECT_GT(moving["kinetic_energy"], 0.0);
}

TEST_F(Cli, DynamicsFollowsAMotion) {
  const std::string motion = write("m.csv", "t,q0,q1,q2,q3,q4,q5,q6\n0,0,0,0,0,0,0,0\n1,1,0,0,-1,0,0,0\n");
  const std::string out = (folder_.path() / "e.csv").string();
  const json j = runJson(kDynamics + ("--motion " + motion + " --rate 100 --out " + out));
  ASSERT_EQ(j["peaks"].size(), 7u);
  EXPECT_TRUE(j["peaks"].at(1)["within_limit"]);
  EXPECT_GT(j["peaks"].at(1)["effort"], 0.0);
  const std::string csv = readFile(out, 1 << 20, true);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 102);
  EXPECT_TRUE(csv.starts_with("t,q0,"));
}

TEST_F(Cli, DynamicsReportsBadArguments) {
  const std::string arm = "dynamics data/robots/lwr/lwr4.mech ", all = kDynamics;
  const Answer massless = run("dynamics data/scenes/chain.mech");
  EXPECT_EQ(massless.code, 3);
  EXPECT_NE(massless.err.find("found no frame with a mass"), std::string::npos);
  EXPECT_EQ(run(arm + "--solid 2").code, 2);
  EXPECT_EQ(run(arm + "--solid 99:data/robots/lwr/link2.stl:1500").code, 2);
  EXPECT_EQ(run(arm + "--solid 2:data/robots/lwr/link2.stl:-1").code, 2);
  EXPECT_EQ(run(arm + "--solid 2:none.stl:1500").code, 3);
  EXPECT_EQ(run(all + "--qd 1,2").code, 2);
  EXPECT_EQ(run(all + "--effective 7:0,0,0").code, 2);
  EXPECT_EQ(run(all + "--gravity 1,2").code, 2);
}

TEST_F(Cli, FkReadsAUrdf) {
  const json j = runJson("fk data/robots/humanoid/humanoid.urdf --repeat 1");
  EXPECT_EQ(j["dof"], 47);
  EXPECT_EQ(j["frames"].at(0)["name"], "floor");
  EXPECT_EQ(j["frames"].at(0)["parent"], 0);
  // Microseconds: a call of 68 frames takes more than a nanosecond on any machine.
  EXPECT_GT(j["cycle_us"]["median"], 1e-3);
  const Answer xacro = run("fk " + write("r.urdf", "<robot name='r'>\n <link name='${x}'/></robot>"));
  EXPECT_EQ(xacro.code, 3);
  EXPECT_NE(xacro.err.find("r.urdf:2:2: error: found"), std::string::npos) << xacro.err;
  EXPECT_NE(xacro.err.find("hint: expand it first"), std::string::npos) << xacro.err;
  EXPECT_NE(run("fk " + write("w.urdf", "<robot name='r'><link name='a'><visual/></link></robot>"))
                .err.find("warning: "),
            std::string::npos);
}

/// A slide within 1 m, 0.5 m/s, 21 N and 0.8 m/s^2, of 2 kg.
const char* kLimitedSlide =
    "chain\n frame 1 0 0 d 0\nend_chain\nlimits\n limit 1 -1 1 0.5 21 0.8\nend_limits\n"
    "inertia\n body 1 2 0 0 0 0.1 0.1 0.1 0 0 0\nend_inertia\nnames\n name 1 cart rail\nend_names\n";

/// As {joint, kind, value, limit, t, since, samples, planned}.
void expectLimit(const json& row, const char* kind, double value, double limit, bool planned) {
  EXPECT_EQ(row["joint"], "rail");
  EXPECT_EQ(row["kind"], kind);
  EXPECT_NEAR(row["value"].get<double>(), value, 1e-9);
  EXPECT_NEAR(row["limit"].get<double>(), limit, 1e-9);
  EXPECT_EQ(row["planned"], planned);
}

TEST_F(Cli, FkReportsJointLimitViolations) {
  const std::string fk = "fk " + write("slide.mech", kLimitedSlide);
  EXPECT_EQ(runJson(fk + " --q 0.9")["joint_limits"], json::array());
  const json j = runJson(fk + " --q 1.5 --wrench cart:0,0,-30,0,0,0");
  ASSERT_EQ(j["joint_limits"].size(), 2u) << j["joint_limits"];
  const json& position = j["joint_limits"].at(0);
  expectLimit(position, "position", 1.5, 1.0, false);
  EXPECT_EQ(position["samples"], 1);
  EXPECT_TRUE(position["t"].is_null());
  EXPECT_TRUE(position["since"].is_null());
  EXPECT_FALSE(position.contains("mechanism"));
  EXPECT_EQ(j["joint_limits"].at(1)["kind"], "effort");
  EXPECT_EQ(j["joint_limits"].at(1)["limit"].get<double>() > 0,
            j["joint_limits"].at(1)["value"].get<double>() > 0);
  const Answer text = run(fk + " --q 1.5");
  EXPECT_EQ(text.code, 0);
  EXPECT_NE(text.err.find("warning: joint rail: position 1.5 m, limit 1"), std::string::npos) << text.err;
}

TEST_F(Cli, DynamicsReportsJointLimitViolations) {
  const std::string dynamics = "dynamics " + write("slide.mech", kLimitedSlide);
  EXPECT_EQ(runJson(dynamics + " --qdd 0.1")["joint_limits"], json::array());
  const json still = runJson(dynamics + " --qd -0.6 --qdd 0.9")["joint_limits"];
  ASSERT_EQ(still.size(), 3u) << still;
  expectLimit(still.at(0), "velocity", -0.6, -0.5, true);
  expectLimit(still.at(1), "acceleration", 0.9, 0.8, true);
  EXPECT_EQ(still.at(2)["kind"], "effort");
  // From rest to rest over 0.6 m in 2 s: 6 d / T^2 = 0.9 m/s^2 at the ends.
  const std::string motion = write("m.csv", "t,q0\n0,0\n2,0.6\n");
  const json moving = runJson(dynamics + " --motion " + motion + " --rate 100")["joint_limits"];
  ASSERT_EQ(moving.size(), 2u) << moving;
  // In rows of 10 ms, of which the first and the last are at rest.
  expectLimit(moving.at(0), "acceleration", -0.9 * 0.99, -0.8, true);
  EXPECT_NEAR(moving.at(0)["t"].get<double>(), 1.99, 1e-9);
  EXPECT_NEAR(moving.at(0)["since"].get<double>(), 0.01, 1e-9);
  EXPECT_EQ(moving.at(0)["samples"], 22);
  EXPECT_EQ(moving.at(1)["kind"], "effort");
}

TEST_F(Cli, CheckReportsJointLimitViolationsAndFailsIfStrict) {
  write("slide.mech", kLimitedSlide);
  write("fast.csv", "t,q0\n0,0\n0.1,0.06\n");
  const std::string scene = write(
      "s.yaml",
      "abstand: 1\ndefaults: {voxel: 0.05, point: 0.05}\nmechanisms:\n  - {name: m, file: slide.mech, "
      "motion: fast.csv, links: [{name: cart, frame: cart, shape: {sphere: {radius: 0.1}}}]}\nobjects:\n"
      "  - {name: wall, shape: {cuboid: {size: [0.2, 1, 1]}}, pose: {xyz: [-1, 0, 0]}}\n");
  const std::string check = "check " + scene + " --no-cache --min-distance 0.01";
  const json j = runJson(check);
  EXPECT_EQ(j["passed"], true);
  ASSERT_EQ(j["joint_limits"].size(), 1u) << j["joint_limits"];
  const json& row = j["joint_limits"].at(0);
  expectLimit(row, "velocity", 0.6, 0.5, true);
  EXPECT_EQ(row["mechanism"], "m");
  EXPECT_EQ(j["reservations"].back()["kind"], "joint_limit") << j["reservations"];
  EXPECT_EQ(run(check + " --strict").code, 1);
}

TEST_F(Cli, ConvertToUrdfWarnsOfDroppedAccelerationLimits) {
  const std::string urdf = (folder_.path() / "slide.urdf").string();
  const std::string mech = write("slide.mech", kLimitedSlide);
  const Answer a = run("convert " + mech + " " + urdf);
  EXPECT_EQ(a.code, 0) << a.err;
  EXPECT_NE(a.err.find("acceleration limits, which URDF does not support: rail"), std::string::npos) << a.err;
  EXPECT_EQ(runJson("convert " + mech + " " + urdf)["warnings"].size(), 1u);
  const std::string again = (folder_.path() / "again.mech").string();
  EXPECT_TRUE(runJson("convert " + mech + " " + again)["warnings"].empty());
  EXPECT_NE(readFile(again).find(" 0.8"), std::string::npos);
}

TEST_F(Cli, ConvertRoundTripsMechAndUrdf) {
  const std::string mech = (folder_.path() / "a.mech").string(), urdf = (folder_.path() / "b.urdf").string();
  const json there = runJson("convert data/robots/rail7/rail7.urdf " + mech + " --postures 100");
  EXPECT_EQ(there["dof"], 8);
  EXPECT_EQ(there["residual"]["postures"], 100);
  EXPECT_LT(there["residual"]["position"], 1e-9);
  EXPECT_TRUE(there["exact"]);
  const json back = runJson("convert " + mech + " " + urdf);
  EXPECT_TRUE(back["exact"]);
  EXPECT_EQ(back["geometry"], there["geometry"]);
  EXPECT_TRUE(back["warnings"].empty()) << back["warnings"];  // all meshes are found again from there
  EXPECT_EQ(run("convert " + mech + " " + (folder_.path() / "c.txt").string()).code, 2);
  EXPECT_EQ(run("convert none.urdf " + mech).code, 3);
}

/// Found by walking up from the file, which leaves a remark: the case in which a second class of the reader's
/// name ran its destructor (tests/support/check_one_definition.py).
TEST_F(Cli, CheckReadsRobotFromPackage) {
  std::filesystem::create_directories(folder_.path() / "pkg/meshes");
  std::filesystem::create_directories(folder_.path() / "pkg/urdf");
  write("pkg/package.xml", "<package><name>pkg</name></package>");
  write("pkg/meshes/wedge.obj",
        "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  const std::string mesh = "<geometry><mesh filename='package://pkg/meshes/wedge.obj'/></geometry>";
  const std::string link = "<visual>" + mesh + "</visual><collision>" + mesh + "</collision></link>";
  write("pkg/urdf/r.urdf", "<robot name='r'><link name='a'>" + link + "<link name='b'>" + link +
                               "<joint name='j' type='revolute'><parent link='a'/><child link='b'/>"
                               "<origin xyz='0.5 0 0'/><axis xyz='0 0 1'/>"
                               "<limit lower='-1' upper='1' effort='1' velocity='1'/></joint></robot>");
  const std::string scene = write("s.yaml",
                                  "abstand: 1\ndefaults: {voxel: 0.01, point: 0.01}\n"
                                  "mechanisms: [{name: r, file: pkg/urdf/r.urdf}]\n");
  const Answer dry = run("check " + scene + " --dry-run");
  EXPECT_EQ(dry.code, 0) << dry.err;
  EXPECT_NE(dry.out.find("name: r/b, frame: b, mesh: \""), std::string::npos) << dry.out;
  EXPECT_NE(dry.out.find("/pkg/meshes/wedge.obj"), std::string::npos) << dry.out;
}

TEST_F(Cli, SceneAcceptsPairsFileOfRobot) {
  const std::string pairs = (folder_.path() / "arm6.pairs").string(),
                    srdf = (folder_.path() / "arm6.srdf").string();
  const json j = runJson("pairs data/robots/arm6/arm6.urdf --voxel 0.02 --samples 200 --out " + pairs +
                         " --srdf " + srdf);
  EXPECT_EQ(j["pairs"], 21);
  EXPECT_EQ(j["adjacent"], 6);
  EXPECT_EQ(
      j["adjacent"].get<int>() + j["never"].get<int>() + j["always"].get<int>() + j["sometimes"].get<int>(),
      21);
  const std::string scene =
      "abstand: 1\ndefaults: {voxel: 0.02, point: 0.02}\nmechanisms:\n  - {name: arm6, file: '" +
      projectFile("data/robots/arm6/arm6.urdf").string() + "'";
  const json by_file = runJson("run " + write("s.yaml", scene + "}\npairs: {file: arm6.pairs}\n"));
  const json by_srdf = runJson("run " + write("t.yaml", scene + ", srdf: arm6.srdf}\n"));
  EXPECT_EQ(by_file["pairs"], j["sometimes"]);
  EXPECT_EQ(by_srdf["pairs"], j["sometimes"]);
  EXPECT_EQ(run("pairs data/robots/arm6/arm6.urdf --samples 0").code, 2);
  EXPECT_EQ(run("pairs data/scenes/spheres_none.yaml").code, 3);
}

}  // namespace cli_robots_test
}  // namespace abstand::testing
