// Joint motion: interpolation, clamping, and what is said about a bad table.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/math/transform.hpp"
#include "core/mechanism/motion_file.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/paths.hpp"

namespace abstand::mechanism {
namespace motion_file_test {

TEST(MotionFile, IsLinearBetweenRowsAndClampedOutside) {
  const MotionTable table = parseMotion("t,q0,q1\n0,1,-1\n2,3,0\n3,0,4\n", "m.csv", 2);
  EXPECT_EQ(table.rows(), 3u);
  EXPECT_EQ(table.start(), 0.0);
  EXPECT_EQ(table.end(), 3.0);
  struct Case {
    double t, q0, q1;
  };
  std::vector<double> q(2);
  const testing::NoAlloc guard;
  for (const Case& c : {Case{-5, 1, -1},
                        {0, 1, -1},
                        {0.5, 1.5, -0.75},
                        {1, 2, -0.5},
                        {2, 3, 0},
                        {2.5, 1.5, 2},
                        {3, 0, 4},
                        {1e9, 0, 4}}) {
    table.at(c.t, q);
    EXPECT_DOUBLE_EQ(q[0], c.q0) << c.t;
    EXPECT_DOUBLE_EQ(q[1], c.q1) << c.t;
  }
  EXPECT_EQ(guard.count(), 0);
}

TEST(MotionFile, ReadsSpreadsheetVariants) {
  const MotionTable table = parseMotion("\xEF\xBB\xBFt, q0\r\n0, 1\r\n\r\n1e0 ,\t2\r\n\r\n", "m.csv", 1);
  std::vector<double> q(1);
  table.at(0.25, q);
  EXPECT_DOUBLE_EQ(q[0], 1.25);
}

TEST(MotionFile, RoundTripsBitExactly) {
  const std::vector<double> t{-0.1, 1.0 / 3.0, 2e3}, q{0.1, -kPi, 1e-300, 0.0, 1.0 / 7.0, 1e9};
  const MotionTable again = parseMotion(formatMotion({t, q, 2}), "again.csv", 2);
  EXPECT_THAT(again.times(), ::testing::ElementsAreArray(t));
  EXPECT_THAT(again.values(), ::testing::ElementsAreArray(q));
}

TEST(MotionFile, MayHoldOneRow) {
  const MotionTable table = parseMotion("t,q0\n5,7", "m.csv", 1);
  std::vector<double> q(1);
  for (const double t : {0.0, 5.0, 9.0}) {
    table.at(t, q);
    EXPECT_EQ(q[0], 7.0);
  }
}

struct BadCase {
  const char* text;
  int line, column;
  const char* says;
};
class BadMotion : public ::testing::TestWithParam<BadCase> {};

TEST_P(BadMotion, IsRejectedWithPosition) {
  const auto& c = GetParam();
  try {
    parseMotion(c.text, "m.csv", 2);
    FAIL() << "was read";
  } catch (const ParseError& e) {
    EXPECT_EQ(e.pos().line, c.line) << e.what();
    EXPECT_EQ(e.pos().column, c.column) << e.what();
    EXPECT_THAT(e.what(), ::testing::HasSubstr(c.says));
  }
}

INSTANTIATE_TEST_SUITE_P(All, BadMotion,
                         ::testing::Values(BadCase{"", 0, 0, "no row"}, BadCase{"t,q0,q1\n", 0, 0, "no row"},
                                           BadCase{"0,1,2\n", 1, 1, "header t,q0,q1"},
                                           BadCase{"t,q1,q0\n", 1, 3, "header t,q0,q1"},
                                           BadCase{"t,q0\n0,1\n", 1, 5, "found 2 columns, expected 3"},
                                           BadCase{"t,q0,q1,q2\n", 1, 9, "another column 'q2'"},
                                           BadCase{"t,q0,q1\n0,1\n", 2, 4, "found 2 columns"},
                                           BadCase{"t,q0,q1\n0,1,2,3\n", 2, 7, "another column '3'"},
                                           BadCase{"t,q0,q1\n\n0,x,2\n", 3, 3, "'x'"},
                                           BadCase{"t,q0,q1\n0,1,\n", 2, 5, "''"},
                                           BadCase{"t,q0,q1\nnan,1,2\n", 2, 1, "'nan'"},
                                           BadCase{"t,q0,q1\n0,1,inf\n", 2, 5, "q1"},
                                           BadCase{"t,q0,q1\n1,1,1\n1,1,1\n", 3, 1, "rising"},
                                           BadCase{"t,q0,q1\n1,1,1\n0.5,1,1\n", 3, 1, "0.5"}));

TEST(MotionFile, ShippedMotionsAreReadAndSlow) {
  struct Case {
    const char* file;
    int dof;
    double end, fastest;  // s; rad/s or m/s, with some room above what the scene wants
  };
  const double kArm = unit::deg(184);  // the slowest limit of the joints that turn fast here
  for (const Case& c : {Case{"hug_alone_left.csv", 7, 20.0, kArm},
                        {"hug_alone_right.csv", 7, 20.0, kArm},
                        {"hug_gentle_left.csv", 7, 31.0, 0.5},
                        {"hug_gentle_right.csv", 7, 31.0, 0.5},
                        {"rod.csv", 1, 6.0, 2.0},
                        {"sphere_fast.csv", 1, 8.0, 0.708},
                        {"sphere_slow.csv", 1, 8.5, 0.354}}) {
    SCOPED_TRACE(c.file);
    const auto table = loadMotion(testing::projectFile(std::string("data/scenes/motion/") + c.file), c.dof);
    EXPECT_EQ(table.start(), 0.0);
    EXPECT_NEAR(table.end(), c.end, 1e-9);
    std::vector<double> before(static_cast<std::size_t>(c.dof)), now(before);
    const double dt = 0.01;
    table.at(0.0, before);
    for (double t = dt; t < table.end(); t += dt) {
      table.at(t, now);
      for (std::size_t i = 0; i < now.size(); ++i)
        EXPECT_LT(std::abs(now[i] - before[i]) / dt, c.fastest) << t;
      before = now;
    }
  }
}

TEST(MotionFile, ErrorsNameFile) {
  testing::ScratchFolder folder;
  const auto file = folder.write("bad.csv", "t\n");
  try {
    loadMotion(file, 1);
    FAIL();
  } catch (const ParseError& e) {
    EXPECT_EQ(e.pos().file, file.string());
  }
  EXPECT_THROW(loadMotion(folder.path() / "none.csv", 1), ParseError);
}

}  // namespace motion_file_test
}  // namespace abstand::mechanism
