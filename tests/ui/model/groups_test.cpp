#include "ui/model/groups.hpp"

#include <gtest/gtest.h>

namespace abstand::ui {
namespace groups_test {

TEST(Groups, AmbiguousNamesAreQualified) {
  view::SceneOutline outline;
  outline.objects = {{"left_arm/link7", "left_arm", false, true},
                     {"right_arm/link7", "right_arm", false, true},
                     {"operator/head", "operator", true, true},
                     {"table", "objects", false, false}};
  EXPECT_EQ(clearName(outline, 0), "left_arm/link7");
  EXPECT_EQ(clearName(outline, 1), "right_arm/link7");
  EXPECT_EQ(clearName(outline, 2), "head");
  EXPECT_EQ(clearName(outline, 3), "table");
}

}  // namespace groups_test
}  // namespace abstand::ui
