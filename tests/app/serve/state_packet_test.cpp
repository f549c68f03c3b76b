// The answer as bytes and as JSON says the same, at the offsets that the table prints.
#include "app/serve/state_packet.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/serve/wire.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::serve {
namespace state_packet_test {

const PacketFormat kFormat{{{"arm \"left\"", 2}}, {"operator"}};
const StateNames kNames{{"link"}, {"link", "hand"}};

StateReport example() {
  StateReport r;
  r.time_us = 123456;
  r.cycle_us = 87.5;
  r.bad = 1;
  r.late = 2;
  r.lost = 3;
  r.duplicates = 4;
  r.person_age = {kInfinity};
  r.robots = {{0.25, 0.001, 1.5, safety::StopState::kSlowing, true, safety::StopReason::kSeparation}};
  r.torque = {1.0, -2.0};
  r.links = {{{1, 2, 3}, {4, 5, 6}}};
  r.separation = {{0, 1, Trust::kFresh, 0.3, 0.01, {7, 8, 9}, {10, 11, 12}}};
  r.nearest.resize(2);
  return r;
}

TEST(ServeState, LayoutMatchesManual) {
  // Offsets from docs/serve.md: 32 header, 32 server, 8 a person, 32 a mechanism, 8 a joint, 48 a link, 80 a
  // pair.
  const StateReport r = example();
  ASSERT_EQ(stateBytes(r), 32u + 32 + 8 + 32 + 2 * 8 + 48 + 80 + 2 * 80);
  std::vector<std::byte> bytes(stateBytes(r));
  const abstand::testing::NoAlloc guard;
  EXPECT_EQ(writeState(r, {9, 0, 55, true}, bytes), bytes.size());
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(load<std::uint32_t>(bytes, 0), kPacketMagic);
  EXPECT_EQ(load<std::uint16_t>(bytes, 6), 3);
  EXPECT_EQ(load<std::uint32_t>(bytes, 8), 9u);
  EXPECT_EQ(load<std::uint64_t>(bytes, 16), 55u);
  EXPECT_EQ(load<std::uint32_t>(bytes, 24), kFlagUnasked);
  EXPECT_EQ(load<std::uint32_t>(bytes, 28), bytes.size());
  EXPECT_EQ(load<std::uint64_t>(bytes, 32), 123456u);
  EXPECT_EQ(load<double>(bytes, 40), 87.5);
  EXPECT_EQ(load<std::uint32_t>(bytes, 60), 4u);
  EXPECT_EQ(load<double>(bytes, 64), kInfinity);
  EXPECT_EQ(load<double>(bytes, 72), 0.25);
  EXPECT_EQ(load<std::uint32_t>(bytes, 96), 1u);   // slowing
  EXPECT_EQ(load<std::uint32_t>(bytes, 100), 1u);  // separation
  EXPECT_EQ(load<double>(bytes, 112), -2.0);
  EXPECT_EQ(load<double>(bytes, 120 + 40), 6.0);
  EXPECT_EQ(load<std::int32_t>(bytes, 168 + 4), 1);
  EXPECT_EQ(load<std::uint32_t>(bytes, 168 + 8), 2u);
  EXPECT_EQ(load<double>(bytes, 168 + 16), 0.3);
  EXPECT_EQ(load<double>(bytes, 168 + 72), 12.0);
  EXPECT_EQ(load<std::int32_t>(bytes, 248), -1);
  EXPECT_EQ(load<double>(bytes, 248 + 16), -kInfinity);
}

TEST(ServeState, AdmittanceOffsetsFollowPairs) {
  StateReport r = example();
  const std::size_t without = stateBytes(r);
  r.offset = {0.125, -0.25};
  ASSERT_EQ(stateBytes(r), without + 16);
  std::vector<std::byte> bytes(stateBytes(r));
  writeState(r, {}, bytes);
  EXPECT_EQ(load<double>(bytes, without), 0.125);
  EXPECT_EQ(load<double>(bytes, without + 8), -0.25);
  std::vector<std::byte> text(4096);
  const std::size_t n = writeStateJson(r, {}, quoted(kFormat), quoted(kNames), text);
  const auto j = nlohmann::json::parse(std::string(reinterpret_cast<const char*>(text.data()), n));
  EXPECT_EQ(j["offset"], nlohmann::json({0.125, -0.25}));
  EXPECT_NE(describeLayout(kFormat, kNames, r).find("arm \"left\".q1 offset, rad or m\n"), std::string::npos);
}

TEST(ServeState, RefusedResetHasFlagAndReason) {
  StateReport r = example();
  r.robots[0].refusal = safety::ResetRefusal::kCause;
  std::vector<std::byte> bytes(4096);
  writeState(r, {9, 0, 55, true}, bytes);
  EXPECT_EQ(load<std::uint32_t>(bytes, 24), kFlagUnasked | kFlagRefused);
  const std::size_t n = writeStateJson(r, {}, quoted(kFormat), quoted(kNames), bytes);
  const auto j = nlohmann::json::parse(std::string(reinterpret_cast<const char*>(bytes.data()), n));
  EXPECT_EQ(j["mechanisms"][0]["reset_refused"], "a cause asks for a stop");
}

TEST(ServeState, JsonMatchesBinary) {
  const StateReport r = example();
  const PacketFormat format = quoted(kFormat);
  const StateNames names = quoted(kNames);
  std::vector<std::byte> bytes(4096);
  const abstand::testing::NoAlloc guard;
  const std::size_t n = writeStateJson(r, {9, 0, 55, false}, format, names, bytes);
  EXPECT_EQ(guard.count(), 0);
  const auto j = nlohmann::json::parse(std::string(reinterpret_cast<const char*>(bytes.data()), n));
  EXPECT_EQ(j["seq"], 9);
  EXPECT_EQ(j["lost"], 3);
  EXPECT_TRUE(j["people"][0]["age"].is_null());
  EXPECT_EQ(j["mechanisms"][0]["name"], "arm \"left\"");
  EXPECT_EQ(j["mechanisms"][0]["state"], "slowing");
  EXPECT_EQ(j["mechanisms"][0]["reason"], "separation");
  EXPECT_EQ(j["torque"], nlohmann::json({1.0, -2.0}));
  EXPECT_EQ(j["links"][0]["torque"][2], 6.0);
  EXPECT_EQ(j["separation"][0]["person"], "operator");
  EXPECT_EQ(j["separation"][0]["b"], "hand");
  EXPECT_EQ(j["separation"][0]["distance"], 0.3);
  EXPECT_TRUE(j["nearest"][0]["distance"].is_null());
  for (std::size_t room = 0; room < n; room += 7)
    EXPECT_EQ(writeStateJson(r, {}, format, names, std::span(bytes).first(room)), 0u);
}

TEST(ServeState, LayoutTableCoversWholePacket) {
  const StateReport r = example();
  const std::string text = describeLayout(kFormat, kNames, r);
  EXPECT_NE(text.find("state, the answer: " + std::to_string(stateBytes(r)) + " bytes"), text.npos);
  // The last number of the answer is 8 bytes long.
  EXPECT_NE(text.find("\n" + std::string(4, ' ') + std::to_string(stateBytes(r) - 8) + "  f64"), text.npos)
      << text;
  EXPECT_NE(text.find("operator - arm \"left\" distance, m"), text.npos);
  EXPECT_NE(text.find("1 hand"), text.npos);
}

}  // namespace state_packet_test
}  // namespace abstand::serve
