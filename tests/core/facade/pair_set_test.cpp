// Pairs asked together through the library answer as each of them does alone.
#include "abstand/pair_set.hpp"

#include <gtest/gtest.h>

namespace abstand {
namespace pair_set_test {

// m. Inside each other distances are those of fields of 10 mm voxels, good to a tenth of one.
constexpr double kExact = 1e-3;
// m. Shell points stand 10 mm apart on a radius of 0.1 m: none needs to be the deepest.
constexpr double kBetweenPoints = 2e-3;
constexpr StructureOptions kCoarse{.voxel_size = 0.01, .point_spacing = 0.01};

Pose at(double x) {
  Pose X = Pose::Identity();
  X.translation() << x, 0.0, 1.0;
  return X;
}

/// Three spheres in a row, radius 0.1 m.
PairSet threeSpheres() {
  const Structure ball = Structure::build(Shape::sphere(0.1), kCoarse);
  return {{ball, ball, ball}, {{0, 1}, {0, 2}, {1, 2}}};
}

TEST(LibraryPairSet, FindsNearestPairAndContacts) {
  PairSet set = threeSpheres();
  ASSERT_EQ(set.size(), 3u);
  for (int frame = 0; frame < 20; ++frame) {
    // The third sphere goes through the second one, which stands 0.3 m beside the first.
    const double x = 0.8 - 0.02 * frame;
    const Pose poses[] = {at(0.0), at(0.3), at(x)};
    PairResult all[3];
    set.distances(poses, {}, all);
    EXPECT_NEAR(all[0].distance, 0.1, kExact);
    EXPECT_NEAR(all[2].distance, std::abs(x - 0.3) - 0.2, kExact) << x;
    EXPECT_LE(all[2].distance - all[2].bound, std::abs(x - 0.3) - 0.2) << x;
    const PairSet::Nearest nearest = set.nearest(poses);
    const std::size_t expected = all[2].distance < 0.1 ? 2 : 0;
    const bool tie = std::abs(all[2].distance - 0.1) <= kExact;
    EXPECT_TRUE(tie || nearest.pair == expected) << x;
    EXPECT_NEAR(nearest.result.distance, std::min(0.1, all[2].distance), kExact) << x;
    const auto contacts = set.contacts(poses, {.margin = 0.01});
    const double depth = 0.01 - all[2].distance;
    if (depth < -kExact) {
      EXPECT_TRUE(contacts.empty()) << x;
    } else if (depth > kBetweenPoints) {
      ASSERT_EQ(contacts.size(), 1u) << x;
      EXPECT_EQ(contacts[0].pair, 2u);
      EXPECT_NEAR(contacts[0].depth, depth, kBetweenPoints) << x;
      EXPECT_LT(contacts[0].force_a.x(), 0.0) << "the second sphere is pressed towards the first";
    }
  }
}

TEST(LibraryPairSet, RejectsInvalidArguments) {
  const Structure ball = Structure::build(Shape::sphere(0.1), kCoarse);
  EXPECT_THROW(PairSet({ball}, {}), std::runtime_error);
  EXPECT_THROW(PairSet({ball}, {{0, 1}}), std::runtime_error);
  PairSet set = threeSpheres();
  const Pose two[] = {at(0.0), at(1.0)};
  Pose bent[] = {at(0.0), at(1.0), at(2.0)};
  PairResult results[3];
  EXPECT_THROW(set.nearest(two), std::runtime_error);
  EXPECT_THROW(set.distances(bent, {}, std::span(results).first(2)), std::runtime_error);
  EXPECT_THROW(set.contacts(bent, {.margin = -1.0}), std::runtime_error);
  bent[1].linear() *= 2.0;
  EXPECT_THROW(set.contacts(bent), std::runtime_error);
}

}  // namespace pair_set_test
}  // namespace abstand
