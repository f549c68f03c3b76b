// The gate: links whose place is doubtful, and what is reported of distances, forces and limits.
#include "tests/app/cli/check_command.hpp"

namespace abstand::testing {
namespace cli_gate_test {

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
