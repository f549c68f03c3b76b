// Contact limits in result files.
#include "app/tune/stored_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"
#include "core/contact/contact_limits_reader.hpp"
#include "humanmodel/body_part.hpp"

namespace abstand::tune {
namespace stored_limits_test {

contact::ContactLimits table() {
  return contact::loadContactLimits(contact::defaultContactLimits(), humanmodel::partNames());
}

TEST(StoredLimits, LineKeepsEveryNumberThatCountsAndItsSource) {
  for (const contact::RegionLimits& region : table().regions) {
    const contact::RegionLimits read = regionOf(regionLine(region), "file");
    EXPECT_EQ(read.name, region.name);
    EXPECT_EQ(read.excluded(), region.excluded());
    EXPECT_EQ(read.force.value, region.force.value);
    EXPECT_EQ(read.force.source, region.force.source);
    EXPECT_EQ(read.transient.to_be_checked, region.transient.to_be_checked);
    EXPECT_EQ(read.pressure(), region.pressure());
    EXPECT_EQ(read.spring.value, region.spring.value);
    EXPECT_EQ(read.body_mass.value, region.body_mass.value);
    EXPECT_EQ(regionLine(read), regionLine(region));
    // The same prediction from the file as from the table.
    const contact::ContactMotion motion{0.7, {12.0}};
    EXPECT_EQ(contact::predictContact(read, motion).share, contact::predictContact(region, motion).share);
  }
}

TEST(StoredLimits, RejectsDamagedLines) {
  contact::RegionLimits region = table().regions.back();
  EXPECT_THROW(regionOf("", "file"), ParseError);
  EXPECT_THROW(regionOf("chest\tsternum\t140", "file"), ParseError);
  for (const double wrong : {0.0, -1.0, kInfinity}) {
    contact::RegionLimits bad = region;
    bad.spring.value = wrong;
    EXPECT_THROW(regionOf(regionLine(bad), "file"), ParseError) << wrong;
  }
  region.force.value = kNaN;
  EXPECT_THROW(regionOf(regionLine(region), "file"), ParseError) << "only the factor may be missing";
}

TEST(StoredLimits, SeparatorsInTextsDoNotMoveFields) {
  contact::RegionLimits region = table().regions.front();
  region.force.source = "an edition\twith a tab\nand a line";
  const contact::RegionLimits read = regionOf(regionLine(region), "file");
  EXPECT_EQ(read.force.source, "an edition with a tab and a line");
  EXPECT_EQ(read.spring.value, region.spring.value);
}

TEST(StoredLimits, OnlyRegionsOfContactsAreKept) {
  PassResult pass;
  pass.approaches.resize(3);
  pass.approaches[0].contact.region = "chest";
  pass.regions = {"face"};
  const auto regions = occurringRegions(pass, table());
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0].name, "face") << "in the order of the table";
  EXPECT_TRUE(regions[0].excluded());
  EXPECT_EQ(regions[1].name, "chest");
  EXPECT_EQ(regions[1].pressures.size(), 1u);
}

}  // namespace stored_limits_test
}  // namespace abstand::tune
