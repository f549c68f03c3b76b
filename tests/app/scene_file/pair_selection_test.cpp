#include "app/scene_file/pair_selection.hpp"

#include <gtest/gtest.h>

namespace abstand::scene_file {
namespace pair_selection_test {

using Pairs = std::vector<std::pair<int, int>>;

// a0, a1, a2 of robot a; h/head, h/torso of person h; table and box, single objects.
const std::vector<SelectableBody> kBodies{{"a0", "a"},       {"a1", "a"},      {"a2", "a"},
                                          {"h/head", "h"},   {"h/torso", "h"}, {"table", "objects"},
                                          {"box", "objects"}};
const Pairs kAdjacent{{0, 1}, {2, 1}, {4, 3}};

PairsDescription rules(PairDefault standard, bool exclude_adjacent = true) {
  PairsDescription r;
  r.standard = standard;
  r.exclude_adjacent = exclude_adjacent;
  return r;
}

TEST(PairSelection, DefaultsGiveExpectedCounts) {
  EXPECT_EQ(selectPairs(kBodies, rules(PairDefault::kAll, false), kAdjacent).size(), 21u);
  EXPECT_EQ(selectPairs(kBodies, rules(PairDefault::kAll), kAdjacent).size(), 18u);
  // 3 x 2 + 3 x 2 + 2 x 2: groups a, h and objects
  EXPECT_EQ(selectPairs(kBodies, rules(PairDefault::kBetweenGroups), kAdjacent).size(), 16u);
  EXPECT_EQ(selectPairs(kBodies, rules(PairDefault::kNone), kAdjacent).size(), 0u);
  EXPECT_TRUE(selectPairs({}, rules(PairDefault::kAll), {}).empty());
}

TEST(PairSelection, SelfPairsOfPersonOnlyOnRequest) {
  // Two people of three parts, of which the first two are adjacent, and a thing.
  std::vector<SelectableBody> bodies;
  for (const char* person : {"p", "q"})
    for (const char* part : {"/torso", "/head", "/foot"})
      bodies.push_back({person + std::string(part), person, true});
  bodies.push_back({"thing", "objects"});
  const Pairs adjacent{{0, 1}, {3, 4}};
  auto r = rules(PairDefault::kAll);
  const std::size_t between = 3 * 3 + 6;
  EXPECT_EQ(selectPairs(bodies, r, adjacent).size(), between);
  r.include = {{"p/torso", "p/foot"}};
  EXPECT_EQ(selectPairs(bodies, r, adjacent).size(), between + 1) << "named";
  r.include.clear();
  r.within_people = true;
  EXPECT_EQ(selectPairs(bodies, r, adjacent).size(), between + 2 * 2);
  r.standard = PairDefault::kBetweenGroups;
  EXPECT_EQ(selectPairs(bodies, r, adjacent).size(), between + 2 * 2);
  r.standard = PairDefault::kNone;
  EXPECT_TRUE(selectPairs(bodies, r, adjacent).empty());
}

TEST(PairSelection, TwoArmsOfSevenLinksHave79Pairs) {
  std::vector<SelectableBody> bodies;
  Pairs adjacent;
  for (int arm = 0; arm < 2; ++arm) {
    for (int i = 0; i < 7; ++i)
      bodies.push_back({"arm" + std::to_string(arm) + "/" + std::to_string(i), "hug"});
    for (int i = 0; i < 6; ++i) adjacent.emplace_back(7 * arm + i, 7 * arm + i + 1);
  }
  EXPECT_EQ(selectPairs(bodies, rules(PairDefault::kAll), adjacent).size(), 79u);
}

TEST(PairSelection, PairsAreSorted) {
  const auto pairs = selectPairs(kBodies, rules(PairDefault::kAll), kAdjacent);
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
  for (const auto& [a, b] : pairs) EXPECT_LT(a, b);
}

TEST(PairSelection, LaterRulesWin) {
  auto r = rules(PairDefault::kNone);
  r.include = {{"a1", "a0"}, {"box", "table"}};
  EXPECT_EQ(selectPairs(kBodies, r, kAdjacent), (Pairs{{0, 1}, {5, 6}}))
      << "include brings an adjacent pair back";
  r.exclude = {{"a0", "a1"}};
  EXPECT_EQ(selectPairs(kBodies, r, kAdjacent), (Pairs{{0, 1}, {5, 6}})) << "include wins over exclude";

  auto all = rules(PairDefault::kAll);
  all.exclude = {{"table", "box"}, {"a0", "a1"}};
  all.include = {{"a0", "a2"}};
  const auto pairs = selectPairs(kBodies, all, kAdjacent);
  EXPECT_EQ(pairs.size(), 17u) << "an adjacent pair may be excluded and a default pair included";
  EXPECT_EQ(std::count(pairs.begin(), pairs.end(), std::pair(5, 6)), 0);
}

TEST(PairSelection, UnknownNamesAreRejectedWithSuggestion) {
  auto r = rules(PairDefault::kAll);
  r.exclude = {{"a0", "a1"}, {"a0", "h/haed"}};
  r.exclude_pos = {{"s.yaml", 7, 3}, {"s.yaml", 8, 3}};
  try {
    selectPairs(kBodies, r, kAdjacent);
    FAIL() << "expected a ParseError";
  } catch (const ParseError& e) {
    EXPECT_EQ(e.pos().line, 8);
    EXPECT_NE(std::string(e.what()).find("did you mean `h/head`?"), std::string::npos) << e.what();
  }
  r.exclude.clear();
  r.include = {{"a0", "a0"}};
  EXPECT_THROW(selectPairs(kBodies, r, kAdjacent), ParseError);
}

}  // namespace pair_selection_test
}  // namespace abstand::scene_file
