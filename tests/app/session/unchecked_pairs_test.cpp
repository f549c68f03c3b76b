// Every two bodies of a scene are a pair, or the outline says why not.
#include "app/session/unchecked_pairs.hpp"

#include <gtest/gtest.h>

#include "app/scene_file/pair_selection.hpp"

namespace abstand::session {
namespace unchecked_pairs_test {

using view::UncheckedReason;

/// Two links, two parts of a person, two things.
view::SceneOutline outlineOf(const scene_file::PairsDescription& rules,
                             const std::vector<std::pair<int, int>>& adjacent) {
  view::SceneOutline outline;
  outline.objects = {{"arm/1", "arm", false, true},  {"arm/2", "arm", false, true},
                     {"p/head", "p", true, true},    {"p/torso", "p", true, true},
                     {"a", "objects", false, false}, {"b", "objects", false, false}};
  std::vector<scene_file::SelectableBody> bodies;
  for (const auto& object : outline.objects) bodies.push_back({object.name, object.group, object.human});
  outline.pairs = scene_file::selectPairs(bodies, rules, adjacent);
  addUnchecked(rules, adjacent, outline);
  return outline;
}

const view::UncheckedPair* find(const view::SceneOutline& outline, int a, int b) {
  for (const view::UncheckedPair& pair : outline.unchecked)
    if (pair.a == a && pair.b == b) return &pair;
  return nullptr;
}

TEST(UncheckedPairs, ComplementCheckedPairs) {
  scene_file::PairsDescription rules;
  rules.dropped = {{"a", "p/head", "never near"}, {"p/torso", "a", ""}};
  rules.exclude = {{"arm/1", "b"}, {"arm/2", "b"}};
  rules.include = {{"b", "arm/2"}};
  const view::SceneOutline outline = outlineOf(rules, {{0, 1}, {2, 3}});
  EXPECT_EQ(outline.pairs.size() + outline.unchecked.size(), 15u);
  ASSERT_TRUE(find(outline, 0, 1));
  EXPECT_EQ(find(outline, 0, 1)->reason, UncheckedReason::kAdjacent);
  EXPECT_EQ(find(outline, 2, 3)->reason, UncheckedReason::kAdjacent);
  ASSERT_TRUE(find(outline, 2, 4));
  EXPECT_EQ(find(outline, 2, 4)->reason, UncheckedReason::kListed);
  ASSERT_EQ(find(outline, 2, 4)->note, 0);
  EXPECT_EQ(outline.unchecked_notes, std::vector<std::string>{"never near"});
  ASSERT_TRUE(find(outline, 3, 4));
  EXPECT_EQ(find(outline, 3, 4)->note, -1);
  ASSERT_TRUE(find(outline, 0, 5));
  EXPECT_EQ(find(outline, 0, 5)->reason, UncheckedReason::kExcluded);
  EXPECT_FALSE(find(outline, 1, 5)) << "`include` wins";
  EXPECT_EQ(outline.unchecked.size(), 5u);
}

TEST(UncheckedPairs, AreSelfPairsAndGroupPairsByDefault) {
  scene_file::PairsDescription rules;
  const view::SceneOutline all = outlineOf(rules, {});
  ASSERT_EQ(all.unchecked.size(), 1u);
  EXPECT_EQ(all.unchecked[0].reason, UncheckedReason::kOnePerson);
  rules.standard = scene_file::PairDefault::kBetweenGroups;
  const view::SceneOutline between = outlineOf(rules, {});
  ASSERT_EQ(between.unchecked.size(), 3u);
  EXPECT_EQ(find(between, 0, 1)->reason, UncheckedReason::kOneGroup);
  EXPECT_EQ(find(between, 2, 3)->reason, UncheckedReason::kOnePerson);
  EXPECT_EQ(find(between, 4, 5)->reason, UncheckedReason::kOneGroup);
  rules.standard = scene_file::PairDefault::kNone;
  rules.include = {{"arm/1", "p/head"}};
  const view::SceneOutline one = outlineOf(rules, {});
  EXPECT_EQ(one.unchecked.size(), 14u);
  EXPECT_EQ(find(one, 0, 4)->reason, UncheckedReason::kExcluded);
}

}  // namespace unchecked_pairs_test
}  // namespace abstand::session
