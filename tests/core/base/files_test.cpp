#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/base/message_line.hpp"
#include "core/base/output_file.hpp"
#include "core/base/output_folder.hpp"
#include "core/base/progress_report.hpp"
#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"

namespace abstand {
namespace files_test {

TEST(TextFile, RejectsUnreadableFiles) {
  testing::ScratchFolder d;
  EXPECT_THROW(readFile(d.path()), ParseError);
  EXPECT_THROW(readFile(d.path() / "none"), ParseError);
  EXPECT_THROW(readFile(d.write("empty", "")), ParseError);
  EXPECT_THROW(readFile(d.write("long", "12345"), 4), ParseError);
  EXPECT_EQ(readFile(d.write("good", "12345")), "12345");
}

TEST(ParseErrorText, IsOneLineWithPositionAndHint) {
  EXPECT_STREQ(ParseError({"a.mech", 3, 7}, "found x, expected y").what(),
               "a.mech:3:7: error: found x, expected y");
  EXPECT_STREQ(ParseError({"a.mech"}, "is empty", "look").what(), "a.mech: error: is empty\nhint: look");
}

TEST(NearestName, FindsTypo) {
  const std::vector<std::string> known{"objects", "humans", "pairs"};
  EXPECT_EQ(nearestName("objekts", known), "objects");
  EXPECT_EQ(nearestName("zzzzzzzz", known), "");
}

TEST(OutputFile, IsWrittenAtomically) {
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

TEST(OutputFolder, IsWrittenAtomically) {
  testing::ScratchFolder d;
  {
    OutputFolder set(d.path() / "a" / "b");
    writeFile(set.place("one"), "1");
    EXPECT_THROW(set.place("one"), UsageError);
  }
  EXPECT_TRUE(std::filesystem::is_empty(d.path()));
  for (const bool is_there : {false, true}) {
    OutputFolder set(d.path() / "a" / "b");
    writeFile(set.place("one"), is_there ? "new" : "old");
    if (!is_there) writeFile(set.place("two"), "2");
    EXPECT_EQ(exists(d.path() / "a" / "b" / "one"), is_there);
    set.commit();
  }
  EXPECT_EQ(readFile(d.path() / "a" / "b" / "one"), "new");
  EXPECT_EQ(readFile(d.path() / "a" / "b" / "two"), "2");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(d.path() / "a" / "b"), {}), 2);
}

TEST(MessageLine, EscapesControlCharacters) {
  EXPECT_EQ(messageLine("plain \xc3\xa4\xe2\x82\xac"), "plain \xc3\xa4\xe2\x82\xac");
  EXPECT_EQ(messageLine("a\nb\r\tc"), "a b  c");
  EXPECT_EQ(messageLine(std::string_view("\x1b[31m\x7f\0\xff", 8)), "\\x1b[31m\\x7f\\x00\\xff");
  EXPECT_EQ(messageLine("\xc2\x9b\xe2\x80\xae"), "\\xc2\\x9b\\xe2\\x80\\xae");
  std::string wide;
  for (int i = 0; i < 100'000; ++i) wide += "\xe2\x82\xac";
  const std::string cut = messageLine(wide);
  EXPECT_LT(cut.size(), 1100u);
  EXPECT_EQ(cut.find('\\'), std::string::npos) << cut;
  EXPECT_NE(cut.find("[...]"), std::string::npos);
  EXPECT_EQ(messageLines("a\nb\x01\n", 10), "a\nb\\x01\n");
  EXPECT_STREQ(ParseError({"a\x1b"}, "b\nc").what(), "a\\x1b: error: b c");
}

TEST(ProgressReport, WritesOccasionalLinesWithoutTerminal) {
  std::string out;
  double now = 100.0;
  const auto write = [&out](const std::string& text) { out += text; };
  ProgressReport pipe("run", false, write, [&now] { return now; });
  for (int i = 0; i < 250; ++i, now += 0.125) pipe(static_cast<std::size_t>(i), 1000);
  EXPECT_EQ(out, "run: 8 % after 10 s\nrun: 16 % after 20 s\nrun: 24 % after 30 s\n");
  out.clear();
  ProgressReport terminal("run", true, write, [&now] { return now; });
  for (const std::size_t done : {0u, 1u, 50u, 100u, 1000u}) terminal(done, 1000);
  EXPECT_EQ(out, "\rrun   0 %\rrun   5 %\rrun  10 %\rrun 100 %\n");
}

}  // namespace files_test
}  // namespace abstand
