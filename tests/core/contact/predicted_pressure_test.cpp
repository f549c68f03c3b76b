// Pressures of a known force on known shapes, and which limit is nearest.
#include "core/contact/predicted_pressure.hpp"

#include <gtest/gtest.h>

#include "tests/core/contact/contact_table.hpp"

namespace abstand::contact {
namespace predicted_pressure_test {

constexpr double kExact = 1e-9;  // relative

ContactArea patch(double area, double volume, double x) {
  ContactArea a;
  a.area = area;
  a.volume = volume;
  a.indentation = x;
  return a;
}

TEST(ContactPressure, PeakMatchesClosedForms) {
  const double x = 0.004, force = 120.0;
  // A flat face of 1 cm^2: the same pressure everywhere, 120 N/cm^2.
  EXPECT_NEAR(patch(1e-4, 1e-4 * x, x).peakPressure(force), 120e4, kExact * 120e4);
  EXPECT_NEAR(patch(1e-4, 1e-4 * x, x).meanPressure(force), 120e4, kExact * 120e4);
  // A shallow cap and a right-angled edge: 2 F / A. A corner: 3 F / A.
  EXPECT_NEAR(patch(1e-4, 1e-4 * x / 2.0, x).peakPressure(force), 240e4, kExact * 240e4);
  EXPECT_NEAR(patch(1e-4, 1e-4 * x / 3.0, x).peakPressure(force), 360e4, kExact * 360e4);
}

TEST(ContactPressure, IsInfiniteWithoutCertainArea) {
  EXPECT_EQ(ContactArea{}.peakPressure(1.0), kInfinity);
  EXPECT_EQ(ContactArea{}.meanPressure(1.0), kInfinity);
  EXPECT_EQ(ContactArea{}.peakPressure(0.0), 0.0);
  EXPECT_EQ(patch(1e-4, 1e-7, 0.001).peakPressure(kNaN), kInfinity);
}

TEST(PredictedPressure, UsesSmallestLimitOfRegion) {
  const RegionLimits& hand = shipped("hand_fingers");
  for (const ContactKind kind : {ContactKind::kTransient, ContactKind::kQuasiStatic}) {
    const double factor = kind == ContactKind::kTransient ? 2.0 : 1.0;
    const PredictedContact c = predictContact(hand, {0.5, {5.4}, kind});
    const ContactArea face = patch(1e-4, 1e-4 * c.indentation, c.indentation);
    const PredictedPressure p = predictPressure(hand, c, face, kind);
    EXPECT_NEAR(p.peak, c.force / 1e-4, kExact * p.peak);
    EXPECT_NEAR(p.allowed, factor * 200e4, kExact * p.allowed);
    EXPECT_NEAR(p.share, c.force / (factor * 200.0), kExact * p.share);
  }
}

TEST(NearestLimit, IsPressureOnSmallAreaAndForceOnLargeArea) {
  const RegionLimits& hand = shipped("hand_fingers");
  const PredictedContact c = predictContact(hand, {0.5, {5.4}});
  // 280 N over 400 N/cm^2: 0.7 cm^2 of a flat face use both limits alike.
  for (const double area : {0.6e-4, 0.8e-4}) {
    const PredictedPressure p =
        predictPressure(hand, c, patch(area, area * c.indentation, c.indentation), ContactKind::kTransient);
    const NearestLimit nearest = nearestLimit(c, p);
    EXPECT_EQ(nearest.kind, area < 0.7e-4 ? LimitKind::kPressure : LimitKind::kForce);
    EXPECT_EQ(nearest.share, std::max(c.share, p.share));
  }
  EXPECT_EQ(nearestLimit(c).kind, LimitKind::kForce);
}

TEST(NearestLimit, IsExclusionForHead) {
  const RegionLimits& face = shipped("face");
  const PredictedContact c = predictContact(face, {0.0, {5.4}});
  const PredictedPressure p = predictPressure(face, c, ContactArea{}, ContactKind::kTransient);
  EXPECT_EQ(p.share, kInfinity);
  EXPECT_EQ(nearestLimit(c, p).kind, LimitKind::kExcluded);
  EXPECT_EQ(nearestLimit(c, p).share, kInfinity);
  EXPECT_EQ(limitText(LimitKind::kExcluded), "contact excluded");
}

}  // namespace predicted_pressure_test
}  // namespace abstand::contact
