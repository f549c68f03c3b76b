// Marker sets: what is read, what is refused, and where markers are put.
#include "tracking/markers/marker_set.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/base/data_folder.hpp"
#include "core/base/error.hpp"
#include "core/base/text_file.hpp"

namespace abstand::tracking {
namespace marker_set_test {

const BodyRig& rig() {
  static const BodyRig made = makeRig(humanmodel::makeHuman({}));
  return made;
}

std::string errorOf(const std::string& text) {
  try {
    parseMarkerSet(text, "s.markers");
  } catch (const ParseError& e) {
    return e.what();
  }
  return "none";
}

TEST(MarkerSet, ReadsPositionsAndSpreads) {
  const MarkerSet set = parseMarkerSet(
      "# a comment\nname: Mine\nprefix: subject_\nrequires: LKNE\n\nLKNE | L.Knee: thigh_left 0 0.5 1.0 "
      "0.015\r\n"
      "LWRA + LWRB: forearm_left 0 0 1\n",
      "s.markers");
  EXPECT_EQ(set.name, "Mine");
  ASSERT_EQ(set.markers.size(), 2u);
  EXPECT_EQ(set.markers[0].names, (std::vector<std::string>{"LKNE", "L.Knee"}));
  EXPECT_EQ(set.markers[0].segment, RigSegment::kThighLeft);
  EXPECT_EQ(set.markers[0].place, Vector3d(0, 0.5, 1.0));
  EXPECT_DOUBLE_EQ(set.markers[0].spread, 0.015);
  EXPECT_DOUBLE_EQ(set.markers[1].spread, 0.02);
}

TEST(MarkerSet, ReportsErrorsWithPosition) {
  EXPECT_EQ(errorOf("name: A\nLKNE: tigh_left 0 0 0\n"),
            "s.markers:2:7: error: found 'tigh_left', expected a segment of the body\n"
            "hint: did you mean 'thigh_left'?");
  EXPECT_EQ(errorOf("name: A\nLKNE: thigh_left 0 0 far\n"),
            "s.markers:2:22: error: found 'far', expected a number from -5 to 5");
  EXPECT_EQ(errorOf("name: A\nLKNE: thigh_left 0 0 1 7\n"),
            "s.markers:2:24: error: found '7', expected a number from 0.001 to 0.5");
  EXPECT_EQ(errorOf("name: A\nLKNE: thigh_left 0 0\n"),
            "s.markers:2:7: error: found 3 words, expected 'LABEL: SEGMENT FORWARD OUTWARD ALONG [SPREAD]'");
  EXPECT_EQ(errorOf("name: A\nLKNE: head 0 0 1\nlkne: head 0 0 1\n"),
            "s.markers:3:1: error: found 'lkne' a second time, expected it once");
  EXPECT_EQ(errorOf("LKNE: head 0 0 1\n"),
            "s.markers: error: found no 'name:' line, expected the set's name");
  EXPECT_EQ(errorOf("name: A\n"), "s.markers: error: found no marker, expected at least one");
  EXPECT_EQ(errorOf("name: A\nnonsense\n"), "s.markers:2:1: error: found 'nonsense', expected 'key: value'");
}

TEST(MarkerSet, AnyDamagedSetIsReadOrRejected) {
  const std::string text = readFile(dataFolder() / "marker_sets" / "motek.markers");
  std::mt19937_64 random(9);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string spoiled = text;
    for (std::uint64_t k = 1 + random() % 4; k > 0; --k) {
      const std::size_t at = random() % spoiled.size();
      if (random() % 3 == 0)
        spoiled.erase(at, random() % 40);
      else
        spoiled[at] = static_cast<char>(random());
    }
    try {
      const MarkerSet set = parseMarkerSet(spoiled, "s");
      for (const auto& marker : set.markers) {
        EXPECT_TRUE(marker.place.allFinite());
        EXPECT_GT(marker.spread, 0.0);
      }
      const std::vector<std::string> names{"LFWT", "RFWT", "LKNE"};
      matchMarkers(set, rig(), names);
    } catch (const ParseError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 500);
}

TEST(MarkerSet, PositionsMirrorAndScaleWithJoints) {
  const MarkerSet set = parseMarkerSet(
      "name: A\nL: calf_left 0 0.5 1\nR: calf_right 0 0.5 1\nT: foot_left 1 0 1\nM: pelvis 0 0.5 0\n",
      "s.markers");
  const std::vector<std::string> names{"M", "T", "R", "L"};
  const MarkerMatch match = matchMarkers(set, rig(), names);
  ASSERT_EQ(match.markers.size(), 4u);
  const Vector3d left = match.markers[0].p_S, right = match.markers[1].p_S;
  EXPECT_LT((left - Vector3d(right.x(), -right.y(), right.z())).norm(), 1e-12);
  EXPECT_GT(left.y(), 0.0);
  EXPECT_NEAR(left.z(), rig()[RigSegment::kFootLeft].p_parent.z(), 1e-12);
  const Vector3d toe = rig().p_joint[static_cast<std::size_t>(humanmodel::Joint::kToeLeft)];
  EXPECT_NEAR(match.markers[2].p_S.x(), toe.x(), 1e-12);
  EXPECT_NEAR(match.markers[2].p_S.z(), toe.z(), 1e-12);
  EXPECT_GT(match.markers[3].p_S.y(), 0.0);
  EXPECT_EQ(match.markers[0].points, std::vector<int>{3});
}

TEST(MarkerSet, ChoosesSetWithMostMarkers) {
  const auto sets = loadMarkerSets(dataFolder() / "marker_sets");
  ASSERT_GE(sets.size(), 6u);
  for (const auto& set : sets) {
    SCOPED_TRACE(set.name);
    std::vector<std::string> names;
    for (const auto& marker : set.markers) {
      std::string name = marker.names.front();
      if (const auto plus = name.find(" + "); plus != std::string::npos) {
        names.push_back(name.substr(0, plus));
        name = name.substr(plus + 3);
      }
      names.push_back("subject:" + name);
    }
    const auto match = chooseMarkerSet(sets, rig(), names);
    ASSERT_TRUE(match.has_value());
    EXPECT_EQ(match->set, set.name);
    EXPECT_EQ(match->markers.size(), set.markers.size());
    EXPECT_TRUE(match->not_found.empty());
  }
  const std::vector<std::string> few{"LASI", "RASI", "LKNE", "LANK", "C7"};
  EXPECT_FALSE(chooseMarkerSet(sets, rig(), few).has_value());
}

}  // namespace marker_set_test
}  // namespace abstand::tracking
