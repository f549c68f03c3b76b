// The joint map that is written of a recording.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "tests/tracking/joint_guess/guess_cases.hpp"
#include "tests/tracking/small_human.hpp"
#include "tracking/recording/joint_map_writer.hpp"

namespace abstand::tracking {
namespace joint_guess_test {

using testing::bvhOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(JointMapWriter, RoundTrips) {
  const testing::ScratchFolder folder;
  const std::string odd = renamed(bvhOf({}), [](int i) { return "rig|a:b + c " + std::to_string(i) + "#"; });
  for (const std::string& bvh : {bvhOf({}), odd}) {
    const Recording r = read(bvh);
    const std::string text = jointMapText(r.report);
    const Recording again = read(bvh, {.joint_map = folder.write("own.map", text)});
    EXPECT_FALSE(again.report.map_use.is_guess);
    EXPECT_EQ(again.report.map_use.names, r.report.map_use.names);
    EXPECT_EQ(again.report.mapped, r.report.mapped);
    EXPECT_EQ(limbsApart(r, again), 0.0);
    EXPECT_EQ(jointMapText(again.report), text);
  }
  // Two joints of one name: only the first can be named in a map.
  const Recording twice =
      read(renamed(bvhOf({}), [](int i) { return i < 3 ? "top" : "x" + std::to_string(i); }));
  EXPECT_THROW(jointMapText(twice.report), UsageError);
}

TEST(JointMapWriter, WritesTemplateToFillIn) {
  const testing::ScratchFolder folder;
  const std::string text = jointMapText(read(comb(2)).report);
  EXPECT_THAT(text, HasSubstr("\n# hip_left:\n"));
  EXPECT_THAT(text, HasSubstr("Names in the file:\n#   a\n#   b0\n"));
  EXPECT_THROW(read(comb(2), {.joint_map = folder.write("own.map", "name: own\nspines: b0\n")}), ParseError);
  EXPECT_NO_THROW(read(comb(2), {.joint_map = folder.write("own.map", text)})) << "all of it is comments";
}

TEST(JointMapWriter, NamesMayHaveQuotes) {
  const testing::ScratchFolder folder;
  for (const char* form : {"\"@\"", "\"@", "@\"", "\"a|\"@", "say \"@\" twice", "\"@\" | \"b\""}) {
    const std::string bvh = bvhOf({.rename = [&](const std::string& n) {
      const std::string name(form);
      const auto at = name.find('@');
      return name.substr(0, at) + n + name.substr(at + 1);
    }});
    const Recording r = read(bvh);
    ASSERT_THAT(r.report.mapped, Not(IsEmpty())) << form;
    if (std::string_view(form).find("\" | \"") != std::string_view::npos) {
      try {
        jointMapText(r.report);
        FAIL();
      } catch (const UsageError& e) {
        EXPECT_THAT(e.what(), HasSubstr("', which a joint map cannot state, expected names that"));
      }
      continue;
    }
    const Recording again = read(bvh, {.joint_map = folder.write("own.map", jointMapText(r.report))});
    EXPECT_EQ(again.report.map_use.names, r.report.map_use.names) << form;
  }
}

TEST(JointMapWriter, TemplateHasJointsThatWereFound) {
  const testing::ScratchFolder folder;
  const std::string bvh = renamed(bvhOf({}), [](int i) { return "bone" + std::to_string(i); });
  const Recording r = read(bvh, {.joint_map = folder.write("own.map", "name: Own\nhip_left: bone11\n")});
  ASSERT_THAT(r.report.mapped, IsEmpty());
  const std::string text = jointMapText(r.report);
  EXPECT_THAT(text, HasSubstr("\nhip_left: bone11\n# knee_left:\n"));
  const Recording again = read(bvh, {.joint_map = folder.write("filled.map", text)});
  EXPECT_EQ(again.report.map_use.names, r.report.map_use.names);
}

}  // namespace joint_guess_test
}  // namespace abstand::tracking
