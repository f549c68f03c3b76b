// Sets of margins: their text, and which margin a pair gets.
#include "core/margin/margin_rules.hpp"

#include <gtest/gtest.h>

#include "core/base/error.hpp"

namespace abstand::margin {
namespace margin_rules_test {

MarginRules parsed(const std::string& text) { return parseMarginRules(text, "m.yaml", {"head", "torso"}); }

TEST(MarginRules, PairUsesLargerMarginOrSum) {
  const std::string margins =
      "margins:\n  - {part: head, margin: 0.1, robot_time: 0.2}\n  - {link: arm/l, margin: 0.3}\n"
      "  - {part: torso, link: arm/l, margin: 0.05}\n";
  const MarginRules larger = parsed("abstand_margins: 1\n" + margins);
  EXPECT_FALSE(larger.sum);
  EXPECT_EQ(larger.of("head", "arm/l")->margin, 0.3);
  EXPECT_EQ(larger.of("head", "arm/l")->robot_time, 0.2);
  const MarginRules sum = parsed("abstand_margins: 1\ncombine: sum\n" + margins);
  EXPECT_EQ(sum.of("head", "arm/l")->margin, 0.1 + 0.3);
  EXPECT_EQ(sum.of("head", "other")->margin, 0.1);
  EXPECT_EQ(sum.of("torso", "arm/l")->margin, 0.05) << "a pair goes before";
  EXPECT_FALSE(sum.of("torso", "other"));
}

TEST(MarginRules, TextRoundTrips) {
  const MarginRules rules{"x",
                          {{"head", "", {1.0 / 3.0, 0.0, 0.1}}, {"", "a \"b\"/l", {0.0, 0.0, 0.0}}},
                          PairMargin{0.2, 0.0, 0.0},
                          true};
  const std::string text = marginRulesText(rules);
  const MarginRules read = parsed(text);
  EXPECT_EQ(marginRulesText(read), text);
  EXPECT_TRUE(read.sum);
  EXPECT_EQ(read.of("head", "x")->margin, 1.0 / 3.0);
}

TEST(MarginRules, ClassOfPeopleAndRobotsReplacesOtherMargins) {
  const std::string text =
      "abstand_margins: 1\ndefault: {margin: 0.2, robot_time: 0.1}\nmargins:\n  - {part: head, margin: 0.5}\n"
      "classes:\n  person_robot: 0.125\n  robot_robot: 0.03\n";
  const MarginRules rules = parsed(text);
  for (const char* part : {"head", "torso"}) {
    EXPECT_EQ(rules.of(part, "arm/l")->margin, 0.125);
    EXPECT_EQ(rules.of(part, "arm/l")->robot_time, 0.0);
  }
  EXPECT_EQ(marginRulesText(parsed(marginRulesText(rules))), marginRulesText(rules));
  EXPECT_EQ(parsed(marginRulesText(rules)).classes, rules.classes);
  const MarginRules other = parsed("abstand_margins: 1\nclasses: {robot_robot: 0.03}\n");
  EXPECT_FALSE(other.of("head", "arm/l")) << "it is for other pairs";
  EXPECT_EQ(other.classes.at("robot_robot"), 0.03);
}

TEST(MarginRules, ErrorsHavePositions) {
  const std::pair<const char*, const char*> cases[] = {
      {"abstand_margins: 1\ncombine: both\ndefault: {margin: 0}\n", "m.yaml:2:"},
      {"abstand_margins: 2\n", "m.yaml:1:"},
      {"abstand_margins: 1\n", "found no margin"},
      {"abstand_margins: 1\nclasses: {people: 1}\n", "m.yaml:2:11: error: "},
      {"abstand_margins: 1\nclasses: {robot_robot: -1}\n", "m.yaml:2:24: error: "},
      {"abstand_margins: 1\nmargins: [{part: hand, margin: 1}]\n", "m.yaml:2:"}};
  for (const auto& [text, error] : cases) {
    SCOPED_TRACE(text);
    try {
      parsed(text);
      ADD_FAILURE() << "no error";
    } catch (const ParseError& e) {
      EXPECT_NE(std::string(e.what()).find(error), std::string::npos) << e.what();
    }
  }
}

}  // namespace margin_rules_test
}  // namespace abstand::margin
