// Every pair of a scene is in exactly one group.
#include "app/session/pair_groups.hpp"

#include <gtest/gtest.h>

#include <set>

namespace abstand::session {
namespace pair_groups_test {

class PairGroups : public ::testing::Test {
 protected:
  PairGroups() {
    const auto ball = structure::buildHapticStructure("ball", geometry::makeSurface(geometry::Sphere{0.05}),
                                                      {.voxel_size = 0.02, .point_spacing = 0.02});
    const auto add = [&](const char* name, const char* group) { scene_.addObject({name, group, ball, 0.0}); };
    add("l1", "left");
    add("l2", "left");
    add("p/hand", "p");
    add("table", "objects");
    for (std::uint32_t a = 0; a < 4; ++a)
      for (std::uint32_t b = a + 1; b < 4; ++b) scene_.addPair(ObjectId(a), ObjectId(b));
  }

  std::vector<PairGroup> make(const scene_file::ThreadGroups& threads) {
    remarks_.clear();
    std::vector<PairGroup> groups = makePairGroups(scene_, threads, remarks_);
    std::set<std::uint32_t> seen;
    std::set<std::string> names;
    for (const PairGroup& g : groups) {
      EXPECT_TRUE(names.insert(g.name).second) << g.name;
      for (const PairId id : g.pairs) EXPECT_TRUE(seen.insert(id.index()).second) << id.index();
    }
    EXPECT_EQ(seen.size(), scene_.pairs().size());
    return groups;
  }

  scene::Scene scene_;
  std::vector<std::string> remarks_;
};

TEST_F(PairGroups, UnlistedPairsFormGroupRest) {
  const auto groups = make({{{"l1", "p/hand"}}, {{"table", "l1"}, {"l2", "p/hand"}}});
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].name, "group 1");
  EXPECT_EQ(groups[1].pairs.size(), 2u);
  EXPECT_EQ(groups[2].name, "rest");
  EXPECT_EQ(groups[2].pairs.size(), 3u);
  ASSERT_EQ(remarks_.size(), 1u);
  EXPECT_EQ(remarks_[0],
            "threads: 3 of 6 pairs are in no group, the first is `l1`, `l2`: they run in the group `rest`");
}

TEST_F(PairGroups, NoRemarkIfAllPairsAreListed) {
  const auto groups = make({{{"l1", "l2"}, {"l1", "p/hand"}, {"l1", "table"}},
                            {{"l2", "p/hand"}, {"l2", "table"}, {"p/hand", "table"}}});
  EXPECT_EQ(groups.size(), 2u);
  EXPECT_TRUE(remarks_.empty());
}

TEST_F(PairGroups, RemarksListedPairsThatAreNotChecked) {
  const auto groups = make({{{"l1", "nobody"}, {"l1", "l2"}}});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].pairs.size(), 1u);
  ASSERT_EQ(remarks_.size(), 2u);
  EXPECT_EQ(remarks_[0],
            "threads: 1 of the named pairs are not checked in this scene, the first is `l1`, `nobody`");
}

TEST_F(PairGroups, DefaultGroupsFollowBodies) {
  const auto groups = make({});
  ASSERT_EQ(groups.size(), 4u);
  EXPECT_EQ(groups[0].name, "left - left");
  EXPECT_EQ(groups[1].name, "left - p");
  EXPECT_EQ(groups[1].pairs.size(), 2u);
  EXPECT_EQ(groups[2].name, "left - objects");
  EXPECT_EQ(groups[3].name, "p - objects");
}

}  // namespace pair_groups_test
}  // namespace abstand::session
