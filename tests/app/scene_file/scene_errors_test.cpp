// Bad scenes: each is refused at its place, in words.
#include <gtest/gtest.h>

#include "app/scene_file/scene_description.hpp"
#include "core/config/yaml_document.hpp"
#include "tests/support/paths.hpp"

namespace abstand::scene_file {
namespace scene_errors_test {

struct BadScene {
  const char* text;
  int line, column;  // 0: any
  const char* word;  // stands in the message
};

const char* const kObject = "abstand: 1\nobjects:\n";
const char* const kHuman = "abstand: 1\nhumans:\n";
const char* const kMechanism = "abstand: 1\nmechanisms:\n";

std::string errorOf(const std::string& text, SourcePos& pos) {
  const testing::ScratchFolder folder;
  folder.write("arm.mech", "chain\nframe 1 0 0 0 theta\nframe 2 0 90 0 theta\nend_chain\n");
  folder.write("two.mech",
               "mapping\ndof 0 1\ndof 1 2\nend_mapping\nchain\nframe 1 0 0 0 theta\nframe 2 0 90 0 "
               "theta\nend_chain\n");
  folder.write("still.mech", "chain\nframe 1 0 0 0 0\nend_chain\n");
  folder.write("a.stl", "x");
  try {
    parseScene(text, folder.path() / "scene.yaml");
  } catch (const ParseError& e) {
    pos = e.pos();
    return e.what();
  }
  return {};
}

void expectRefused(const std::string& head, const std::vector<BadScene>& cases) {
  for (const auto& c : cases) {
    SCOPED_TRACE(head + c.text);
    SourcePos pos;
    const auto message = errorOf(head + c.text, pos);
    if (message.empty()) {
      ADD_FAILURE() << "was accepted";
      continue;
    }
    EXPECT_NE(message.find("scene.yaml"), std::string::npos) << message;
    EXPECT_NE(message.find(c.word), std::string::npos) << message;
    if (c.line) {
      EXPECT_EQ(pos.line, c.line) << message;
    }
    if (c.column) {
      EXPECT_EQ(pos.column, c.column) << message;
    }
  }
}

TEST(SceneErrors, RejectsBadYaml) {
  expectRefused("", {
                        {"{{{{", 1, 0, "YAML"},
                        {"", 1, 1, "no YAML value"},
                        {"# only a comment\n", 1, 1, "no YAML value"},
                        {"[1, 2]", 1, 1, "found a list for the scene"},
                        {"hello", 1, 1, "found `hello` for the scene"},
                        {"abstand: 1\n\tobjects: []", 2, 0, "YAML"},
                        {"abstand: 1\nobjects: [", 0, 0, "YAML"},
                        {"abstand: 1\nobjects: []\nobjects: []", 3, 1, "a second time"},
                        {"abstand: 1\n---\nabstand: 1\n", 0, 0, "second YAML document"},
                        {"abstand: 1\n]", 2, 0, "YAML"},
                        {"abstand: 1\nobjects: *nobody", 2, 0, "YAML"},
                        {"abstand: 1\nobjects: &a [*a]", 2, 14, "recursive alias"},
                        {"abstand: 1\nobjects: !mine []", 2, 10, "tag"},
                        {"abstand: 1\n? [a, b]\n: 1", 2, 3, "key that is not a scalar"},
                        {"abstand: 1\nna\x01me: 2", 2, 3, "control character"},
                        {"abstand: 1\nobjects: \"\\q\"", 2, 0, "YAML"},
                    });
}

TEST(SceneErrors, RejectsBadTopLevel) {
  expectRefused("", {
                        {"objects: []\n", 1, 1, "abstand: 1"},
                        {"abstand: 2\n", 1, 10, "format version 1"},
                        {"abstand: one\n", 1, 10, "format version 1"},
                        {"abstand: \"1\"\n", 1, 10, "format version 1"},
                        {"abstand:\n", 1, 1, "found nothing"},
                        {"abstand: 1\nobjekts: []\n", 2, 1, "did you mean `objects`?"},
                        {"abstand: 1\nobjects: {}\n", 2, 10, "found a map"},
                        {"abstand: 1\nobjects:\n", 2, 1, "found nothing"},
                        {"abstand: 1\nhumans: 3\n", 2, 9, "expected a list"},
                        {"abstand: 1\ndefaults: []\n", 2, 11, "expected a map"},
                        {"abstand: 1\ndefaults: {voxels: 1}\n", 2, 12, "did you mean `voxel`?"},
                        {"abstand: 1\ndefaults: {voxel: -0.005}\n", 2, 19, "expected a number from"},
                        {"abstand: 1\ndefaults: {voxel: 0}\n", 2, 19, "voxel"},
                        {"abstand: 1\ndefaults: {voxel: .nan}\n", 2, 19, "finite"},
                        {"abstand: 1\ndefaults: {voxel: .inf}\n", 2, 19, "finite"},
                        {"abstand: 1\ndefaults: {voxel: 1e999}\n", 2, 19, "finite"},
                        {"abstand: 1\ndefaults: {voxel: 0x10}\n", 2, 19, "finite"},
                        {"abstand: 1\ndefaults: {voxel: '0.005'}\n", 2, 19, "the text `0.005`"},
                        {"abstand: 1\ndefaults: {voxel: 5 mm}\n", 2, 19, "`5 mm`"},
                        {"abstand: 1\ndefaults: {voxel: 0,005}\n", 2, 0, "unknown key `005`"},
                        {"abstand: 1\ndefaults: {point: [1]}\n", 2, 19, "found a list"},
                        {"abstand: 1\ndefaults: {outer_layers: 2.5}\n", 2, 26, "whole number"},
                        {"abstand: 1\ndefaults: {outer_layers: -1}\n", 2, 26, "whole number"},
                        {"abstand: 1\ndefaults: {outer_layers: 99999999999}\n", 2, 26, "whole number"},
                        {"abstand: 1\ndefaults: {margin: -1}\n", 2, 20, "margin"},
                        {"abstand: 1\ndefaults: {stiffness: 0}\n", 2, 23, "above 0"},
                        {"abstand: 1\ndefaults: {law: volum}\n", 2, 17, "did you mean `volume`?"},
                        {"abstand: 1\ndefaults: {field: octree}\n", 2, 19, "layered, float, mixed"},
                    });
}

TEST(SceneErrors, RejectsBadObjects) {
  expectRefused(
      kObject,
      {
          {"  - 5\n", 3, 5, "an object"},
          {"  - {shape: {sphere: {radius: 1}}}\n", 3, 5, "found no `name`"},
          {"  - {name: a}\n", 3, 5, "neither `mesh` and `shape`"},
          {"  - {name: a, structure: none.structure}\n", 3, 26, "found no file"},
          {"  - {name: a, structure: a, shape: {sphere: {radius: 1}}}\n", 3, 15,
           "`structure` together with `shape`"},
          {"  - {name: a, mesh: a.stl, shape: {sphere: {radius: 1}}}\n", 3, 28, "both `mesh` and `shape`"},
          {"  - {name: a, mesh: missing.stl}\n", 3, 21, "missing.stl"},
          {"  - {name: a, mesh: missing.stl}\n", 3, 21, "relative to the folder"},
          {"  - {name: a, mesh: .}\n", 3, 21, "a folder"},
          {"  - {name: a, mesh: /dev/null}\n", 3, 21, "no regular file"},
          {"  - {name: a, mesh: a.stl, scale: 0}\n", 3, 35, "`scale`"},
          {"  - {name: a, shape: {sphere: {radius: 1}}, scale: 2}\n", 3, 45, "with a mesh only"},
          {"  - {name: a, shape: sphere}\n", 3, 22, "expected a map"},
          {"  - {name: a, shape: {}}\n", 3, 22, "found 0 shapes"},
          {"  - {name: a, shape: {sphere: {radius: 1}, cuboid: {size: [1, 1, 1]}}}\n", 3, 22,
           "found 2 shapes"},
          {"  - {name: a, shape: {spere: {radius: 1}}}\n", 3, 23, "did you mean `sphere`?"},
          {"  - {name: a, shape: {sphere: {radius: 0}}}\n", 3, 40, "radius"},
          {"  - {name: a, shape: {sphere: {diameter: 1}}}\n", 3, 32, "unknown key `diameter`"},
          {"  - {name: a, shape: {sphere: 1}}\n", 3, 31, "expected a map"},
          {"  - {name: a, shape: {sphere: {}}}\n", 3, 31, "found no `radius`"},
          {"  - {name: a, shape: {cuboid: {size: [1, 1]}}}\n", 3, 38, "a list of 2"},
          {"  - {name: a, shape: {cuboid: {size: [1, 1, -1]}}}\n", 3, 0, "`-1`"},
          {"  - {name: a, shape: {cylinder: {radius: 1}}}\n", 3, 33, "found no `length`"},
          {"  - {name: a, shape: {cylinder: {radius: 1, length: 0}}}\n", 3, 53, "above 0"},
          {"  - {name: a, shape: {sphere: {radius: 1}}, pose: [0, 0, 0]}\n", 3, 51, "expected a map"},
          {"  - {name: a, shape: {sphere: {radius: 1}}, pose: {xyz: [0, 0, x]}}\n", 3, 64, "`x`"},
          {"  - {name: a, shape: {sphere: {radius: 1}}, pose: {rpy: [0, 0, 1e9]}}\n", 3, 64, "1e9"},
          {"  - {name: a, shape: {sphere: {radius: 1}}, pose: {quat: [0, 0, 0, 1]}}\n", 3, 52, "quat"},
          {"  - {name: a, shape: {sphere: {radius: 1}}, marign: 1}\n", 3, 45, "did you mean `margin`?"},
          {"  - {name: a, shape: {sphere: {radius: 1}}}\n  - {name: a, shape: {sphere: {radius: 1}}}\n", 4,
           12, "already used"},
          {"  - {name: '', shape: {sphere: {radius: 1}}}\n", 3, 12, "1 to 4096 characters"},
          {"  - {name: [a], shape: {sphere: {radius: 1}}}\n", 3, 12, "found a list"},
          {"  - {name: 'a,b', shape: {sphere: {radius: 1}}}\n", 3, 12, "no comma"},
          {"  - {name: \"a\\nb\", shape: {sphere: {radius: 1}}}\n", 3, 12, "line break"},
          {"  - {name: ~, shape: {sphere: {radius: 1}}}\n", 3, 12, "found nothing"},
      });
}

TEST(SceneErrors, RejectsBadMechanisms) {
  expectRefused(
      kMechanism,
      {
          {"  - {name: arm}\n", 3, 5, "found no `file`"},
          {"  - {name: objects, file: arm.mech}\n", 3, 12, "group of all single objects"},
          {"  - {name: arm, file: gone.urdf}\n", 3, 23, "gone.urdf"},
          {"  - {name: arm, file: arm.mech}\n  - {name: arm, file: arm.mech}\n", 4, 12, "already used"},
          {"  - {name: arm, file: arm.mech, q: 1}\n", 3, 36, "expected a list"},
          {"  - {name: arm, file: arm.mech, q: [0, .inf]}\n", 3, 40, "finite"},
          {"  - {name: arm, file: still.mech, reaction: {}}\n", 3, 45, "nothing moves"},
          {"  - {name: arm, file: two.mech, reaction: 3}\n", 3, 43, "map"},
          {"  - {name: arm, file: two.mech, reaction: {torqe: {}}}\n", 3, 44, "did you mean `torque`"},
          {"  - {name: arm, file: two.mech, reaction: {proxy: {}}}\n", 3, 43, "`held: true`"},
          {"  - {name: arm, file: two.mech, links: [{name: a, frame: 1, shape: {sphere: {radius: 1}}, held: "
           "yes}]}\n",
           3, 97, "expected one of true, false"},
          {"  - {name: arm, file: two.mech, links: [{name: a, frame: 1, shape: {sphere: {radius: 1}}, held: "
           "true}, {name: b, "
           "frame: 1, shape: {sphere: {radius: 1}}, held: true}]}\n",
           3, 104, "second link"},
          {"  - {name: arm, file: two.mech, reaction: {torque: {limit: [1, 2, 3]}}}\n", 3, 43, "3"},
          {"  - {name: arm, file: two.mech, reaction: {hold: {frequency: 0}}}\n", 3, 62, "frequency"},
          {"  - {name: arm, file: two.mech, reaction: {repulsion: {range: 0.1, stop_distance: 0.2}}}\n", 3,
           55, "less than the `range`"},
          {"  - {name: arm, file: arm.mech, motion: no.csv}\n", 3, 41, "no.csv"},
          {"  - {name: arm, file: arm.mech, base: {xyz: 1}}\n", 3, 45, "list of 3 numbers"},
          {"  - {name: arm, file: arm.mech, links: [{name: l, mesh: a.stl}]}\n", 3, 41, "`frame`"},
          {"  - {name: arm, file: arm.mech, links: [{name: l, frame: -1, mesh: a.stl}]}\n", 3, 58, "`-1`"},
          {"  - {name: arm, file: arm.mech, links: [{name: l, frame: wrist, mesh: a.stl}]}\n", 3, 58,
           "`wrist` for `frame`, expected 0 or a frame"},
          {"  - {name: arm, file: arm.mech, links: [{name: l, frame: 1, mesh: b.stl}]}\n", 3, 67, "b.stl"},
          {"  - name: arm\n    file: arm.mech\n    links:\n      - {name: l, frame: 1, mesh: a.stl}\n"
           "      - {name: l, frame: 2, mesh: a.stl}\n",
           7, 16, "already used"},
      });
}

TEST(SceneErrors, RejectsBadHumans) {
  expectRefused(
      kHuman,
      {
          {"  - {height: 1.8}\n", 3, 5, "found no `name`"},
          {"  - {name: p, height: 180}\n", 3, 23, "from 0.5 to 2.5 m"},
          {"  - {name: p, mass: 1}\n", 3, 21, "kg"},
          {"  - {name: p, sex: x}\n", 3, 20, "one of f, m"},
          {"  - {name: p, percentile: 0}\n", 3, 27, "from 1 to 99 %"},
          {"  - {name: p, percentile: 99.5}\n", 3, 27, "from 1 to 99 %"},
          {"  - {name: p, percentile: most}\n", 3, 27, "finite number"},
          {"  - {name: p, preset: thesis, percentile: 95}\n", 3, 43, "preset anthropometric"},
          {"  - {name: p, mass: 20, percentile: 95}\n", 3, 37, "body mass index"},
          {"  - {name: p, height: 0.4, percentile: 95}\n", 3, 23, "from 0.5 to 2.5 m"},
          {"  - {name: p, preset: thesys}\n", 3, 23, "did you mean `thesis`?"},
          {"  - {name: p, lengths: yes}\n", 3, 24, "model, recording"},
          {"  - {name: p, clamped: [hand_left, paw]}\n", 3, 36, "found `paw` in `clamped`"},
          {"  - {name: p, clamped: hand_left}\n", 3, 24, "list"},
          {"  - {name: p, clothing: gloves}\n", 3, 25, "expected a map"},
          {"  - {name: p, clothing: {preset: glove}}\n", 3, 34, "did you mean `gloves`?"},
          {"  - {name: p, clothing: {preset: [gloves, tie]}}\n", 3, 43, "one of work_clothes"},
          {"  - {name: p, clothing: {hand: 0.01}}\n", 3, 26, "hand"},
          {"  - {name: p, clothing: {head: 0.5}}\n", 3, 32, "from 0 to 0.2 m"},
          {"  - {name: p, tools: {name: t}}\n", 3, 22, "list"},
          {"  - {name: p, tools: [{name: t, shape: {sphere: {radius: 1}}}]}\n", 3, 23, "found no `hand`"},
          {"  - {name: p, tools: [{name: t, hand: both}]}\n", 3, 39, "one of left, right"},
          {"  - {name: p, tools: [{name: t, hand: left}]}\n", 3, 23, "neither `mesh` and `shape`"},
          {"  - {name: p, tools: [{name: a/b, hand: left}]}\n", 3, 30, "slash"},
          {"  - {name: p, tools: [{name: t, hand: left, mesh: no.stl}]}\n", 3, 51, "no.stl"},
          {"  - {name: p, tools: [{name: t, hand: left, mesh: a.stl}, {name: t, hand: left, mesh: a.stl}]}\n",
           3, 59, "already used"},
          {"  - {name: p, parts: {hand_leftt: {}}}\n", 3, 23, "did you mean `hand_left`?"},
          {"  - {name: p, parts: {hand_left: {contuor: 1}}}\n", 3, 35, "did you mean `contour`?"},
          {"  - {name: p, parts: {hand_left: {contour: -1}}}\n", 3, 44, "contour"},
          {"  - {name: p, parts: {hand_left: {shape: sphere}}}\n", 3, 42, "ellipsoid, cuboid"},
          {"  - {name: p, parts: {hand_left: 1}}\n", 3, 34, "expected a map"},
          {"  - {name: p, recording: a.bvh}\n", 3, 26, "expected a map"},
          {"  - {name: p, recording: {}}\n", 3, 26, "found no `file`"},
          {"  - {name: p, recording: {file: none.bvh}}\n", 3, 33, "none.bvh"},
          {"  - {name: p, recording: {file: a.stl, up: w}}\n", 3, 44, "one of auto, x"},
          {"  - {name: p, recording: {file: a.stl, units: -1}}\n", 3, 47, "`units`"},
          {"  - {name: p, recording: {file: a.stl, rate: 0}}\n", 3, 46, "`rate`"},
          {"  - {name: p, recording: {file: a.stl, mirror: x}}\n", 3, 48, "one of none, axes"},
          {"  - {name: p, recording: {file: a.stl, joint_map: no.map}}\n", 3, 51, "no.map"},
          {"  - {name: p, recording: {file: a.stl, marker_set: no.markers}}\n", 3, 52, "auto, none or a"},
          {"  - {name: p, recording: {file: a.stl, place: {yaw: left}}}\n", 3, 53, "finite number"},
          {"  - {name: p}\n  - {name: p}\n", 4, 12, "already used"},
          {"  - {name: p}\nobjects:\n  - {name: p/head, shape: {sphere: {radius: 1}}}\n", 5, 12,
           "already used"},
      });
}

TEST(SceneErrors, RejectsBadPairsAndThreads) {
  expectRefused(
      "abstand: 1\nobjects: [{name: aa, shape: {sphere: {radius: 1}}}, {name: bb, shape: {sphere: {radius: "
      "1}}}]\n",
      {
          {"pairs: []\n", 3, 8, "expected a map"},
          {"pairs: {default: al}\n", 3, 18, "did you mean `all`?"},
          {"pairs: {adjacent: maybe}\n", 3, 19, "exclude, include"},
          {"pairs: {exclude: [aa, bb]}\n", 3, 19, "expected a list"},
          {"pairs: {exclude: [[aa]]}\n", 3, 19, "expected two names"},
          {"pairs: {exclude: [[aa, bb, aa]]}\n", 3, 19, "a list of 3"},
          {"pairs: {include: [[aa, bx]]}\n", 3, 24, "did you mean `bb`?"},
          {"pairs: {include: [[aa, aa]]}\n", 3, 19, "with itself"},
          {"threads: 4\n", 3, 10, "`auto` or a list"},
          {"threads: [[aa, bb]]\n", 3, 12, "expected a list"},
          {"threads: [[]]\n", 3, 11, "empty group"},
          {"threads: [[[aa, bb]], [[bb, aa]]]\n", 3, 24, "a second time"},
          {"threads: [[[aa, zz]]]\n", 3, 17, "name of a body"},
      });
}

TEST(SceneErrors, RejectsHugeAndNestedInput) {
  SourcePos pos;
  const std::string head = "abstand: 1\nobjects: ";
  for (const char* open : {"[", "{a: ", "- "}) {
    std::string deep = head + (*open == '-' ? "\n" : "");
    for (int i = 0; i < 100000; ++i) deep += open;
    EXPECT_NE(errorOf(deep, pos), "") << open;
  }
  EXPECT_NE(errorOf(head + std::string(40, '['), pos).find("levels"), std::string::npos);

  std::string bomb = "abstand: 1\na0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 12; ++i) {
    const auto before = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int k = 0; k < 10; ++k) bomb += before + (k < 9 ? ", " : "]\n");
  }
  EXPECT_NE(errorOf(bomb, pos).find("more than 200000 values"), std::string::npos);
  EXPECT_LE(pos.line, 8);

  std::string many = head + "[";
  for (int i = 0; i < config::kMaxYamlNodes; ++i) many += "1,";
  EXPECT_NE(errorOf(many, pos).find("more than 200000 values"), std::string::npos);
  EXPECT_NE(errorOf(head + std::string(config::kMaxYamlBytes, ' '), pos).find("bytes"), std::string::npos);

  std::string crowd = "abstand: 1\nobjects:\n";
  for (int i = 0; i < 1001; ++i)
    crowd += "- {name: o" + std::to_string(i) + ", shape: {sphere: {radius: 1}}}\n";
  EXPECT_NE(errorOf(crowd, pos).find("more than 1000 bodies"), std::string::npos);
  EXPECT_EQ(pos.line, 1003);
}

TEST(SceneErrors, MessageIsOneLineAndHint) {
  SourcePos pos;
  const auto message = errorOf("abstand: 1\nobjekts: []\n", pos);
  EXPECT_NE(
      message.find("scene.yaml:2:1: error: found the unknown key `objekts` in the scene, expected one of"),
      std::string::npos)
      << message;
  EXPECT_NE(message.find("\nhint: did you mean `objects`?"), std::string::npos) << message;
}

}  // namespace scene_errors_test
}  // namespace abstand::scene_file
