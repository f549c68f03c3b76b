#include "core/base/number.hpp"

#include <gtest/gtest.h>

namespace abstand {
namespace number_test {

TEST(NumberText, ParsesCommonNotations) {
  EXPECT_EQ(parseDouble("1"), 1.0);
  EXPECT_EQ(parseDouble("-.5"), -0.5);
  EXPECT_EQ(parseDouble("+2e-3"), 0.002);
  EXPECT_EQ(parseDouble(".0083333"), 0.0083333);
  EXPECT_EQ(parseInt("42"), 42);
}

TEST(NumberText, RejectsOtherText) {
  for (const char* bad : {"", "nan", "inf", "-inf", "1,5", "1.5x", " 1", "0x10", "1e999", "+-1", "--1"})
    EXPECT_FALSE(parseDouble(bad)) << bad;
  for (const char* bad : {"", "1.0", "99999999999", "a"}) EXPECT_FALSE(parseInt(bad)) << bad;
}

TEST(NumberText, DoublesRoundTrip) {
  for (double v : {0.1, 1.0 / 3.0, 1e-300, -123456.789, 5e-324}) EXPECT_EQ(parseDouble(formatDouble(v)), v);
}

}  // namespace number_test
}  // namespace abstand
