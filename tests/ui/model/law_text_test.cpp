// Words and numbers of laws.
#include "ui/model/law_text.hpp"

#include <gtest/gtest.h>

#include <set>

namespace abstand::ui {
namespace law_text_test {

TEST(LawText, EveryLawAndNumberHasWords) {
  std::set<QString> meanings;
  for (const control::LawState& law : control::lawStates({}, {})) {
    EXPECT_FALSE(lawName(law.name).isEmpty()) << law.name;
    EXPECT_TRUE(lawMeaning(law.name).endsWith(QLatin1Char('.'))) << law.name;
    for (const control::LawNumber& number : law.numbers) {
      EXPECT_FALSE(numberName(number.key).isEmpty()) << number.key;
      EXPECT_TRUE(numberMeaning(number.key).endsWith(QLatin1Char('.'))) << number.key;
      meanings.insert(numberMeaning(number.key));
    }
  }
  EXPECT_GT(meanings.size(), 35u) << "they are told apart";
  EXPECT_TRUE(numberName("torque.size").isEmpty());
}

TEST(LawText, NumbersReadBack) {
  const std::vector<config::JointNumbers> cases{
      {0.5}, {1.0 / 3.0}, {1e-7, -2.0, 1234567.25}, {kInfinity, -kInfinity, 0.0}};
  for (const config::JointNumbers& numbers : cases)
    EXPECT_EQ(numbersFromText(numbersText(numbers)), numbers) << numbersText(numbers).toStdString();
  EXPECT_EQ(numbersText({1.0, kInfinity}), QStringLiteral("1; ∞"));
  EXPECT_EQ(numbersFromText("1,5"), config::JointNumbers{1.5});
  EXPECT_EQ(numbersFromText(" 1;2  3 "), (config::JointNumbers{1.0, 2.0, 3.0}));
  EXPECT_EQ(numbersFromText("inf"), config::JointNumbers{kInfinity});
  for (const char* text : {"", "x", "1 x", "nan", "1e999", "--1"})
    EXPECT_TRUE(numbersFromText(text).empty()) << text;
}

TEST(LawText, RulesAreSentences) {
  EXPECT_EQ(ruleText({0.0, 10.0, "m", true}, 1), "Expected a number above 0 and at most 10 m.");
  EXPECT_EQ(ruleText({0.0, 1.0}, 1), "Expected a number from 0 to 1.");
  EXPECT_EQ(ruleText({0.0, kInfinity, "s"}, 1), "Expected a number from 0 s on, or ∞ for no limit.");
  EXPECT_EQ(ruleText({-kInfinity, 100.0, "m"}, 1), "Expected a number up to 100 m, or −∞ for no limit.");
  EXPECT_TRUE(ruleText({0.0, 1.0}, 7).contains("Or 7 numbers"));
}

TEST(LawText, UnitsAreWrittenAsUsual) {
  EXPECT_EQ(unitText("rad/s^2 or m/s^2"), QStringLiteral("rad/s² or m/s²"));
  EXPECT_EQ(unitText("N m or N"), QStringLiteral("N·m or N"));
  EXPECT_EQ(unitText("kg"), QStringLiteral("kg"));
  EXPECT_EQ(unitText(""), QString());
}

TEST(LawText, StepsAreTenthsOfLeadingPlaceWithinRule) {
  const config::NumberRule rule{0.0, 60.0};
  EXPECT_DOUBLE_EQ(steppedNumber(1.0, 1, rule), 1.1);
  EXPECT_DOUBLE_EQ(steppedNumber(50.0, -1, rule), 49.0);
  EXPECT_DOUBLE_EQ(steppedNumber(0.05, 1, rule), 0.051);
  EXPECT_DOUBLE_EQ(steppedNumber(0.0, 1, rule), 0.01);
  EXPECT_EQ(steppedNumber(0.0, -1, rule), 0.0);
  EXPECT_EQ(steppedNumber(60.0, 1, rule), 60.0);
  EXPECT_EQ(steppedNumber(kInfinity, 1, rule), kInfinity);
}

}  // namespace law_text_test
}  // namespace abstand::ui
