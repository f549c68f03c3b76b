#include <gtest/gtest.h>

#include <cstdlib>

int main(int argc, char** argv) {
  // The user's own cache folder is not for tests; those of the cache name one of theirs.
  ::setenv("ABSTAND_CACHE", "off", 1);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
