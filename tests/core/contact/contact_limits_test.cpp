// The table of contact limits: what the shipped file says, and what every wrong file is told.
#include "core/contact/contact_limits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "core/contact/contact_limits_reader.hpp"
#include "humanmodel/body_part.hpp"
#include "tests/core/contact/contact_table.hpp"
#include "tests/support/paths.hpp"

namespace abstand::contact {
namespace contact_limits_test {

using ::testing::AllOf;
using ::testing::HasSubstr;

// Energies of the shipped file are rounded to 0.001 J; the smallest one is 0.028 J.
constexpr double kRounded = 0.02;

std::filesystem::path shippedFile() { return testing::projectFile("data/standards/iso_ts_15066_2016.yaml"); }

std::string errorOf(const std::string& text) {
  try {
    parseContactLimits(text, "t.yaml", humanmodel::partNames());
  } catch (const ParseError& e) {
    return e.what();
  }
  return "no error";
}

/// The shipped text with the first `from` after `behind` replaced.
std::string changed(const std::string& behind, const std::string& from, const std::string& to) {
  std::string text = readFile(shippedFile());
  const std::size_t begin = text.find(behind);
  EXPECT_NE(begin, std::string::npos) << behind;
  const std::size_t at = text.find(from, begin);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(ContactLimits, ShippedTableMatchesStandard) {
  struct Row {
    const char* region;
    double force, pressure, spring, mass;  // N, N/cm^2, N/mm, kg
  };
  // ISO/TS 15066:2016, A.2 and A.3, as transcribed; the smallest pressure of each region. The upper arm's is
  // a stand-in: the smallest of all regions but head and face.
  const Row rows[] = {{"skull_forehead", 130, 110, 150, 4.4},
                      {"face", 65, 110, 75, 4.4},
                      {"neck", 150, 140, 50, 1.2},
                      {"back_shoulders", 210, 160, 35, 40},
                      {"chest", 140, 120, 25, 40},
                      {"abdomen", 110, 140, 10, 40},
                      {"pelvis", 180, 210, 25, 40},
                      {"upper_arm_elbow", 150, 120, 30, 3},
                      {"forearm_wrist", 160, 180, 40, 2},
                      {"hand_fingers", 140, 200, 75, 0.6},
                      {"thigh_knee", 220, 220, 50, 75},
                      {"lower_leg", 130, 210, 60, 75}};
  EXPECT_EQ(shippedLimits().regions.size(), std::size(rows));
  for (const Row& row : rows) {
    SCOPED_TRACE(row.region);
    const RegionLimits& r = shipped(row.region);
    EXPECT_EQ(r.force.value, row.force);
    EXPECT_EQ(r.pressure(), row.pressure * 1e4);
    EXPECT_EQ(r.spring.value, row.spring * 1e3);
    EXPECT_EQ(r.body_mass.value, row.mass);
    EXPECT_EQ(r.force.source, "ISO/TS 15066:2016, A.2");
    EXPECT_EQ(r.spring.source, "ISO/TS 15066:2016, A.3");
  }
}

TEST(ContactLimits, EnergiesFollowFromForceAndSpring) {
  for (const RegionLimits& r : shippedLimits().regions) {
    ASSERT_TRUE(r.energy) << r.name;
    const double force = r.force.value * (r.excluded() ? 1.0 : r.transient.value);
    const double expected = force * force / (2.0 * r.spring.value);
    EXPECT_NEAR(r.energy->value, expected, kRounded * expected) << r.name;
  }
}

TEST(ContactLimits, ExcludesHeadOnly) {
  for (const RegionLimits& r : shippedLimits().regions)
    EXPECT_EQ(r.excluded(), r.name == "skull_forehead" || r.name == "face") << r.name;
  for (const RegionLimits* r : shippedLimits().regionsOf("head")) EXPECT_TRUE(r->excluded());
}

TEST(ContactLimits, CoversEveryBodyPart) {
  for (const std::string_view part : humanmodel::partNames())
    EXPECT_FALSE(shippedLimits().regionsOf(part).empty()) << part;
  EXPECT_EQ(shippedLimits().regionsOf("torso").size(), 5u);  // neck, back, chest, abdomen, pelvis
  const auto foot = shippedLimits().regionsOf("foot_left");
  ASSERT_EQ(foot.size(), 1u);
  EXPECT_EQ(foot[0]->name, "lower_leg");
  EXPECT_TRUE(foot[0]->standsInFor("foot_left"));
  EXPECT_FALSE(foot[0]->standsInFor("calf_left"));
  EXPECT_TRUE(shippedLimits().regionsOf("tail").empty());
}

TEST(ContactLimits, StampNamesEditionAndContent) {
  const ContactLimits& limits = shippedLimits();
  EXPECT_THAT(limits.stamp(), AllOf(HasSubstr("ISO/TS 15066:2016"), HasSubstr("iso_ts_15066_2016.yaml"),
                                    HasSubstr(limits.content.hex().substr(0, 12))));
  EXPECT_THAT(limits.note, HasSubstr("ISO 10218-2:2025"));
  const std::string other = changed("name: chest", "n: 140", "n: 139.9");
  EXPECT_NE(parseContactLimits(other, "t.yaml", humanmodel::partNames()).content, limits.content);
}

TEST(ContactLimits, ListsDoubtfulValues) {
  const auto doubts = shippedLimits().doubts();
  EXPECT_THAT(doubts, ::testing::Contains(HasSubstr("skull_forehead, transient: ")));
  EXPECT_THAT(doubts, ::testing::Contains(HasSubstr("upper_arm_elbow, pressure, deltoid muscle: ")));
}

TEST(ContactLimitsFile, ReportsErrorsWithPosition) {
  struct Case {
    const char *behind, *from, *to, *line, *message;
  };
  const Case cases[] = {
      {"name: chest", "n: 140", "n: -140", "t.yaml:", "expected a number above 0 and at most 10000 N"},
      {"name: chest", "n: 140", "n: .inf", "t.yaml:", "expected a finite number"},
      {"name: chest", "n: 140", "kn: 140", "t.yaml:", "found the unknown key `kn` in `force`"},
      {"name: chest", "force: {n: 140, source: a2}", "remark: x", "t.yaml:", "found no `force` in a region"},
      {"name: chest", "factor: 2", "factor: 0.5", "t.yaml:", "expected a number from 1 to 10"},
      {"name: chest", "factor: 2", "factor: none", "t.yaml:", "found `none` for `factor`"},
      {"name: chest", "source: a2", "source: a7",
       "t.yaml:", "found the source `a7`, which is not in `sources`"},
      {"name: chest", "[torso]", "[body]",
       "t.yaml:", "found `body` for `parts`, expected one of torso, head"},
      {"name: chest", "name: chest", "name: neck", "t.yaml:", "found the region `neck` twice"},
      {"name: lower_leg", "[foot_left, foot_right]", "[foot_left]",
       "t.yaml:", "found no region that covers the body part `foot_right`"},
      {"name: face", "factor: not_applicable", "factor: 2",
       "t.yaml:", "contact with the head is excluded, never limited"},
      {"title:", "title:", "titel:", "t.yaml:13:1: error: found the unknown key `titel`",
       "did you mean `title`?"},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.to);
    EXPECT_THAT(errorOf(changed(c.behind, c.from, c.to)), AllOf(HasSubstr(c.line), HasSubstr(c.message)));
  }
}

TEST(ContactLimitsFile, ReportsPositionOfNumber) {
  const std::string text = changed("name: chest", "n: 140", "n: -140");
  const std::size_t at = text.find("-140");
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  const std::size_t column = at - text.rfind('\n', at);
  EXPECT_THAT(errorOf(text),
              HasSubstr("t.yaml:" + std::to_string(line) + ":" + std::to_string(column) + ":"));
}

TEST(ContactLimitsFile, FindsValueOfWrongColumnByEnergy) {
  // The chest's transient force in the quasi-static column: twice the force, four times the energy.
  EXPECT_THAT(errorOf(changed("name: chest", "n: 140", "n: 280")),
              AllOf(HasSubstr("found an energy of 1.568 J in region `chest`"), HasSubstr("= 6.272 J")));
  // The head's energy with a factor of 2 that does not apply.
  EXPECT_THAT(errorOf(changed("name: face", "j: 0.028", "j: 0.113")), HasSubstr("= 0.0282 J"));
  // What the edition's own table of energies is quoted with passes, and so does a file without energies.
  EXPECT_EQ(errorOf(changed("name: hand_fingers", "j: 0.523", "j: 0.49")), "no error");
  EXPECT_EQ(errorOf(changed("name: chest", "    energy: {j: 1.568, source: computed}\n", "")), "no error");
}

TEST(ContactLimitsFile, HandlesBrokenText) {
  const std::string text = readFile(shippedFile());
  for (std::size_t i = 0; i < text.size(); i += 13) {
    std::string broken = text;
    broken[i] = "0-:{[x\n\x01"[i % 8];
    errorOf(broken);  // any other exception than ParseError ends the test
    EXPECT_NE(errorOf(text.substr(0, i)), "no error") << i;
  }
}

TEST(ContactLimitsFile, RejectsOtherContent) {
  EXPECT_THAT(errorOf(""), HasSubstr("t.yaml"));
  EXPECT_THAT(errorOf("[1, 2]"), HasSubstr("expected a map"));
  EXPECT_THAT(errorOf("title: x"), HasSubstr("found no `sources`"));
  EXPECT_THROW(loadContactLimits("/nowhere.yaml", humanmodel::partNames()), ParseError);
}

}  // namespace contact_limits_test
}  // namespace abstand::contact
