// Control packets: groups of pairs and torques, as bytes and as JSON, and what is stale then.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/serve/groups_packet.hpp"
#include "app/serve/served_scene.hpp"
#include "app/serve/wire.hpp"
#include "tests/app/serve/joint_packet.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/paths.hpp"

namespace abstand::serve {
namespace control_test {

const PacketFormat kFormat{{{"arm", 1}}, {"operator"}, {"arm - operator", "arm - objects"}, {"l1", "p", "t"}};

PacketFault parse(std::string_view text, Packet& packet) {
  return parsePacket(std::as_bytes(std::span(text)), kFormat, packet);
}

std::vector<std::byte> control(std::uint32_t order, std::uint32_t group, std::uint32_t a, std::uint32_t b) {
  // Offsets by hand, from docs/serve.md.
  std::vector<std::byte> bytes(48);
  store(bytes, 0, kPacketMagic);
  store(bytes, 4, kProtocol);
  store(bytes, 6, std::uint16_t{4});
  store(bytes, 8, std::uint32_t{5});
  store(bytes, 16, std::uint64_t{6});
  store(bytes, 28, std::uint32_t{48});
  const std::uint32_t body[]{order, group, a, b};
  for (std::size_t i = 0; i < 4; ++i) store(bytes, 32 + 4 * i, body[i]);
  return bytes;
}

TEST(ControlPacket, BytesAndJsonAgree) {
  struct Case {
    std::vector<std::byte> bytes;
    const char* json;
    ControlOrder order;
  };
  const std::vector<Case> cases{
      {control(0, 0, 0, 0), R"("do":"report")", ControlOrder::kReport},
      {control(1, kAllGroups, 0, 0), R"("do":"run")", ControlOrder::kRun},
      {control(2, 1, 0, 0), R"("do":"pause","group":"arm - objects")", ControlOrder::kPause},
      {control(3, 0, 0, 0), R"("do":"stop","group":"arm - operator")", ControlOrder::kStop},
      {control(4, 1, 0, 2), R"("do":"add","group":"arm - objects","a":"l1","b":"t")", ControlOrder::kAdd},
      {control(5, 0, 2, 0), R"("do":"remove","a":"t","b":"l1")", ControlOrder::kRemove},
      {control(6, 0, 0, 0), R"("do":"torques_on")", ControlOrder::kTorquesOn},
      {control(7, 0, 0, 0), R"("do":"torques_off")", ControlOrder::kTorquesOff}};
  for (const Case& c : cases) {
    Packet binary = makePacket(kFormat), json = makePacket(kFormat);
    ASSERT_EQ(parsePacket(c.bytes, kFormat, binary), PacketFault::kNone) << c.json;
    ASSERT_EQ(parse(std::string(R"({"type":"control","seq":5,"time_us":6,)") + c.json + "}", json),
              PacketFault::kNone)
        << c.json;
    EXPECT_EQ(binary.type, PacketType::kControl);
    EXPECT_EQ(json.type, PacketType::kControl);
    EXPECT_EQ(binary.control.order, c.order);
    EXPECT_EQ(json.control.order, c.order);
    EXPECT_EQ(binary.sequence, json.sequence);
    if (c.order == ControlOrder::kPause || c.order == ControlOrder::kAdd || c.order == ControlOrder::kRun) {
      EXPECT_EQ(binary.control.group, json.control.group);
    }
    EXPECT_EQ(binary.control.a, json.control.a);
    EXPECT_EQ(binary.control.b, json.control.b);
  }
}

TEST(ControlPacket, RejectsUnknownGroupsAndPairs) {
  Packet p = makePacket(kFormat);
  EXPECT_EQ(parsePacket(control(8, 0, 0, 0), kFormat, p), PacketFault::kIndex);
  EXPECT_EQ(parsePacket(control(2, 2, 0, 0), kFormat, p), PacketFault::kIndex);
  EXPECT_EQ(parsePacket(control(4, kAllGroups, 0, 1), kFormat, p), PacketFault::kIndex);
  EXPECT_EQ(parsePacket(control(5, 0, 3, 0), kFormat, p), PacketFault::kIndex);
  EXPECT_EQ(parsePacket(control(5, 0, 0, 0xffffffff), kFormat, p), PacketFault::kIndex);
  const auto with = [&](const char* rest) {
    return parse(std::string(R"({"type":"control","seq":5,"time_us":6)") + rest + "}", p);
  };
  EXPECT_EQ(with(R"(,"do":"explode")"), PacketFault::kIndex);
  EXPECT_EQ(with(R"(,"do":"pause","group":"nobody")"), PacketFault::kIndex);
  EXPECT_EQ(with(R"(,"do":"remove","a":"l1","b":"nobody")"), PacketFault::kIndex);
  for (const char* rest :
       {"", R"(,"do":"pause","a":"l1")", R"(,"do":"remove","a":"l1")", R"(,"do":"add","a":"l1","b":"t")",
        R"(,"do":"report","group":"arm - objects")", R"(,"do":"pause","q":[0])",
        R"(,"do":"pause","do":"run")", R"(,"do":"run","reset":true)"})
    EXPECT_EQ(with(rest), PacketFault::kJson) << rest;
  EXPECT_EQ(parse(R"({"type":"joints","seq":1,"time_us":1,"q":[0],"do":"run"})", p), PacketFault::kJson);
}

/// A ball on a vertical slide (q is its height) over a plate whose top lies at z = 0.
class ControlledScene : public ::testing::Test {
 protected:
  ControlledScene() {
    folder_.write("slide.mech", "chain\n    frame   1   0      0          d    0\nend_chain\n");
    session::SessionOptions options;
    options.threads = 1;
    options.cache = false;
    const char* text =
        "abstand: 1\ndefaults: {voxel: 0.01, point: 0.01}\nmechanisms:\n"
        "  - {name: slide, file: slide.mech, q: [1], links: [{name: ball, frame: 1, shape: {sphere: {radius: "
        "0.1}}}]}\n"
        "objects:\n  - {name: plate, shape: {cuboid: {size: [1, 1, 0.2]}}, pose: {xyz: [0, 0, -0.1]}}\n";
    auto session = std::make_unique<session::Session>(
        scene_file::parseScene(text, folder_.path() / "scene.yaml"), options);
    scene_ = std::make_unique<ServedScene>(std::move(session), ServedOptions{usualReaction(), 4});
    packet_ = makePacket(scene_->format());
  }

  void joints(double height, double t, bool reset = false) {
    setJoint(packet_, height, t, reset);
    scene_->take(packet_, t);
    scene_->cycle(t);
  }
  session::PairControl::Outcome handle(const Control& order, double t) { return scene_->handle(order, t); }
  const StateReport& report() const { return scene_->report(); }

  abstand::testing::ScratchFolder folder_;
  std::unique_ptr<ServedScene> scene_;
  Packet packet_;
};

TEST_F(ControlledScene, StoppedGroupIsStaleAndStopsRobot) {
  joints(0.5, 0.01);
  ASSERT_EQ(report().robots[0].state, safety::StopState::kRunning);
  ASSERT_EQ(report().nearest[0].trust, Trust::kFresh);
  for (const ControlOrder order : {ControlOrder::kPause, ControlOrder::kStop}) {
    EXPECT_EQ(handle({order}, 0.02), session::PairControl::Outcome::kDone);
    joints(0.5, 0.02);
    EXPECT_EQ(report().not_checked, 1u);
    EXPECT_EQ(report().nearest[0].trust, Trust::kNone);
    EXPECT_EQ(report().nearest[0].distance, -kInfinity);
    EXPECT_EQ(report().robots[0].state, safety::StopState::kProtectiveStop);
    EXPECT_EQ(report().robots[0].speed_scale, 0.0);
  }
  EXPECT_EQ(handle({ControlOrder::kRun, 0}, 0.03), session::PairControl::Outcome::kDone);
  joints(0.5, 0.03);
  EXPECT_EQ(report().not_checked, 0u);
  EXPECT_EQ(report().nearest[0].trust, Trust::kFresh);
  EXPECT_EQ(report().robots[0].state, safety::StopState::kProtectiveStop) << "a person lets it go on";
  for (int i = 1; i <= 20; ++i) joints(0.5, 0.03 + 0.01 * i, i == 20);
  EXPECT_EQ(report().robots[0].state, safety::StopState::kRunning);
}

TEST_F(ControlledScene, PairIsRemovedAndAdded) {
  joints(0.5, 0.01);
  const Control remove{ControlOrder::kRemove, kAllGroups, 1, 0}, add{ControlOrder::kAdd, 0, 0, 1};
  EXPECT_EQ(handle(add, 0.01), session::PairControl::Outcome::kInGroup);
  EXPECT_EQ(handle({ControlOrder::kRemove, 0, 0, 0}, 0.01), session::PairControl::Outcome::kNoPair);
  EXPECT_EQ(handle(remove, 0.02), session::PairControl::Outcome::kDone);
  EXPECT_EQ(handle(remove, 0.02), session::PairControl::Outcome::kNotInGroup);
  joints(0.4, 0.02);
  EXPECT_EQ(scene_->control().withoutGroup(), 1u);
  EXPECT_EQ(report().nearest[0].trust, Trust::kNone);
  EXPECT_EQ(handle(add, 0.03), session::PairControl::Outcome::kDone);
  joints(0.4, 0.03);
  EXPECT_EQ(report().nearest[0].trust, Trust::kFresh);
  EXPECT_NEAR(report().nearest[0].distance, 0.3, 0.003);
}

TEST_F(ControlledScene, TorquesAreTurnedOffAndOn) {
  joints(0.09, 0.01);
  const double torque = report().torque[0];
  ASSERT_GT(torque, 0.0);
  handle({ControlOrder::kTorquesOff}, 0.02);
  joints(0.09, 0.02);
  EXPECT_EQ(report().torque[0], 0.0);
  EXPECT_GT(report().links[0].force.z(), 0.0) << "the contact is reported all the same";
  EXPECT_FALSE(report().torques_on);
  std::vector<std::byte> bytes(stateBytes(report()));
  writeState(report(), {}, bytes);
  EXPECT_EQ(load<std::uint32_t>(bytes, 24) & 8u, 8u);
  handle({ControlOrder::kTorquesOn}, 0.03);
  joints(0.09, 0.03);
  EXPECT_EQ(report().torque[0], torque);
  writeState(report(), {}, bytes);
  EXPECT_EQ(load<std::uint32_t>(bytes, 24) & 24u, 0u);
}

TEST_F(ControlledScene, AnswerReportsGroupStates) {
  joints(0.5, 0.01);
  const auto outcome = handle({ControlOrder::kPause, 0}, 0.02);
  joints(0.5, 0.02);
  const GroupsReport answer{scene_->control(), true, outcome, 20000};
  std::vector<std::byte> room(1000);
  ASSERT_EQ(writeGroups(answer, {9, 0, 7, false}, room), 64u);
  EXPECT_EQ(load<std::uint16_t>(room, 6), 5u);
  EXPECT_EQ(load<std::uint32_t>(room, 8), 9u);
  EXPECT_EQ(load<std::uint32_t>(room, 28), 64u);
  EXPECT_EQ(load<std::uint64_t>(room, 32), 20000u);
  const std::uint32_t expected[]{0, 1, 0, 1, 1, 1};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(load<std::uint32_t>(room, 40 + 4 * i), expected[i]) << i;
  const std::size_t bytes = writeGroupsJson(answer, {9, 0, 7, false}, quoted(scene_->format()), room);
  const auto json =
      nlohmann::json::parse(std::string_view(reinterpret_cast<const char*>(room.data()), bytes));
  EXPECT_EQ(json["type"], "groups");
  EXPECT_EQ(json["done"], true);
  EXPECT_TRUE(json["reason"].is_null());
  EXPECT_EQ(json["groups"][0]["name"], "slide - objects");
  EXPECT_EQ(json["groups"][0]["state"], "paused");
  EXPECT_EQ(json["groups"][0]["pairs"], 1);
  EXPECT_EQ(writeGroupsJson(answer, {}, quoted(scene_->format()), std::span(room).first(20)), 0u);
}

TEST_F(ControlledScene, OrdersAllocateNothing) {
  joints(0.5, 0.01);
  handle({ControlOrder::kPause}, 0.02);
  joints(0.5, 0.02);
  const abstand::testing::NoAlloc no_alloc;
  double t = 0.03;
  for (const ControlOrder order :
       {ControlOrder::kRun, ControlOrder::kPause, ControlOrder::kRun, ControlOrder::kRemove,
        ControlOrder::kAdd, ControlOrder::kTorquesOff, ControlOrder::kTorquesOn, ControlOrder::kStop}) {
    handle({order, 0, 0, 1}, t);
    joints(0.5, t);
    t += 0.01;
  }
  EXPECT_EQ(no_alloc.count(), 0);
}

}  // namespace control_test
}  // namespace abstand::serve
