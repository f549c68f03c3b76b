// Exposure against closed forms and brute force.
#include <gtest/gtest.h>

#include <map>

#include "app/report/body_heat_picture.hpp"
#include "app/report/room_heat_picture.hpp"
#include "app/tune/exposure_table.hpp"
#include "app/tune/result_file.hpp"
#include "core/margin/margin_outcome.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "humanmodel/body_cells.hpp"
#include "humanmodel/poser.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::tune {
namespace exposure_test {

constexpr double kEngine = 2e-3;  // m, of certified clearances: distance and its bound
constexpr double kFrame = 0.01;   // s, of the recordings here
constexpr double kSums = 1e-9;    // s, of sums in another order
constexpr double kRobot = 0.5;    // m/s
constexpr double kStart = -2.4, kRadius = 0.05, kHeight = 1.2;  // m, of the ball
constexpr double kBall = 0.2;  // m, way of the nearest point over the ball, at most

std::size_t partIndex(const TunedRecording& tuned, const std::string& name) {
  for (std::size_t p = 0; p < tuned.pass.parts.size(); ++p)
    if (tuned.pass.parts[p].part == name) return p;
  throw std::runtime_error(name);
}

TunedRecording tuneSlide(const testing::SlideSpeeds& speeds, TuneOptions options = {}) {
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, speeds);
  return tuneRecording(*session, options, {}, "slide");
}

/// The ball drives up to the person and into them.
const TunedRecording& driven() {
  static const TunedRecording tuned = tuneSlide({.robot = kRobot, .seconds = 5.0});
  return tuned;
}

/// The torso of the person who stands at the origin, exactly.
struct Torso {
  humanmodel::HumanModel human{humanmodel::makeHuman({})};
  humanmodel::HumanPose pose;
  Torso() { humanmodel::Poser(human).pose(human.rest, pose); }
  const humanmodel::HumanPart& part() const { return human.part(humanmodel::BodyPart::kTorso); }
  geometry::ShapeDistance to(const Vector3d& p_W) const {
    return geometry::distanceTo(part().shape,
                                pose.X_WP[humanmodel::index(humanmodel::BodyPart::kTorso)].inverse() * p_W);
  }
};

Vector3d ballAt(double t) { return {kStart + kRobot * t, 0.0, kHeight}; }

void expectSame(const margin::ExposureTime& a, const margin::ExposureTime& b, double tolerance,
                const std::string& what) {
  for (std::size_t i = 0; i < a.below.size(); ++i)
    EXPECT_NEAR(a.below[i], b.below[i], tolerance) << what << i;
  EXPECT_NEAR(a.weighted, b.weighted, tolerance) << what;
}

TEST(ExposureTime, CountsBandsAndWeightsByDepth) {
  margin::ExposureTime e;
  e.add(0.15, 2.0);
  EXPECT_EQ(e.below, (std::array<double, 5>{0.0, 0.0, 0.0, 2.0, 2.0}));
  EXPECT_DOUBLE_EQ(e.weighted, 2.0 * 0.7);
  e.add(-0.3, 1.0);
  EXPECT_EQ(e.below, (std::array<double, 5>{1.0, 1.0, 1.0, 3.0, 3.0}));
  EXPECT_DOUBLE_EQ(e.weighted, 2.4) << "a contact counts once, however deep";
  e.add(0.0, 1.0);
  EXPECT_EQ(e.below[0], 1.0) << "not below 0";
  e.add(0.5, 1.0);
  e.add(kInfinity, 1.0);
  EXPECT_EQ(e.below[4], 4.0);
  EXPECT_TRUE(margin::isExposureKnown(0.5, 9.0)) << "certainly far away";
  EXPECT_TRUE(margin::isExposureKnown(0.1, 0.4));
  EXPECT_FALSE(margin::isExposureKnown(0.1, 0.5));
  EXPECT_FALSE(margin::isExposureKnown(-kInfinity, 0.0));
}

TEST(Exposure, MovingBallMatchesClosedFormPerBand) {
  const Torso torso;
  const Exposure& e = driven().pass.exposure.parts[partIndex(driven(), "torso")];
  // The least distance falls with the ball's speed where the torso is straight behind it, which it is to
  // within its curvature.
  for (std::size_t b = 0; b < margin::kExposureBands.size(); ++b) {
    double expected = 0.0;
    for (double t = 0.5 * kFrame; t < 5.0; t += kFrame)
      if (torso.to(ballAt(t)).distance - kRadius < margin::kExposureBands[b]) expected += kFrame;
    EXPECT_GT(expected, 0.3);
    EXPECT_NEAR(e.spent.below[b], expected, 2.0 * kFrame + kEngine / kRobot) << b;
  }
  double weighted = 0.0;
  for (double t = 0.5 * kFrame; t < 5.0; t += kFrame)
    weighted += kFrame * std::clamp(1.0 - (torso.to(ballAt(t)).distance - kRadius) / 0.5, 0.0, 1.0);
  EXPECT_NEAR(e.spent.weighted, weighted, kFrame + 2.0 * kEngine);
  EXPECT_NEAR(e.closing, kRobot, kEngine);
  EXPECT_EQ(e.not_seen, 0.0);
  EXPECT_NEAR(e.time, 5.0, kSums);
}

TEST(Exposure, EqualsIntrusionTimeAtMarginOfBand) {
  for (std::size_t p = 0; p < driven().pass.parts.size(); ++p) {
    const PartClearance& part = driven().pass.parts[p];
    for (std::size_t b = 0; b < margin::kExposureBands.size(); ++b)
      EXPECT_NEAR(driven().pass.exposure.parts[p].spent.below[b],
                  margin::outcome(part.track, margin::kExposureBands[b], {}).stopped_time, kSums)
          << part.part << b;
    EXPECT_EQ(driven().pass.exposure.parts[p].min_clearance,
              *std::min_element(part.track.clearance.begin(), part.track.clearance.end()));
  }
}

TEST(Exposure, CellsSumToPart) {
  std::map<std::size_t, margin::ExposureTime> sums;
  for (const BodyCell& c : driven().pass.exposure.body_cells) sums[c.part].add(c.spent);
  for (std::size_t p = 0; p < driven().pass.parts.size(); ++p)
    expectSame(sums[p], driven().pass.exposure.parts[p].spent, kSums, driven().pass.parts[p].part);
}

TEST(Exposure, LiesAtNearestPoint) {
  // Up to 30 mm before the torso: inside, nearest points of overlapping bodies are others.
  const TunedRecording tuned = tuneSlide({.robot = kRobot, .seconds = 4.35});
  const Torso torso;
  const auto half = Vector3d(0.5 * geometry::bounds(torso.part().shape).extent());
  // rad: half a cell's diagonal, and what the engine's point may be off.
  constexpr double kCell = 0.19;
  std::size_t torso_cells = 0;
  for (const BodyCell& c : tuned.pass.exposure.body_cells) {
    if (tuned.pass.parts[c.part].part != "torso") continue;
    ++torso_cells;
    EXPECT_EQ(humanmodel::cellPlace(c.cell).substr(0, 4), "back") << "the person faces the other way";
    double nearest = kInfinity;
    for (double t = 3.0; t < 4.36; t += kFrame) {
      const Vector3d u = torso.to(ballAt(t)).nearest.cwiseQuotient(half).normalized();
      nearest = std::min(nearest, std::acos(std::min(1.0, u.dot(humanmodel::cellMiddle(c.cell)))));
    }
    EXPECT_LT(nearest, kCell);
  }
  EXPECT_GT(torso_cells, 0u);
  for (const FloorCell& c : tuned.pass.exposure.floor_cells) {
    const double x = (c.x + 0.5) * kFloorCell, y = (c.y + 0.5) * kFloorCell;
    if (c.layer == FloorLayer::kRobots) {
      EXPECT_LT(std::abs(y), kRadius + kFloorCell);
      EXPECT_GT(x, kStart + kRobot * 2.5 - kBall);
      EXPECT_LT(x, kStart + kRobot * 4.35 + kRadius + kFloorCell);
    } else {
      EXPECT_LT(std::abs(x), 0.3);
      EXPECT_LT(std::abs(y), 0.4);
    }
  }
}

TEST(Exposure, FloorCellsMatchBruteForce) {
  std::map<std::tuple<int, int, int>, margin::ExposureTime> expected;
  std::vector<std::pair<double, std::map<std::tuple<int, int, int>, double>>> frames;
  TuneOptions options;
  options.pass.on_frame = [&](const SettledFrame& settled, const PassResult& names) {
    const WindowFrame& frame = settled.frame;
    std::map<std::tuple<int, int, int>, double> now;
    for (std::size_t part = 0; part < names.parts.size(); ++part) {
      // One person and one link: one pair a part.
      for (std::size_t p = 0; p < names.pairs.size(); ++p) {
        if (names.pairs[p].part != part || !(frame.clearance[p] < 0.5)) continue;
        for (const int layer : {0, 1}) {
          const Vector3d& at = layer == 0 ? frame.on_part[p] : frame.on_link[p];
          const std::tuple key{layer, static_cast<int>(std::floor(at.x() / kFloorCell)),
                               static_cast<int>(std::floor(at.y() / kFloorCell))};
          double& least = now.try_emplace(key, kInfinity).first->second;
          least = std::min(least, frame.clearance[p]);
        }
      }
    }
    frames.emplace_back(frame.t, now);
  };
  const TunedRecording tuned = tuneSlide({.robot = kRobot, .person = 0.2, .seconds = 3.5}, options);
  for (std::size_t i = 0; i + 1 < frames.size(); ++i)
    for (const auto& [key, clearance] : frames[i].second)
      expected[key].add(clearance, frames[i + 1].first - frames[i].first);
  ASSERT_EQ(tuned.pass.exposure.floor_cells.size(), expected.size());
  ASSERT_GT(expected.size(), 10u);
  for (const FloorCell& c : tuned.pass.exposure.floor_cells)
    expectSame(c.spent, expected.at({c.layer == FloorLayer::kPeople ? 0 : 1, c.x, c.y}), kSums, "cell");
}

TEST(Exposure, SegmentsSumToWholeBody) {
  for (const double length : {0.3, 1.0, 100.0}) {
    const ExposureTable table = exposureTable({driven()}, length, 0.2);
    EXPECT_EQ(table.phases.size(), static_cast<std::size_t>(std::ceil(5.0 / length)));
    margin::ExposureTime sum;
    double time = 0.0, least = kInfinity;
    std::size_t misses = 0;
    for (const ExposureRow& row : table.phases) {
      sum.add(row.spent);
      time += row.time;
      misses += row.approaches;
      if (row.nearest) least = std::min(least, row.nearest->clearance);
    }
    expectSame(sum, table.body.spent, kSums, "phases");
    EXPECT_NEAR(time, table.body.time, kSums);
    EXPECT_EQ(misses, driven().pass.approaches.size());
    EXPECT_EQ(least, table.body.nearest->clearance);
    EXPECT_NEAR(table.phases.back().closing, kRobot, kEngine);
  }
  // One link: it has what the whole body has.
  const ExposureTable table = exposureTable({driven()}, 1.0, 0.2);
  ASSERT_EQ(table.links.size(), 1u);
  expectSame(table.links[0].spent, table.body.spent, kSums, "link");
  EXPECT_EQ(table.links[0].link, "ball");
  EXPECT_EQ(table.pairs.size(), table.parts.size());
}

TEST(Exposure, TwoRecordingsAddUp) {
  TunedRecording other = tuneSlide({.robot = kRobot, .person = 0.2, .seconds = 3.5});
  other.recording = "other";
  const ExposureTable a = exposureTable({driven()}, 1.0, 0.2), b = exposureTable({other}, 1.0, 0.2),
                      both = exposureTable({driven(), other}, 1.0, 0.2);
  const auto sum = [](margin::ExposureTime x, const margin::ExposureTime& y) {
    x.add(y);
    return x;
  };
  expectSame(both.body.spent, sum(a.body.spent, b.body.spent), kSums, "body");
  EXPECT_NEAR(both.body.time, 8.5, kSums);
  ASSERT_EQ(both.parts.size(), a.parts.size());
  for (std::size_t p = 0; p < both.parts.size(); ++p) {
    expectSame(both.parts[p].spent, sum(a.parts[p].spent, b.parts[p].spent), kSums, both.parts[p].part);
    EXPECT_EQ(both.parts[p].approaches, a.parts[p].approaches + b.parts[p].approaches);
    EXPECT_EQ(both.parts[p].nearest->clearance,
              std::min(a.parts[p].nearest->clearance, b.parts[p].nearest->clearance));
  }
  const auto total = [](const ExposureTable& table) {
    margin::ExposureTime all;
    for (const auto& c : table.body_cells) all.add(c.spent);
    for (const auto& c : table.floor_cells) all.add(c.spent);
    return all;
  };
  expectSame(total(both), sum(total(a), total(b)), kSums, "cells");
}

TEST(Exposure, CountsUnseenTimeSeparately) {
  // From 2 s on nothing is seen of the left arm below the shoulder, the right foot never was.
  const testing::ScratchFolder folder;
  testing::writeSlide(folder, {.robot = kRobot, .seconds = 5.0});
  tracking::Recording recording;
  const humanmodel::SkeletonFrame rest = humanmodel::makeHuman({}).rest;
  for (int i = 0; i <= 500; ++i) {
    humanmodel::SkeletonFrame f = rest;
    f.t = i * kFrame;
    using humanmodel::Joint;
    const auto lose = [&](Joint j) { f.set(j, Vector3d::Constant(kNaN), humanmodel::JointState::kMissing); };
    if (i > 200)
      for (const Joint j : {Joint::kElbowLeft, Joint::kWristLeft, Joint::kHandLeft}) lose(j);
    for (const Joint j : {Joint::kAnkleRight, Joint::kToeRight}) lose(j);
    recording.frames.push_back(f);
  }
  tracking::writeSkeletonCsv(folder.path() / "person.csv", recording);
  session::SessionOptions options;
  options.threads = 1;
  options.cache = false;
  options.rest = 0.0;
  const auto session = depth::openSession(scene_file::loadScene(folder.path() / "slide.yaml"), options);
  const TunedRecording tuned = tuneRecording(*session, {}, {}, "slide");
  const auto of = [&](const char* name) { return tuned.pass.exposure.parts[partIndex(tuned, name)]; };
  const Exposure torso = of("torso"), foot = of("foot_right"), hand = of("hand_left");
  EXPECT_EQ(torso.not_seen, 0.0);
  expectSame(torso.spent, driven().pass.exposure.parts[partIndex(driven(), "torso")].spent, kSums, "torso");
  EXPECT_NEAR(foot.not_seen, 5.0, kSums);
  EXPECT_EQ(foot.spent.weighted, 0.0);
  EXPECT_EQ(foot.min_clearance, kInfinity);
  // The hand could be anywhere as soon as it may have gone half a metre at 2 m/s, and near enough.
  const PartClearance& lost = tuned.pass.parts[partIndex(tuned, "hand_left")];
  double not_seen = 0.0;
  for (std::size_t i = 0; i + 1 < lost.track.frames(); ++i)
    if (lost.track.clearance[i] < 0.5 && lost.uncertainty[i] >= 0.5)
      not_seen += lost.track.t[i + 1] - lost.track.t[i];
  EXPECT_GT(not_seen, 1.0);
  EXPECT_NEAR(hand.not_seen, not_seen, kSums);
  EXPECT_NEAR(tuned.pass.exposure.body.not_seen, 5.0, kSums) << "the foot never was";
  const ExposureTable table = exposureTable({tuned}, 1.0, 0.2);
  margin::ExposureTime sum;
  for (const ExposureRow& row : table.phases) {
    sum.add(row.spent);
    EXPECT_NEAR(row.not_seen, row.time, kSums);
  }
  expectSame(sum, table.body.spent, kSums, "phases");
  EXPECT_NE(report::bodyHeatPicture(table).find("unseen"), std::string::npos);
  EXPECT_EQ(report::bodyHeatPicture(exposureTable({driven()}, 1.0, 0.2)).find("unseen"), std::string::npos);
}

TEST(Exposure, RoundTripsThroughFile) {
  const testing::ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "result.h5";
  ContentHash hash;
  ResultWriter(file, hash.value()).commit(driven(), {});
  const PassExposure &a = driven().pass.exposure, b = readResult(file).tuned.pass.exposure;
  ASSERT_EQ(a.pairs.size(), b.pairs.size());
  ASSERT_EQ(a.body_cells.size(), b.body_cells.size());
  ASSERT_EQ(a.floor_cells.size(), b.floor_cells.size());
  ASSERT_EQ(a.outlines.size(), b.outlines.size());
  EXPECT_EQ(a.outlines[0].corners, b.outlines[0].corners);
  const auto same = [](const Exposure& x, const Exposure& y) {
    expectSame(x.spent, y.spent, 0.0, "");
    EXPECT_EQ(x.min_clearance, y.min_clearance);
    EXPECT_EQ(x.closing, y.closing);
    EXPECT_EQ(x.not_seen, y.not_seen);
    EXPECT_EQ(x.part, y.part);
  };
  same(a.body, b.body);
  for (std::size_t i = 0; i < a.parts.size(); ++i) same(a.parts[i], b.parts[i]);
  for (std::size_t i = 0; i < a.pairs.size(); ++i) same(a.pairs[i].exposure, b.pairs[i].exposure);
  for (std::size_t i = 0; i < a.body_cells.size(); ++i) {
    EXPECT_EQ(a.body_cells[i].cell, b.body_cells[i].cell);
    expectSame(a.body_cells[i].spent, b.body_cells[i].spent, 0.0, "");
  }
  for (std::size_t i = 0; i < a.floor_cells.size(); ++i) {
    EXPECT_EQ(a.floor_cells[i].x, b.floor_cells[i].x);
    expectSame(a.floor_cells[i].spent, b.floor_cells[i].spent, 0.0, "");
  }
}

TEST(ExposureMesh, HasDefaultPersonAndFloorCells) {
  const testing::ScratchFolder folder;
  const ExposureTable table = exposureTable({driven()}, 1.0, 0.2);
  const mesh_file::ColouredMesh body = report::bodyHeatMesh(table);
  EXPECT_EQ(body.mesh.triangles.size(), 2 * humanmodel::kBodyPartCount * humanmodel::kCellCount);
  // As many values as vertices have; cells of the torso that are not grey are those with exposure.
  EXPECT_EQ(body.values.size(), body.names.size() * body.mesh.vertices.size());
  std::size_t coloured = 0;
  for (const mesh_file::Rgb& c : body.colours) coloured += c != report::HeatScale::colour(-1);
  EXPECT_EQ(coloured, 4 * table.body_cells.size());
  mesh_file::savePly(body, folder.path() / "body.ply");
  const mesh_file::LoadedMesh loaded = mesh_file::loadMesh(folder.path() / "body.ply");
  EXPECT_TRUE(loaded.report.watertight) << "each part is closed, and outside is outside";
  EXPECT_NEAR(geometry::bounds(loaded.mesh).upper.z(), humanmodel::kUsualStature, 0.01);
  const mesh_file::ColouredMesh room = report::roomHeatMesh(table);
  std::size_t people = 0;
  for (const FloorCell& c : table.floor_cells) people += c.layer == FloorLayer::kPeople;
  EXPECT_NEAR(geometry::surfaceArea(room.mesh), static_cast<double>(people) * kFloorCell * kFloorCell, 1e-12);
  for (std::size_t t = 0; t < room.mesh.triangles.size(); ++t) {
    const Vector3d n = (room.mesh.corner(t, 1) - room.mesh.corner(t, 0))
                           .cross(room.mesh.corner(t, 2) - room.mesh.corner(t, 0));
    EXPECT_GT(n.z(), 0.0) << "seen from above";
  }
}

TEST(HeatScale, HasRoundBordersUpToMaximum) {
  const report::HeatScale scale(12.3);
  EXPECT_NEAR(scale.borders().back(), 10.0, 1e-12);
  EXPECT_NEAR(scale.borders().front(), 0.1, 1e-12);
  EXPECT_EQ(scale.classOf(12.3), 7);
  EXPECT_EQ(scale.classOf(10.0), 7);
  EXPECT_EQ(scale.classOf(9.9), 6);
  EXPECT_EQ(scale.classOf(0.01), 0);
  EXPECT_EQ(scale.classOf(0.0), -1);
  for (const double largest : {1e-6, 0.02, 0.05, 0.7, 1.0, 999.0, 1e7}) {
    const report::HeatScale s(largest);
    EXPECT_EQ(s.classOf(largest), 7) << largest;
    EXPECT_LE(s.borders().back(), largest * (1.0 + 1e-9));
    EXPECT_GT(s.borders().back() * 2.6, largest);
    EXPECT_TRUE(std::is_sorted(s.borders().begin(), s.borders().end()));
  }
  EXPECT_TRUE(report::HeatScale(0.0).empty());
}

}  // namespace exposure_test
}  // namespace abstand::tune
