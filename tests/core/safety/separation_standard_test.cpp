// The table of terms of the protective distance: what the shipped file says, and what every wrong file is
// told.
#include "core/safety/separation_standard.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"

namespace abstand::safety {
namespace separation_standard_test {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string shippedText() { return readFile(testing::projectFile("data/standards/iso_13855_2010.yaml")); }

/// The shipped text with `from` replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = shippedText();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string errorOf(const std::string& text) {
  try {
    parseSeparationStandard(text, "t.yaml");
  } catch (const ParseError& e) {
    return e.what();
  }
  return "no error";
}

TEST(SeparationStandard, ShippedTableHasTheDefaultsOfTheProgram) {
  const SeparationStandard shipped = loadSeparationStandard(defaultSeparationTable());
  EXPECT_EQ(shipped.edition, kApproachSpeedEdition);
  // A user who loads no table, as a scene with its own control law, gets the same numbers.
  const SeparationOptions from_table = shipped.options(), usual;
  std::vector<double> a, b;
  const auto into = [](std::vector<double>& numbers) {
    return [&numbers](const char*, const double& v, const config::NumberRule&) { numbers.push_back(v); };
  };
  SeparationOptions::eachNumber(from_table, into(a));
  SeparationOptions::eachNumber(usual, into(b));
  EXPECT_EQ(a, b);
  // ISO 13855:2010: K = 1600 mm/s, and 2000 mm/s up to 500 mm.
  ASSERT_EQ(shipped.terms.size(), 3u);
  EXPECT_EQ(shipped.term("person_speed")->cited.value, 1.6);
  EXPECT_EQ(shipped.term("person_speed_near")->cited.value, 2.0);
  EXPECT_EQ(shipped.term("near")->cited.value, 0.5);
  for (const SeparationStandard::Term& term : shipped.terms)
    EXPECT_THAT(term.cited.source, HasSubstr("ISO 13855:2010, ")) << term.key;
  EXPECT_THAT(shipped.stamp(), AllOf(HasSubstr("ISO 13855:2010"), HasSubstr("iso_13855_2010.yaml")));
}

TEST(SeparationStandard, AnotherEditionMayStateEveryTerm) {
  const SeparationStandard own = parseSeparationStandard(
      changed("  near: {m: 0.5, source: hand}",
              "  near: {m: 0.4, source: hand}\n"
              "  reaction_time: {s: 0.2, source: walking}\n"
              "  deceleration: {m_per_s2: 3, source: walking, to_be_checked: measured once}\n"
              "  intrusion: {m: 0.85, source: walking}"),
      "own.yaml");
  const SeparationOptions o = own.options();
  EXPECT_EQ(o.near, 0.4);
  EXPECT_EQ(o.reaction_time, 0.2);
  EXPECT_EQ(o.deceleration, 3.0);
  EXPECT_EQ(o.intrusion, 0.85);
  EXPECT_EQ(o.stopping_time, SeparationOptions().stopping_time);
  EXPECT_EQ(own.term("deceleration")->cited.to_be_checked, "measured once");
  EXPECT_EQ(own.term("stopping_time"), nullptr);
  EXPECT_NE(own.stamp(), loadSeparationStandard(defaultSeparationTable()).stamp());
}

TEST(SeparationStandard, WrongTablesAreRefusedWithTheirPlace) {
  EXPECT_EQ(errorOf(shippedText()), "no error");
  EXPECT_THAT(errorOf(changed("person_speed: {m_per_s: 1.6", "person_speed: {m_per_s: -1.6")),
              AllOf(HasSubstr("t.yaml:"), HasSubstr("-1.6")));
  EXPECT_THAT(errorOf(changed("person_speed: {m_per_s: 1.6", "person_speed: {m_per_s: .nan")),
              HasSubstr("t.yaml:"));
  EXPECT_THAT(errorOf(changed("{m_per_s: 1.6", "{mm_per_s: 1600")), HasSubstr("mm_per_s"));
  EXPECT_THAT(errorOf(changed("{m: 0.5, source: hand}", "{m: 0.5, source: hnad}")),
              AllOf(HasSubstr("hnad"), HasSubstr("did you mean `hand`")));
  EXPECT_THAT(errorOf(changed("{m: 0.5, source: hand}", "{m: 0.5}")), HasSubstr("source"));
  EXPECT_THAT(errorOf(changed("  near: {m: 0.5, source: hand}\n", "")), HasSubstr("near"));
  EXPECT_THAT(errorOf(changed("  near:", "  neer:")), HasSubstr("neer"));
  EXPECT_THAT(errorOf(changed("edition: ISO 13855:2010\n", "")), HasSubstr("edition"));
  EXPECT_THAT(errorOf("[]"), HasSubstr("t.yaml:1"));
  EXPECT_THAT(errorOf(""), HasSubstr("t.yaml"));
}

}  // namespace separation_standard_test
}  // namespace abstand::safety
