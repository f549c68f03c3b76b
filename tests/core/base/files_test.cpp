#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"

namespace abstand {
namespace {

TEST(TextFile, SaysWhatIsWrongWithAFile) {
  testing::ScratchFolder d;
  EXPECT_THROW(readFile(d.path()), ParseError);
  EXPECT_THROW(readFile(d.path() / "none"), ParseError);
  EXPECT_THROW(readFile(d.write("empty", "")), ParseError);
  EXPECT_THROW(readFile(d.write("long", "12345"), 4), ParseError);
  EXPECT_EQ(readFile(d.write("good", "12345")), "12345");
}

TEST(ParseErrorText, IsOneLineWithPlaceAndHint) {
  EXPECT_STREQ(ParseError({"a.mech", 3, 7}, "found x, expected y").what(),
               "a.mech:3:7: error: found x, expected y");
  EXPECT_STREQ(ParseError({"a.mech"}, "is empty", "look").what(), "a.mech: error: is empty\nhint: look");
}

TEST(NearestName, FindsTheTypo) {
  const std::vector<std::string> known{"objects", "humans", "pairs"};
  EXPECT_EQ(nearestName("objekts", known), "objects");
  EXPECT_EQ(nearestName("zzzzzzzz", known), "");
}

TEST(OutputFile, IsThereWholeOrNotAtAll) {
  testing::ScratchFolder d;
  {
    OutputFile f(d.path() / "a");
    f.stream() << "half";
  }
  EXPECT_TRUE(std::filesystem::is_empty(d.path()));
  {
    OutputFile f(d.path() / "a");
    f.stream() << "whole";
    f.commit();
  }
  EXPECT_EQ(readFile(d.path() / "a"), "whole");
  EXPECT_THROW(OutputFile(d.path() / "no" / "where"), UsageError);
}

}  // namespace
}  // namespace abstand
