#include "app/scene_file/scene_description.hpp"
#include "core/control/reaction_reader.hpp"

#include <gtest/gtest.h>

#include "core/base/number.hpp"
#include "core/config/yaml_document.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::scene_file {
namespace scene_description_test {

// Angles computed from a matrix and back: a few roundings.
constexpr double kPoseTolerance = 1e-14;

/// A folder with the files that the scenes name.
class SceneFile : public ::testing::Test {
 protected:
  SceneFile() {
    folder_.write("lwr4.mech", "chain\nframe 1 0 0 0 theta\nframe 2 0 90 0 theta\nend_chain\n");
    for (const char* name : {"sweep.csv", "link1.stl", "boxing.bvh", "table.obj", "own.map", "own.markers"})
      folder_.write(name, "x");
  }
  SceneDescription parse(const std::string& text) const {
    return parseScene(text, folder_.path() / "scene.yaml");
  }
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

  testing::ScratchFolder folder_;
};

// The example of the contract, with every key that there is.
const char* const kFull = R"(abstand: 1                              # format version
defaults: {voxel: 0.004, point: 0.006, outer_layers: 15, margin: 0.01, stiffness: 2.0e6, law: thesis, field: layered}
mechanisms:
  - name: left_arm
    file: ./lwr4.mech
    base: {xyz: [0.0, 0.25, 1.2], rpy: [0.1, -0.2, 3.1]}
    q: [0, 0.5, 0, -1.2, 0, 0.8, 0]
    motion: sweep.csv
    links:
      - {name: left_arm/link1, frame: 1, mesh: link1.stl, margin: 0.02, scale: 0.001}
      - name: left_arm/link2
        frame: 2
        shape: {capsule: {radius: 0.06, length: 0}}
        pose: {rpy: [0, 1.5707963267948966, 0]}
        voxel: 0.01
        point: 0.02
        outer_layers: 3
        max_speed: 1.25
  - {name: bare, file: lwr4.mech, max_speed: 0.5}
humans:
  - name: operator
    height: 1.8
    mass: 72.5
    sex: f
    preset: thesis
    lengths: recording
    margin: 0.10
    clothing: {preset: [work_clothes, gloves], hand_left: 0.01}
    tools:
      - {name: driver, hand: right, shape: {cylinder: {radius: 0.01, length: 0.2}}, pose: {xyz: [0.1, 0, 0], rpy: [0, 1.5, 0]}, max_speed: 6}
      - {name: plate, hand: left, mesh: table.obj, scale: 0.001, margin: 0.03}
    parts: {hand_left: {margin: 0.15, contour: 0.24}, torso: {shape: cuboid, breadth: 0.4, voxel: 0.01, max_speed: 1.6}, head: {}}
    recording: {file: boxing.bvh, format: bvh, units: 0.056444, up: -y, rate: 60, mirror: axes, joint_map: own.map, marker_set: own.markers, repair: false, cut_things: true, place: {xyz: [0.9, 0, 0.1], yaw: 3.14}}
  - {name: guest}
objects:
  - {name: table, mesh: table.obj, scale: 0.001, pose: {xyz: [0.6, 0, 0.7], rpy: [0, 0, 0]}}
  - {name: ball, shape: {sphere: {radius: 0.05}}, mass: 0.25, voxel: 0.005, point: 0.005}
  - {name: egg, shape: {ellipsoid: {semi_axes: [0.1, 0.2, 0.3]}}}
  - {name: "box: 1 #2", shape: {cuboid: {size: [1, 2, 3]}}}
  - {name: can, shape: {cylinder: {radius: 0.1, length: 0.2}}}
pairs:
  default: between_groups
  adjacent: include
  exclude: [[left_arm/link1, table], [table, ball]]
  include: [[operator/hand_left, operator/head]]
threads:
  - [[left_arm/link1, ball]]
  - - [left_arm/link2, ball]
    - [left_arm/link2, egg]
skipping: {rest: 0.01, horizon: 2.5, budget: 0.0005}
)";

TEST_F(SceneFile, ReadsEveryKey) {
  const auto s = parse(kFull);
  EXPECT_EQ(s.file, path("scene.yaml"));
  EXPECT_EQ(s.defaults.haptic.voxel_size, 0.004);
  EXPECT_EQ(s.defaults.haptic.point_spacing, 0.006);
  EXPECT_EQ(s.defaults.haptic.outer_layers, 15);
  EXPECT_EQ(s.defaults.haptic.field, structure::FieldKind::kLayered);
  EXPECT_EQ(s.defaults.margin, 0.01);
  EXPECT_EQ(s.defaults.stiffness, 2e6);
  EXPECT_TRUE(s.defaults.thesis_law);

  ASSERT_EQ(s.mechanisms.size(), 2u);
  const auto& arm = s.mechanisms[0];
  EXPECT_EQ(arm.name, "left_arm");
  EXPECT_EQ(arm.pos.line, 4);
  EXPECT_EQ(arm.file, path("lwr4.mech"));
  EXPECT_TRUE(arm.X_WB.isApprox(fromXyzRpy({0.0, 0.25, 1.2}, {0.1, -0.2, 3.1}), 0.0));
  EXPECT_EQ(arm.q, (std::vector<double>{0, 0.5, 0, -1.2, 0, 0.8, 0}));
  EXPECT_EQ(arm.motion, path("sweep.csv"));
  ASSERT_EQ(arm.links.size(), 2u);
  EXPECT_EQ(arm.links[0].frame, "1");
  EXPECT_EQ(arm.links[0].mesh, path("link1.stl"));
  EXPECT_EQ(arm.links[0].scale, Vector3d::Constant(0.001));
  EXPECT_EQ(arm.links[0].settings.margin, 0.02);
  EXPECT_FALSE(arm.links[0].settings.voxel);
  ASSERT_TRUE(arm.links[1].shape);
  EXPECT_EQ(std::get<geometry::Capsule>(*arm.links[1].shape).length, 0.0);
  EXPECT_EQ(arm.links[1].pos.line, 11);
  EXPECT_EQ(arm.links[1].settings.outer_layers, 3);
  EXPECT_EQ(arm.links[1].settings.point, 0.02);
  EXPECT_TRUE(s.mechanisms[1].q.empty());
  EXPECT_TRUE(s.mechanisms[1].motion.empty());

  ASSERT_EQ(s.humans.size(), 2u);
  const auto& h = s.humans[0];
  EXPECT_EQ(h.body.height, 1.8);
  EXPECT_EQ(h.body.mass, 72.5);
  EXPECT_EQ(h.body.sex, humanmodel::Sex::kFemale);
  EXPECT_EQ(h.body.preset, humanmodel::HumanPreset::kThesis);
  EXPECT_TRUE(h.follow_lengths);
  EXPECT_EQ(h.settings.margin, 0.1);
  ASSERT_EQ(h.parts.size(), 3u);
  EXPECT_EQ(h.parts.at(humanmodel::BodyPart::kHandLeft).margin, 0.15);
  EXPECT_FALSE(h.parts.at(humanmodel::BodyPart::kHandLeft).voxel);
  EXPECT_EQ(h.body.overrides.at(humanmodel::BodyPart::kHandLeft).contour, 0.24);
  EXPECT_FALSE(h.body.overrides.at(humanmodel::BodyPart::kHandLeft).length);
  EXPECT_EQ(h.body.overrides.at(humanmodel::BodyPart::kTorso).shape, "cuboid");
  EXPECT_EQ(h.recording.file, path("boxing.bvh"));
  EXPECT_EQ(h.recording.options.format, "bvh");
  EXPECT_EQ(h.recording.options.units, "0.056444");
  EXPECT_EQ(h.recording.options.up, "-y");
  EXPECT_EQ(h.recording.options.rate, 60.0);
  EXPECT_EQ(h.recording.options.mirror, "axes");
  EXPECT_EQ(h.recording.options.joint_map, path("own.map"));
  EXPECT_EQ(h.recording.options.marker_set, path("own.markers"));
  EXPECT_FALSE(h.recording.options.repair);
  EXPECT_EQ(h.recording.cut_things, true);
  EXPECT_EQ(h.recording.place_xyz, Vector3d(0.9, 0, 0.1));
  EXPECT_EQ(h.recording.place_yaw, 3.14);
  EXPECT_TRUE(s.humans[1].recording.file.empty());
  EXPECT_TRUE(s.humans[1].tools.empty());
  EXPECT_TRUE(s.humans[1].body.clothing.empty());
  EXPECT_EQ(h.body.clothing.at(humanmodel::BodyPart::kHandLeft), 0.01) << "thicker than the gloves";
  EXPECT_EQ(h.body.clothing.at(humanmodel::BodyPart::kHandRight), 0.003);
  EXPECT_EQ(h.body.clothing.at(humanmodel::BodyPart::kTorso), 0.015);
  EXPECT_FALSE(h.body.clothing.contains(humanmodel::BodyPart::kHead));
  ASSERT_EQ(h.tools.size(), 2u);
  EXPECT_EQ(h.tools[0].bodyName(h.name), "operator/hand_right/driver");
  EXPECT_EQ(std::get<geometry::Cylinder>(*h.tools[0].shape).length, 0.2);
  EXPECT_TRUE(h.tools[0].X_HT.isApprox(fromXyzRpy({0.1, 0, 0}, {0, 1.5, 0}), 0.0));
  EXPECT_EQ(h.tools[0].settings.max_speed, 6.0);
  EXPECT_EQ(h.tools[1].mesh, path("table.obj"));
  EXPECT_EQ(h.tools[1].scale, Vector3d::Constant(0.001));
  EXPECT_EQ(h.tools[1].settings.margin, 0.03);
  EXPECT_EQ(s.humans[1].body.preset, humanmodel::HumanPreset::kAnthropometric);

  ASSERT_EQ(s.objects.size(), 5u);
  EXPECT_EQ(s.objects[0].mesh, path("table.obj"));
  EXPECT_EQ(s.objects[0].X_WB.translation(), Vector3d(0.6, 0, 0.7));
  EXPECT_EQ(std::get<geometry::Sphere>(*s.objects[1].shape).radius, 0.05);
  EXPECT_EQ(std::get<geometry::Ellipsoid>(*s.objects[2].shape).semi_axes, Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(s.objects[3].name, "box: 1 #2");
  EXPECT_EQ(std::get<geometry::Cuboid>(*s.objects[3].shape).size, Vector3d(1, 2, 3));
  EXPECT_EQ(std::get<geometry::Cylinder>(*s.objects[4].shape).length, 0.2);

  EXPECT_EQ(s.pairs.standard, PairDefault::kBetweenGroups);
  EXPECT_FALSE(s.pairs.exclude_adjacent);
  ASSERT_EQ(s.pairs.exclude.size(), 2u);
  EXPECT_EQ(s.pairs.exclude[1], (std::pair<std::string, std::string>("table", "ball")));
  EXPECT_EQ(s.pairs.exclude_pos[1].line, 44);
  EXPECT_EQ(s.pairs.include[0].second, "operator/head");
  ASSERT_EQ(s.threads.size(), 2u);
  EXPECT_EQ(s.threads[1].size(), 2u);
  EXPECT_EQ(arm.links[1].settings.max_speed, 1.25);
  EXPECT_EQ(s.mechanisms[1].settings.max_speed, 0.5);
  EXPECT_EQ(h.parts.at(humanmodel::BodyPart::kTorso).max_speed, 1.6);
  EXPECT_EQ(s.culling.rest, 0.01);
  EXPECT_EQ(s.culling.horizon, 2.5);
  EXPECT_EQ(s.culling.budget, 0.0005);
}

TEST_F(SceneFile, MinimalSceneHasDefaults) {
  const auto s = parse("abstand: 1\n");
  EXPECT_EQ(s.defaults.haptic.voxel_size, structure::HapticOptions{}.voxel_size);
  EXPECT_EQ(s.defaults.stiffness, 1e6);
  EXPECT_FALSE(s.defaults.thesis_law);
  EXPECT_TRUE(s.mechanisms.empty() && s.humans.empty() && s.objects.empty() && s.threads.empty());
  EXPECT_EQ(s.pairs.standard, PairDefault::kAll);
  EXPECT_TRUE(s.pairs.exclude_adjacent);
}

TEST_F(SceneFile, PathsAreRelativeToTheSceneFileOrAbsolute) {
  std::filesystem::create_directory(path("scenes"));
  const auto text = "abstand: 1\nobjects:\n  - {name: a, mesh: ../table.obj}\n  - {name: b, mesh: \"" +
                    path("link1.stl").string() + "\"}\n";
  const auto s = parseScene(text, path("scenes") / "s.yaml");
  EXPECT_EQ(s.objects[0].mesh, path("table.obj"));
  EXPECT_EQ(s.objects[1].mesh, path("link1.stl"));
}

TEST_F(SceneFile, AliasesAreExpanded) {
  const auto s = parse(
      "abstand: 1\nobjects:\n  - {name: a, shape: &ball {sphere: {radius: 0.1}}}\n  - {name: b, shape: "
      "*ball}\n");
  EXPECT_EQ(std::get<geometry::Sphere>(*s.objects[1].shape).radius, 0.1);
}

TEST_F(SceneFile, LoadReadsTheFile) {
  const auto file = folder_.write("scene.yaml", kFull);
  EXPECT_EQ(describeScene(loadScene(file)), describeScene(parse(kFull)));
  EXPECT_THROW(loadScene(path("none.yaml")), ParseError);
  EXPECT_THROW(loadScene(folder_.path()), ParseError);
}

void expectSame(const BodySettings& a, const BodySettings& b) {
  EXPECT_EQ(a.voxel, b.voxel);
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.margin, b.margin);
  EXPECT_EQ(a.outer_layers, b.outer_layers);
}

std::vector<double> numbersOf(const std::optional<geometry::Shape>& shape) {
  if (!shape) return {};
  const auto of = [](const Vector3d& v) { return std::vector<double>{v.x(), v.y(), v.z()}; };
  struct Numbers {
    decltype(of)& list;
    std::vector<double> operator()(const geometry::Sphere& s) const { return {1, s.radius}; }
    std::vector<double> operator()(const geometry::Ellipsoid& s) const { return list(s.semi_axes); }
    std::vector<double> operator()(const geometry::Cuboid& s) const { return list(s.size); }
    std::vector<double> operator()(const geometry::Cylinder& s) const { return {s.radius, s.length}; }
    std::vector<double> operator()(const geometry::Capsule& s) const { return {s.radius, s.length}; }
  };
  auto numbers = std::visit(Numbers{of}, *shape);
  numbers.push_back(static_cast<double>(shape->index()));
  return numbers;
}

template <class Body>
void expectSameBody(const Body& a, const Body& b) {
  SCOPED_TRACE(a.name);
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.mesh, b.mesh);
  EXPECT_EQ(a.scale, b.scale);
  EXPECT_EQ(numbersOf(a.shape), numbersOf(b.shape));
  expectSame(a.settings, b.settings);
}

void expectSame(const SceneDescription& a, const SceneDescription& b) {
  const double pose_tolerance = 0.0;  // scenes of people have angles of few digits: the same bits
  EXPECT_EQ(a.file, b.file);
  EXPECT_EQ(a.defaults.haptic.voxel_size, b.defaults.haptic.voxel_size);
  EXPECT_EQ(a.defaults.haptic.point_spacing, b.defaults.haptic.point_spacing);
  EXPECT_EQ(a.defaults.haptic.outer_layers, b.defaults.haptic.outer_layers);
  EXPECT_EQ(a.defaults.haptic.field, b.defaults.haptic.field);
  EXPECT_EQ(a.defaults.margin, b.defaults.margin);
  EXPECT_EQ(a.defaults.stiffness, b.defaults.stiffness);
  EXPECT_EQ(a.defaults.thesis_law, b.defaults.thesis_law);
  ASSERT_EQ(a.mechanisms.size(), b.mechanisms.size());
  for (std::size_t i = 0; i < a.mechanisms.size(); ++i) {
    const auto &m = a.mechanisms[i], &n = b.mechanisms[i];
    EXPECT_EQ(m.name, n.name);
    EXPECT_EQ(m.file, n.file);
    ASSERT_EQ(m.reaction.has_value(), n.reaction.has_value());
    if (m.reaction) {
      EXPECT_EQ(control::describeReaction(*m.reaction), control::describeReaction(*n.reaction));
    }
    EXPECT_EQ(m.q, n.q);
    EXPECT_EQ(m.motion, n.motion);
    EXPECT_TRUE(m.X_WB.isApprox(n.X_WB, pose_tolerance));
    ASSERT_EQ(m.links.size(), n.links.size());
    for (std::size_t k = 0; k < m.links.size(); ++k) {
      expectSameBody(m.links[k], n.links[k]);
      EXPECT_EQ(m.links[k].frame, n.links[k].frame);
      EXPECT_EQ(m.links[k].held, n.links[k].held);
      EXPECT_TRUE(m.links[k].X_FL.isApprox(n.links[k].X_FL, pose_tolerance)) << m.links[k].name;
    }
  }
  ASSERT_EQ(a.humans.size(), b.humans.size());
  for (std::size_t i = 0; i < a.humans.size(); ++i) {
    const auto &h = a.humans[i], &g = b.humans[i];
    EXPECT_EQ(h.name, g.name);
    EXPECT_EQ(h.body.height, g.body.height);
    EXPECT_EQ(h.body.mass, g.body.mass);
    EXPECT_EQ(h.body.percentile, g.body.percentile);
    EXPECT_EQ(h.body.sex, g.body.sex);
    EXPECT_EQ(h.body.preset, g.body.preset);
    EXPECT_EQ(h.follow_lengths, g.follow_lengths);
    EXPECT_EQ(h.clamped, g.clamped);
    expectSame(h.settings, g.settings);
    ASSERT_EQ(h.parts.size(), g.parts.size());
    for (const auto& [part, own] : h.parts) {
      SCOPED_TRACE(humanmodel::partName(part));
      ASSERT_TRUE(g.parts.count(part));
      expectSame(own, g.parts.at(part));
      const humanmodel::PartOverride &p = h.body.overrides.at(part), &q = g.body.overrides.at(part);
      EXPECT_EQ(p.length, q.length);
      EXPECT_EQ(p.contour, q.contour);
      EXPECT_EQ(p.breadth, q.breadth);
      EXPECT_EQ(p.depth, q.depth);
      EXPECT_EQ(p.shape, q.shape);
    }
    EXPECT_EQ(h.recording.file, g.recording.file);
    EXPECT_EQ(h.recording.options.format, g.recording.options.format);
    EXPECT_EQ(h.recording.options.units, g.recording.options.units);
    EXPECT_EQ(h.recording.options.up, g.recording.options.up);
    EXPECT_EQ(h.recording.options.rate, g.recording.options.rate);
    EXPECT_EQ(h.recording.options.mirror, g.recording.options.mirror);
    EXPECT_EQ(h.recording.options.joint_map, g.recording.options.joint_map);
    EXPECT_EQ(h.recording.options.marker_set, g.recording.options.marker_set);
    EXPECT_EQ(h.recording.options.repair, g.recording.options.repair);
    EXPECT_EQ(h.recording.cut_things, g.recording.cut_things);
    EXPECT_EQ(h.recording.place_xyz, g.recording.place_xyz);
    EXPECT_EQ(h.recording.place_yaw, g.recording.place_yaw);
  }
  ASSERT_EQ(a.objects.size(), b.objects.size());
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    expectSameBody(a.objects[i], b.objects[i]);
    EXPECT_EQ(a.objects[i].mass, b.objects[i].mass);
    EXPECT_TRUE(a.objects[i].X_WB.isApprox(b.objects[i].X_WB, pose_tolerance)) << a.objects[i].name;
  }
  EXPECT_EQ(a.pairs.standard, b.pairs.standard);
  EXPECT_EQ(a.pairs.exclude_adjacent, b.pairs.exclude_adjacent);
  EXPECT_EQ(a.pairs.exclude, b.pairs.exclude);
  EXPECT_EQ(a.pairs.include, b.pairs.include);
  EXPECT_EQ(a.threads, b.threads);
}

TEST_F(SceneFile, DescribedScenesRoundTrip) {
  for (const char* text :
       {kFull, "abstand: 1\n", "abstand: 1\npairs: {default: none}\nobjects: []\n",
        "abstand: 1\nobjects:\n  - {name: 'null', shape: {sphere: {radius: 1.0e-3}}, margin: 0}\n"
        "  - {name: 12, shape: {sphere: {radius: 0.30000000000000004}}, pose: {xyz: [1e-7, -0.0, 1234.5]}}\n"
        "  - {name: 'Ellbogen \\ links', shape: {sphere: {radius: 2}}, pose: {rpy: [0.3, 1.5708, -2.9]}}\n"
        "  - {name: Tür, shape: {sphere: {radius: 2}}, pose: {rpy: [3.14159265, 0.7853981633974483, 1e-3]}}\n"
        "threads: [[[12, 'null']]]\n"}) {
    const auto scene = parse(text);
    const auto described = describeScene(scene);
    SCOPED_TRACE(described);
    expectSame(scene, parse(described));
    EXPECT_EQ(describeScene(parse(described)), described);
  }
}

TEST_F(SceneFile, PercentileReplacesHeightAndMass) {
  const auto scene = parse(
      "abstand: 1\nhumans:\n  - {name: large, percentile: 95, sex: m}\n"
      "  - {name: heavy, percentile: 97.5, height: 1.8, mass: 95}\n  - {name: usual}\n");
  ASSERT_EQ(scene.humans.size(), 3u);
  const humanmodel::HumanOptions &large = scene.humans[0].body, &heavy = scene.humans[1].body;
  EXPECT_EQ(large.percentile, 95.0);
  EXPECT_FALSE(large.height || large.mass);
  EXPECT_NEAR(humanmodel::makeHuman(large).height, 1.870, 1e-12);
  EXPECT_EQ(heavy.height, 1.8);
  EXPECT_EQ(heavy.mass, 95.0);
  EXPECT_FALSE(scene.humans[2].body.percentile);
  EXPECT_EQ(scene.humans[2].body.height, 1.75);
  const auto described = describeScene(scene);
  EXPECT_NE(described.find("percentile: 95\n"), std::string::npos) << described;
  expectSame(scene, parse(described));
}

TEST_F(SceneFile, ReadsClampedParts) {
  const auto scene =
      parse("abstand: 1\nhumans:\n  - {name: p, clamped: [torso, hand_left]}\n  - {name: q}\n");
  using enum humanmodel::BodyPart;
  EXPECT_EQ(scene.humans[0].clamped, (std::set{kHandLeft, kTorso}));
  EXPECT_TRUE(scene.humans[1].clamped.empty());
  expectSame(scene, parse(describeScene(scene)));
}

TEST_F(SceneFile, ReadsRemovalOfObjectsFromDepthImages) {
  const auto scene = parse(
      "abstand: 1\nhumans:\n  - {name: p, recording: {file: boxing.bvh, cut_things: false}}\n"
      "  - {name: q, recording: {file: boxing.bvh, cut_things: true}}\n"
      "  - {name: r, recording: {file: boxing.bvh}}\n");
  EXPECT_EQ(scene.humans[0].recording.cut_things, false);
  EXPECT_EQ(scene.humans[1].recording.cut_things, true);
  EXPECT_EQ(scene.humans[2].recording.cut_things, std::nullopt);
  expectSame(scene, parse(describeScene(scene)));
}

TEST_F(SceneFile, ReactionRoundTrips) {
  folder_.write("arm.mech",
                "mapping\ndof 0 1\ndof 1 2\nend_mapping\nchain\nframe 1 0 0 0 theta\n"
                "frame 2 0 90 0 theta\nend_chain\n");
  const auto scene = parse(
      "abstand: 1\nmechanisms:\n"
      "  - {name: a, file: arm.mech, reaction: {torque: {limit: [1, 2]}, repulsion: {range: 0.3}, hold: "
      "{frequency: "
      "5}, stop: {distance: 0.1, on: {user: none}}}}\n"
      "  - {name: b, file: arm.mech, reaction: {}}\n  - {name: c, file: arm.mech}\n");
  const auto& m = scene.mechanisms;
  ASSERT_TRUE(m[0].reaction && m[1].reaction);
  EXPECT_FALSE(m[2].reaction);
  EXPECT_EQ(m[0].reaction->torque->limit, (config::JointNumbers{1, 2}));
  EXPECT_EQ(m[0].reaction->repulsion->range, 0.3);
  EXPECT_EQ(m[0].reaction->hold.frequency, 5.0);
  EXPECT_EQ(m[0].reaction->watch.distance, 0.1);
  EXPECT_EQ(m[0].reaction->stop.policy.of(safety::StopReason::kUser), safety::StopResponse::kNone);
  EXPECT_FALSE(m[1].reaction->repulsion);
  expectSame(scene, parse(describeScene(scene)));
}

TEST_F(SceneFile, ShippedScenesRoundTrip) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(testing::projectFile("data/scenes"))) {
    if (entry.path().extension() != ".yaml") continue;
    SCOPED_TRACE(entry.path());
    const auto scene = loadScene(entry.path());
    expectSame(scene, parseScene(describeScene(scene), entry.path()));
    ++scenes;
  }
  EXPECT_GT(scenes, 0);
}

TEST_F(SceneFile, PosesRoundTripWithinRounding) {
  SceneDescription scene;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    ObjectDescription o;
    o.name = "o" + std::to_string(seed);
    o.shape = geometry::Sphere{0.1};
    o.X_WB = testing::randomPose(seed);
    // every third one close to a pitch of 90 degrees, where roll and yaw are one
    if (seed % 3 == 0)
      o.X_WB.linear() =
          fromXyzRpy({0, 0, 0}, {0.1 * static_cast<double>(seed),
                                 (seed % 2 ? 1.0 : -1.0) * kPi / 2 + 1e-9 * static_cast<double>(seed), 1.0})
              .linear();
    scene.objects.push_back(o);
  }
  const auto back = parse(describeScene(scene));
  for (std::size_t i = 0; i < 300; ++i) {
    EXPECT_EQ(back.objects[i].X_WB.translation(), scene.objects[i].X_WB.translation());
    EXPECT_LT((back.objects[i].X_WB.linear() - scene.objects[i].X_WB.linear()).cwiseAbs().maxCoeff(),
              kPoseTolerance)
        << i;
  }
}

TEST(YamlDocument, NodesHavePositions) {
  const auto root = config::parseYaml("# comment\na: [1, 'two']\nb:\n  - {c: ~}\n", "f");
  ASSERT_EQ(root.kind, config::YamlNode::Kind::kMap);
  ASSERT_EQ(root.keys.size(), 2u);
  EXPECT_EQ(root.keys[1].line, 3);
  EXPECT_EQ(root.items[0].line, 2);
  EXPECT_EQ(root.items[0].column, 4);
  EXPECT_FALSE(root.items[0].items[0].quoted);
  EXPECT_TRUE(root.items[0].items[1].quoted);
  EXPECT_EQ(root.items[1].items[0].items[0].kind, config::YamlNode::Kind::kNothing);
}

}  // namespace scene_description_test
}  // namespace abstand::scene_file
