// What a BVH reader meets in the wild, and what it must refuse.
#include "tracking/bvh/bvh_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/support/paths.hpp"

namespace abstand::tracking {
namespace bvh_reader_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Root with six channels and one child with one: seven numbers a frame. MOTION stands on line 13.
const std::string kTree =
    "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
    "Yrotation\n"
    "JOINT Chest\n{\nOFFSET 0 5 0\nCHANNELS 1 Yrotation\nEnd Site\n{ OFFSET 0 1 0 }\n} }\n";

std::string withData(const std::string& frames, const std::string& data, const std::string& time = "0.01") {
  return kTree + "MOTION\nFrames: " + frames + "\nFrame Time: " + time + "\n" + data;
}

struct Read {
  std::vector<std::vector<double>> frames;
  std::vector<FileWarning> warnings;
};

Read readAll(const std::string& text) {
  BvhReader reader(text, "t.bvh");
  Read r;
  while (const auto v = reader.next()) r.frames.emplace_back(v->begin(), v->end());
  EXPECT_FALSE(reader.next());
  r.warnings = reader.warnings();
  return r;
}

TEST(BvhReader, ReadsCommonVariants) {
  const std::vector<double> first{1, 2, 3, 4, 5, 6, 7}, second{8, 9, 10, 11, 12, 13, 14};
  struct Case {
    const char* what;
    std::string text;
  };
  std::string crlf;
  for (const char c : withData("2", "1 2 3 4 5 6 7\n8 9 10 11 12 13 14\n"))
    crlf += c == '\n' ? "\r\n" : std::string(1, c);
  std::string small_letters = withData("2", "1 2 3 4 5 6 7\n8 9 10 11 12 13 14\n");
  for (char& c : small_letters) c = static_cast<char>(std::tolower(c));
  const Case cases[] = {
      {"a line a frame", withData("2", "1 2 3 4 5 6 7\n8 9 10 11 12 13 14\n")},
      {"no newline at the end", withData("2", "1 2 3 4 5 6 7\n8 9 10 11 12 13 14")},
      {"tabs and blanks", withData("\t2", " 1\t2  3 4 5 6 7 \t\n8 9 10 11 12 13 14\n\n \n")},
      {"CRLF", crlf},
      {"small letters", small_letters},
      {"exponents, signs, no leading zero",
       withData("2", "1e0 +2. 3.0E+0 .4e1 5 60e-1 7\n8 9 10 11 12 13 14\n")},
      {"a frame over several lines", withData("2", "1 2 3\n4 5 6\n7\n8 9 10\n11 12\n13 14\n")},
      {"two frames on one line", withData("2", "1 2 3 4 5 6 7 8 9 10 11 12 13 14\n")},
      {"empty lines between", withData("2", "\n1 2 3 4 5 6 7\n\n8 9 10 11 12 13 14\n")},
      {"byte order mark", "\xEF\xBB\xBF" + withData("2", "1 2 3 4 5 6 7\n8 9 10 11 12 13 14\n")}};
  for (const Case& c : cases) {
    const Read r = readAll(c.text);
    EXPECT_THAT(r.frames, ElementsAre(first, second)) << c.what;
    EXPECT_TRUE(r.warnings.empty()) << c.what;
  }
}

TEST(BvhReader, ReadsJointTree) {
  BvhReader reader(
      "HIERARCHY\nROOT mixamorig:Hips \t\n{\nOFFSET 0 1e1 -.5\nCHANNELS 6 Zrotation Xrotation Yrotation "
      "Xposition "
      "Yposition Zposition\nJOINT Bip01 L UpperArm\n{\nOFFSET 1 2 3\nCHANNELS 6 Yposition Xposition "
      "Zposition "
      "Yrotation Xrotation Zrotation\nEND SITE\n{\nOFFSET 0 0 1\n}\n}\nJOINT last{OFFSET 0 0 0 CHANNELS "
      "0}\n}\n"
      "MOTION\nFrames:1\nFrame Time:.0083333\n0 0 0 0 0 0 0 0 0 0 0 0\n",
      "t.bvh");
  const auto& joints = reader.hierarchy().joints;
  ASSERT_EQ(joints.size(), 4u);
  EXPECT_EQ(joints[0].name, "mixamorig:Hips");
  EXPECT_EQ(joints[0].offset, Vector3d(0, 10, -0.5));
  EXPECT_EQ(joints[0].channels[0], BvhChannel::kZRotation);
  EXPECT_EQ(joints[1].name, "Bip01 L UpperArm");
  EXPECT_EQ(joints[1].first_channel, 6u);
  EXPECT_EQ(joints[1].channels[3], BvhChannel::kYRotation);
  EXPECT_EQ(joints[2].name, "Bip01 L UpperArm/end");
  EXPECT_EQ(joints[2].parent, 1);
  EXPECT_EQ(joints[3].name, "last");
  EXPECT_EQ(joints[3].parent, 0);
  EXPECT_EQ(reader.head().frame_time, 0.0083333);
  EXPECT_TRUE(reader.next());
}

TEST(BvhReader, KeepsWholeFramesAndWarns) {
  struct Case {
    std::string text;
    std::size_t frames;
    int line;
    const char* warning;
  };
  const std::string frame = "1 2 3 4 5 6 7\n";
  const Case cases[] = {
      {withData("3", frame + frame), 2, 14, "claims 3 frames, found 2 complete ones"},
      {withData("1", frame + frame), 1, 14, "claims 1 frames, found 2 complete ones: frames beyond"},
      {withData("2", frame + "1 2 3\n"), 1, 17, "truncated after 3 of 7"},
      {withData("2", frame + "1 2 3 4 5 6 7e"), 1, 17, "truncated after 6 of 7"},
      {withData("3", frame + "1 2 3 4 5 6 7"), 1, 17, "truncated after 7 of 7"},
      {withData("4000000000", frame), 1, 14, "claims 4000000000 frames"},
      {withData("1", frame, "0"), 1, 15, "30 frames per second are assumed"},
      {withData("1", frame, "-0.01"), 1, 15, "30 frames per second are assumed"},
      {withData("1", frame, "5e-324"), 1, 15, "30 frames per second are assumed"},
      {kTree.substr(0, kTree.size()) +
           "ROOT Other\n{\nOFFSET 0 0 0\nCHANNELS 1 Xposition\n}\nMOTION\nFrames: 1\nFrame "
           "Time: 0.01\n1 2 3 4 5 6 7 8\n",
       1, 13, "a further ROOT 'Other'"}};
  for (const Case& c : cases) {
    const Read r = readAll(c.text);
    EXPECT_EQ(r.frames.size(), c.frames) << c.warning;
    ASSERT_FALSE(r.warnings.empty()) << c.warning;
    EXPECT_THAT(r.warnings[0].text, HasSubstr(c.warning));
    EXPECT_EQ(r.warnings[0].line, c.line) << c.warning;
  }
}

TEST(BvhReader, RejectsBadFilesWithPosition) {
  struct Case {
    std::string text;
    int line, column;  // 0: not told
    const char* message;
  };
  std::string deep = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Xposition\n";
  for (int i = 0; i < 600; ++i) deep += "JOINT a\n{\nOFFSET 0 0 0\n";
  const std::string frame = "1 2 3 4 5 6 7\n";
  const Case cases[] = {
      {"", 1, 1, "expected HIERARCHY"},
      {"\x01\x02\xff{}", 1, 1, "expected HIERARCHY"},
      {"HIERARCHY\nJOINT x", 2, 1, "expected ROOT"},
      {"HIERARCHY\nROOT\n{", 2, 5, "expected the name of a joint"},
      {kTree.substr(0, 30), 4, 9, "expected a number of OFFSET"},
      {kTree.substr(0, kTree.size() - 3), 12, 2, "found the end of the file in joint 'Hips'"},
      {"HIERARCHY\nROOT a\n{\nOFFSET 0 nan 0\n}", 4, 10, "found 'nan'"},
      {"HIERARCHY\nROOT a\n{\nOFFSET 0 1e300 0\n}", 4, 10, "expected a length below 1e9"},
      {"HIERARCHY\nROOT a\n{\nCHANNELS 3 Xrotation Yrotation Wrotation", 4, 32, "found 'Wrotation'"},
      {"HIERARCHY\nROOT a\n{\nCHANNELS 2 Xrotation Xrotation", 4, 22, "a second time"},
      {"HIERARCHY\nROOT a\n{\nCHANNELS 99999999999", 4, 10, "expected the number of channels"},
      {"HIERARCHY\nROOT a\n{\nCHANNELS 1 Xrotation\n}", 5, 1, "expected its OFFSET"},
      {"HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n}\nMOTION", 6, 1, "found no CHANNELS"},
      {deep, 0, 0, "nested more than 512 deep"},
      {kTree + "MOTIN", 13, 1, "expected MOTION"},
      {kTree + "MOTION\nFrames: many", 14, 9, "expected the number of frames"},
      {kTree + "MOTION\nFrames: -4", 14, 9, "expected the number of frames"},
      {kTree + "MOTION\nFrames: 3\n1 2 3", 15, 1, "expected 'Frame Time:'"},
      {withData("2", "", "nan"), 15, 13, "found 'nan'"},
      {withData("0", ""), 0, 0, "expected at least one frame of 7"},
      {withData("4000000000", "1 2 3\n"), 16, 0, "found 3 numbers and then the end"},
      {withData("2", frame + "1 2 3 nan 5 6 7\n"), 17, 7, "found 'nan'"},
      {withData("2", frame + "1 2 3 -inf 5 6 7\n"), 17, 7, "found '-inf'"},
      {withData("2", frame + "1 2 x 4 5 6 7\n"), 17, 5, "found 'x'"},
      {withData("2", frame + "1,5 2 3 4 5 6 7\n"), 17, 1, "a decimal point"},
      {withData("2", frame + "1 2 3 4 5 6 0x7"), 17, 13, "found '0x7'"},
      {withData("2", frame + "1 2 3 4 5 6 1e300\n"), 17, 13, "expected a number below 1e9"},
      {withData("3", frame + "1 2 3 4 5 6\n" + frame), 17, 12, "found 6 numbers on the line, expected 7"},
      {withData("3", "1 2 3 4 5 6\n" + frame + frame), 16, 12, "found 6 numbers on the line, expected 7"},
      {withData("2", frame + "1 2 3 4 5 6 7 8\n"), 17, 15, "found more numbers"}};
  for (const Case& c : cases) {
    try {
      readAll(c.text);
      FAIL() << "accepted: " << c.message;
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), HasSubstr(c.message));
      EXPECT_EQ(e.pos().file, "t.bvh");
      EXPECT_TRUE(c.line == 0 || e.pos().line == c.line) << e.what();
      EXPECT_TRUE(c.column == 0 || e.pos().column == c.column) << e.what();
    }
  }
}

// Every beginning of a file either reads or throws ParseError; the corpus of the fuzzer too.
TEST(BvhReader, ThrowsOnlyParseErrors) {
  const std::string whole = withData("2", "1 2 3 4 5 6 7\n8 9 10 11 12 13 14\n");
  std::vector<std::string> texts;
  for (std::size_t n = 0; n <= whole.size(); ++n) texts.push_back(whole.substr(0, n));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    texts.push_back(whole);
    texts.back()[i] = static_cast<char>(0xff - whole[i]);
  }
  for (const auto& entry :
       std::filesystem::directory_iterator(testing::projectFile("tests/fuzz/corpus/bvh"))) {
    std::ostringstream content;
    content << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    texts.push_back(content.str());
  }
  int read = 0;
  for (const auto& text : texts) {
    try {
      BvhReader reader(text, "t.bvh");
      while (const auto v = reader.next())
        for (const double x : *v) EXPECT_TRUE(std::isfinite(x));
      ++read;
    } catch (const ParseError&) {
    }
  }
  EXPECT_GT(read, 0);
  EXPECT_LT(static_cast<std::size_t>(read), texts.size());
}

}  // namespace bvh_reader_test
}  // namespace abstand::tracking
