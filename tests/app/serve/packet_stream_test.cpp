// Sequence numbers: what is lost, late, seen twice, or of somebody else.
#include "app/serve/packet_stream.hpp"

#include "app/serve/joint_owners.hpp"

#include <gtest/gtest.h>

#include "core/base/error.hpp"

namespace abstand::serve {
namespace packet_stream_test {

const Address kHere = parseAddress("127.0.0.1:1000", "--bind");
const Address kThere = parseAddress("127.0.0.1:1001", "--bind");

struct PacketStreamTest : ::testing::Test {
  PacketStream stream{0.1};
  StreamCounts counts;
  double t{0.0};
  bool take(std::uint32_t n, const Address& from = kHere) { return stream.take(n, t += 0.001, from, counts); }
};

TEST_F(PacketStreamTest, InOrderPacketsCountNoFaults) {
  for (std::uint32_t n = 5; n < 500; ++n) EXPECT_TRUE(take(n));
  EXPECT_EQ(counts.late + counts.lost + counts.duplicates + counts.foreign, 0);
}

TEST_F(PacketStreamTest, CountsLostLateAndDuplicatePackets) {
  EXPECT_TRUE(take(10));
  EXPECT_TRUE(take(14));
  EXPECT_EQ(counts.lost, 3);
  EXPECT_FALSE(take(12));  // late, so not lost
  EXPECT_EQ(counts.lost, 2);
  EXPECT_EQ(counts.late, 1);
  EXPECT_FALSE(take(12));
  EXPECT_FALSE(take(14));
  EXPECT_EQ(counts.duplicates, 2);
  EXPECT_FALSE(take(9));  // before the first: late, but never counted as lost
  EXPECT_EQ(counts.late, 2);
  EXPECT_EQ(counts.lost, 2);
  EXPECT_TRUE(take(15));
  EXPECT_TRUE(take(15 + 100));  // beyond the window
  EXPECT_EQ(counts.lost, 2 + 99);
  EXPECT_FALSE(take(16));
  EXPECT_EQ(counts.late, 3);
}

TEST_F(PacketStreamTest, SequenceNumbersWrapAround) {
  EXPECT_TRUE(take(0xfffffffe));
  EXPECT_TRUE(take(0xffffffff));
  EXPECT_TRUE(take(0));
  EXPECT_TRUE(take(2));
  EXPECT_EQ(counts.lost, 1);
  EXPECT_FALSE(take(0xffffffff));
  EXPECT_EQ(counts.duplicates, 1);
}

TEST_F(PacketStreamTest, AcceptsOtherSenderOnlyAfterSilence) {
  EXPECT_TRUE(take(1));
  EXPECT_FALSE(take(2, kThere));
  EXPECT_EQ(counts.foreign, 1);
  t += 0.2;
  EXPECT_TRUE(take(1, kThere));
  EXPECT_FALSE(take(2, kHere));
  EXPECT_EQ(counts.foreign, 2);
}

TEST_F(PacketStreamTest, RestartsAfterSilence) {
  EXPECT_TRUE(take(1000));
  EXPECT_FALSE(take(1));
  t += 0.2;
  EXPECT_TRUE(take(1));
  EXPECT_EQ(counts.lost, 0);
}

TEST(JointOwnership, EveryJointValueHasOneSender) {
  JointOwners owners(2, 0.1);
  EXPECT_TRUE(owners.mayTake(kAllMechanisms, 0.0, kHere));
  owners.took(kAllMechanisms, 0.0, kHere);
  for (const std::uint32_t m : {0u, 1u, kAllMechanisms}) {
    EXPECT_FALSE(owners.mayTake(m, 0.05, kThere)) << m;
    EXPECT_TRUE(owners.mayTake(m, 0.05, kHere)) << m;
  }
  // Mechanism 1 falls silent, mechanism 0 does not: all together still have an owner.
  owners.took(0, 0.09, kHere);
  EXPECT_FALSE(owners.mayTake(0, 0.15, kThere));
  EXPECT_FALSE(owners.mayTake(kAllMechanisms, 0.15, kThere));
  EXPECT_TRUE(owners.mayTake(1, 0.15, kThere));
  owners.took(1, 0.15, kThere);
  EXPECT_FALSE(owners.mayTake(kAllMechanisms, 0.18, kHere));
  EXPECT_TRUE(owners.mayTake(0, 0.18, kHere));
}

TEST(ServeAddress, ParsesAndFormats) {
  for (const char* text : {"127.0.0.1:4780", "0.0.0.0:0", "[::1]:65535"})
    EXPECT_EQ(describe(parseAddress(text, "--bind")), text);
  for (const char* bad : {"", "localhost:1", "127.0.0.1", "127.0.0.1:", "127.0.0.1:65536", "127.0.0.1:1x",
                          "::1:5", "[127.0.0.1]:5", "127.0.0.1:-1"})
    EXPECT_THROW(parseAddress(bad, "--bind"), UsageError) << bad;
}

}  // namespace packet_stream_test
}  // namespace abstand::serve
