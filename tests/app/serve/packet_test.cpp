// Bytes to packets: what is accepted, and why the rest is dropped.
#include "app/serve/packet.hpp"

#include <gtest/gtest.h>

#include <random>

#include "app/serve/wire.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::serve {
namespace packet_test {

using Bytes = std::vector<std::byte>;

const PacketFormat kFormat{{{"left_arm", 2}, {"right_arm", 1}}, {"operator", "visitor"}};

Bytes header(PacketType type, std::uint32_t index, std::size_t bytes) {
  Bytes b(bytes);
  store(b, 0, kPacketMagic);
  store(b, 4, kProtocol);
  store(b, 6, static_cast<std::uint16_t>(type));
  store(b, 8, std::uint32_t{77});
  store(b, 12, index);
  store(b, 16, std::uint64_t{0x123456789abcdefULL});
  store(b, 28, static_cast<std::uint32_t>(bytes));
  return b;
}

Bytes joints(std::uint32_t index, const std::vector<double>& q) {
  Bytes b = header(PacketType::kJoints, index, jointsBytes(q.size()));
  for (std::size_t i = 0; i < q.size(); ++i) store(b, kHeaderBytes + 8 * i, q[i]);
  return b;
}

Bytes skeleton(std::uint32_t person) {
  Bytes b = header(PacketType::kSkeleton, person, skeletonBytes());
  for (std::size_t i = 0; i < 3 * humanmodel::kJointCount; ++i)
    store(b, kHeaderBytes + 8 * i, 0.01 * static_cast<double>(i));
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    store(b, kHeaderBytes + 24 * humanmodel::kJointCount + j, std::uint8_t{2});
  return b;
}

PacketFault parse(const Bytes& bytes) {
  Packet packet = makePacket(kFormat);
  return parsePacket(bytes, kFormat, packet);
}

PacketFault parse(std::string_view text, Packet& packet) {
  return parsePacket(std::as_bytes(std::span(text)), kFormat, packet);
}

PacketFault parse(std::string_view text) {
  Packet packet = makePacket(kFormat);
  return parse(text, packet);
}

TEST(ServePacket, ParsesJointsOfOneAndAllMechanisms) {
  Packet p = makePacket(kFormat);
  Bytes bytes = joints(0, {0.5, -1.25});
  store(bytes, 24, kFlagReset);
  ASSERT_EQ(parsePacket(bytes, kFormat, p), PacketFault::kNone);
  EXPECT_EQ(p.type, PacketType::kJoints);
  EXPECT_FALSE(p.json);
  EXPECT_TRUE(p.reset);
  EXPECT_EQ(p.sequence, 77u);
  EXPECT_EQ(p.time_us, 0x123456789abcdefULL);
  EXPECT_EQ(p.values, 2u);
  EXPECT_EQ(p.q[0], 0.5);
  EXPECT_EQ(p.q[1], -1.25);
  ASSERT_EQ(parsePacket(joints(kAllMechanisms, {1, 2, 3}), kFormat, p), PacketFault::kNone);
  EXPECT_EQ(p.values, 3u);
  EXPECT_EQ(p.q[2], 3.0);
  EXPECT_FALSE(p.reset);
}

TEST(ServePacket, HeaderLayoutMatchesManual) {
  // Written by hand from docs/serve.md, not by the functions of the program.
  const unsigned char raw[40] = {0x41, 0x42, 0x53, 0x54, 1, 0, 1, 0, 5, 0, 0,    0,   1, 0,
                                 0,    0,    0xe8, 3,    0, 0, 0, 0, 0, 0, 0,    0,   0, 0,
                                 40,   0,    0,    0,    0, 0, 0, 0, 0, 0, 0xf8, 0x3f};
  Packet p = makePacket(kFormat);
  ASSERT_EQ(parsePacket(std::as_bytes(std::span(raw)), kFormat, p), PacketFault::kNone);
  EXPECT_EQ(p.sequence, 5u);
  EXPECT_EQ(p.index, 1u);
  EXPECT_EQ(p.time_us, 1000u);
  EXPECT_EQ(p.q[0], 1.5);
}

TEST(ServePacket, ParsesSkeleton) {
  Packet p = makePacket(kFormat);
  Bytes bytes = skeleton(1);
  constexpr std::size_t kStates = kHeaderBytes + 24 * humanmodel::kJointCount;
  store(bytes, kStates + 3, std::uint8_t{0});
  store(bytes, kHeaderBytes + 24 * 3, kNaN);  // of a joint that is missing: not looked at
  store(bytes, kStates + 4, std::uint8_t{1});
  ASSERT_EQ(parsePacket(bytes, kFormat, p), PacketFault::kNone);
  EXPECT_EQ(p.type, PacketType::kSkeleton);
  EXPECT_EQ(p.index, 1u);
  EXPECT_FALSE(p.skeleton.has(humanmodel::Joint::kNeck));
  EXPECT_EQ(p.skeleton.state[4], humanmodel::JointState::kInferred);
  EXPECT_EQ(p.skeleton[humanmodel::Joint::kSpine], Vector3d(0.03, 0.04, 0.05));
}

TEST(ServePacket, ReportsFaultOfBadPackets) {
  EXPECT_EQ(parse(Bytes{}), PacketFault::kSize);
  EXPECT_EQ(parse(Bytes(3)), PacketFault::kSize);
  EXPECT_EQ(parse(Bytes(64)), PacketFault::kMagic);
  Bytes b = joints(0, {1, 2});
  EXPECT_EQ(parse(Bytes(b.begin(), b.end() - 1)), PacketFault::kSize);
  b.push_back(std::byte{0});
  EXPECT_EQ(parse(b), PacketFault::kSize);
  EXPECT_EQ(parse(joints(1, {1, 2})), PacketFault::kSize);
  EXPECT_EQ(parse(joints(2, {1, 2})), PacketFault::kIndex);
  EXPECT_EQ(parse(skeleton(2)), PacketFault::kIndex);
  for (const double bad : {kNaN, kInfinity, -kInfinity, 1.1e6}) {
    EXPECT_EQ(parse(joints(0, {1, bad})), PacketFault::kNumber);
    b = skeleton(0);
    store(b, kHeaderBytes + 8, bad);
    EXPECT_EQ(parse(b), PacketFault::kNumber);
  }
  b = skeleton(0);
  store(b, kHeaderBytes + 24 * humanmodel::kJointCount, std::uint8_t{3});
  EXPECT_EQ(parse(b), PacketFault::kNumber);
  b = joints(0, {1, 2});
  store(b, 4, std::uint16_t{2});
  EXPECT_EQ(parse(b), PacketFault::kVersion);
  EXPECT_EQ(parse(header(PacketType::kState, 0, 48)), PacketFault::kType);
  EXPECT_EQ(parse(header(PacketType{9}, 0, 48)), PacketFault::kType);
}

TEST(ServePacket, ParsesJson) {
  Packet p = makePacket(kFormat);
  ASSERT_EQ(parse(R"({"type":"joints","seq":3,"time_us":12,"mechanism":"right_arm","q":[0.25]})", p),
            PacketFault::kNone);
  EXPECT_TRUE(p.json);
  EXPECT_EQ(p.index, 1u);
  EXPECT_EQ(p.sequence, 3u);
  EXPECT_EQ(p.q[0], 0.25);
  ASSERT_EQ(
      parse("{ \"q\" : [1, 2e0,-3] , \"reset\":true, \"seq\":4294967295,\"time_us\":0,\"type\":\"joints\"}\n",
            p),
      PacketFault::kNone);
  EXPECT_EQ(p.index, kAllMechanisms);
  EXPECT_TRUE(p.reset);
  EXPECT_EQ(p.q[2], -3.0);
  ASSERT_EQ(parse(R"({"type":"skeleton","seq":1,"time_us":1,"person":"visitor","joints":)"
                  R"({"pelvis":[0,0,1],"neck":[0,0,1.5,"inferred"],"spine":null}})",
                  p),
            PacketFault::kNone);
  EXPECT_EQ(p.index, 1u);
  EXPECT_EQ(p.skeleton[humanmodel::Joint::kPelvis], Vector3d(0, 0, 1));
  EXPECT_EQ(p.skeleton.state[static_cast<std::size_t>(humanmodel::Joint::kNeck)],
            humanmodel::JointState::kInferred);
  EXPECT_FALSE(p.skeleton.has(humanmodel::Joint::kSpine));
  EXPECT_FALSE(p.skeleton.has(humanmodel::Joint::kHead));
}

TEST(ServePacket, JsonCarriesJointStateAndSpread) {
  Packet p = makePacket(kFormat);
  const auto parsed = [&](const std::string& joints) {
    return parse(R"({"type":"skeleton","seq":1,"time_us":1,"person":"visitor","joints":{)" + joints + "}}",
                 p);
  };
  const auto spread = [&](humanmodel::Joint j) { return p.skeleton.spread[static_cast<std::size_t>(j)]; };
  ASSERT_EQ(parsed(R"("pelvis":[0,0,1,0.02],"neck":[0,0,1.5,"inferred",0.5],"head":[0,0,1.7,"tracked",0])"),
            PacketFault::kNone);
  EXPECT_EQ(spread(humanmodel::Joint::kPelvis), 0.02);
  EXPECT_EQ(p.skeleton.state[static_cast<std::size_t>(humanmodel::Joint::kPelvis)],
            humanmodel::JointState::kTracked);
  EXPECT_EQ(spread(humanmodel::Joint::kNeck), 0.5);
  EXPECT_EQ(p.skeleton.state[static_cast<std::size_t>(humanmodel::Joint::kNeck)],
            humanmodel::JointState::kInferred);
  EXPECT_EQ(spread(humanmodel::Joint::kHead), 0.0);
  ASSERT_EQ(parsed(R"("pelvis":[0,0,1])"), PacketFault::kNone);
  EXPECT_EQ(spread(humanmodel::Joint::kPelvis), 0.0) << "nothing stays of the packet before";
  EXPECT_EQ(parsed(R"("pelvis":[0,0,1,-0.1])"), PacketFault::kNumber);
  EXPECT_EQ(parsed(R"("pelvis":[0,0,1,1e7])"), PacketFault::kNumber);
  for (const char* bad : {R"("pelvis":[0,0,1,0.1,"inferred"])", R"("pelvis":[0,0,1,"inferred",])",
                          R"("pelvis":[0,0,1,0.1,0.1])", R"("pelvis":[0,0,1,])"})
    EXPECT_EQ(parsed(bad), PacketFault::kJson) << bad;
}

TEST(ServePacket, ReportsFaultOfBadJson) {
  for (const char* bad :
       {"{", "{}", "{\"seq\":1}", R"({"type":"joints","seq":1,"time_us":1})",
        R"({"type":"joints","seq":1,"seq":2,"time_us":1,"q":[1,2,3]})",
        R"({"type":"joints","seq":-1,"time_us":1,"q":[1,2,3]})",
        R"({"type":"joints","seq":1.5,"time_us":1,"q":[1,2,3]})",
        R"({"type":"joints","seq":1,"time_us":1,"q":[1,2,NaN]})",
        R"({"type":"joints","seq":1,"time_us":1,"q":[1,2,1e999]})",
        R"({"type":"joints","seq":1,"time_us":1,"q":[1,2,3,4]})",
        R"({"type":"joints","seq":1,"time_us":1,"q":[1,2,3]} {})",
        R"({"type":"joints","seq":1,"time_us":1,"q":[1,2,3],"more":1})",
        R"({"type":"joi\u006ets","seq":1,"time_us":1,"q":[1,2,3]})",
        R"({"type":"skeleton","seq":1,"time_us":1,"person":"operator","joints":{"tail":[0,0,0]}})",
        R"({"type":"skeleton","seq":1,"time_us":1,"person":"operator","joints":{"neck":[0,0]}})",
        R"({"type":"skeleton","seq":1,"time_us":1,"person":"operator","joints":{"neck":null,"neck":null}})"})
    EXPECT_EQ(parse(std::string_view(bad)), PacketFault::kJson) << bad;
  EXPECT_EQ(parse(std::string_view(R"({"type":"state","seq":1,"time_us":1})")), PacketFault::kType);
  EXPECT_EQ(parse(std::string_view(R"({"type":"joints","seq":1,"time_us":1,"q":[1,2]})")),
            PacketFault::kSize);
  EXPECT_EQ(parse(std::string_view(R"({"type":"joints","seq":1,"time_us":1,"q":[1,2,1e7]})")),
            PacketFault::kNumber);
  EXPECT_EQ(parse(std::string_view(R"({"type":"joints","mechanism":"leg","seq":1,"time_us":1,"q":[1]})")),
            PacketFault::kIndex);
}

TEST(ServePacket, BrokenPacketsNeitherCrashNorAllocate) {
  Packet p = makePacket(kFormat);
  std::mt19937 random(1);
  const std::string_view line =
      R"({"type":"joints","seq":3,"time_us":12,"mechanism":"right_arm","q":[0.25]})";
  const auto text = std::as_bytes(std::span(line));
  const std::vector<Bytes> seeds{joints(0, {1, 2}), skeleton(1), Bytes(text.begin(), text.end())};
  Bytes bytes;
  bytes.reserve(1024);
  const abstand::testing::NoAlloc guard;
  for (int i = 0; i < 30000; ++i) {
    const Bytes& seed = seeds[static_cast<std::size_t>(i) % seeds.size()];
    bytes.assign(seed.begin(), seed.begin() + static_cast<std::ptrdiff_t>(
                                                  seed.size() - random() % 2 * (random() % seed.size())));
    for (unsigned k = random() % 4; k > 0 && !bytes.empty(); --k)
      bytes[random() % bytes.size()] = static_cast<std::byte>(random());
    if (parsePacket(bytes, kFormat, p) != PacketFault::kNone || p.type != PacketType::kJoints) continue;
    for (std::size_t j = 0; j < p.values; ++j) ASSERT_LE(std::abs(p.q[j]), kMaxCoordinate);
  }
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace packet_test
}  // namespace abstand::serve
