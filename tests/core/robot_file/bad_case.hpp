// A file with a mistake, and what is said of it.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/base/error.hpp"

namespace abstand::robot_file {

struct BadCase {
  const char* name;
  const char* text;
  int line, column;
  const char* says;
};
inline void PrintTo(const BadCase& c, std::ostream* out) { *out << c.name; }

/// `parse(text, file)` refuses the case as a ParseError at its place of `file`, and says `also`.
template <class Parse>
void expectRefused(const BadCase& c, const std::string& file, Parse parse, const char* also = "") {
  try {
    parse(c.text, file);
    FAIL() << "was read";
  } catch (const ParseError& e) {
    EXPECT_EQ(e.pos().line, c.line) << e.what();
    EXPECT_EQ(e.pos().column, c.column) << e.what();
    EXPECT_THAT(e.what(), ::testing::StartsWith(file + ":"));
    EXPECT_THAT(e.what(), ::testing::HasSubstr(c.says));
    EXPECT_THAT(e.what(), ::testing::HasSubstr(also));
  }
}

}  // namespace abstand::robot_file
