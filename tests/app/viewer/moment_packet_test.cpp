// Moments and scenes as bytes: what is written is read, and nothing damaged is taken for a moment.
#include "app/moment/moment_packet.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/viewer/example_moment.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::moment {
namespace moment_packet_test {

/// True if what `change` makes of the example is rejected.
template <class Change>
bool isRejected(Change change) {
  Moment moment = exampleMoment(1.0);
  change(moment.shown);
  Moment read = makeMoment(exampleCard());
  return !readMoment(exampleFrame(moment), read);
}

TEST(MomentPacket, WhatIsWrittenIsRead) {
  const Moment moment = exampleMoment(12.5);
  const view::SceneSnapshot& a = moment.shown;
  const auto frame = exampleFrame(moment, 42);
  EXPECT_EQ(readHeader(frame)->sequence, 42u);
  Moment read = makeMoment(exampleCard());
  ASSERT_TRUE(readMoment(frame, read));
  const view::SceneSnapshot& b = read.shown;
  EXPECT_EQ(b.t, 12.5);
  EXPECT_EQ(b.cycle_us, 140.5);
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    // Every bit of a pose.
    EXPECT_EQ(b.objects[i].X_WB.matrix(), a.objects[i].X_WB.matrix());
    EXPECT_EQ(b.objects[i].p_WCom, a.objects[i].p_WCom);
    EXPECT_EQ(b.objects[i].velocity.linear, a.objects[i].velocity.linear);
    EXPECT_EQ(b.objects[i].margin, a.objects[i].margin);
    EXPECT_EQ(b.objects[i].pose_uncertainty, a.objects[i].pose_uncertainty);
    EXPECT_EQ(b.objects[i].pose_state, a.objects[i].pose_state);
    EXPECT_EQ(b.objects[i].colliding, a.objects[i].colliding);
  }
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_EQ(b.pairs[p].result.distance, a.pairs[p].result.distance);
    EXPECT_EQ(b.pairs[p].result.bound, a.pairs[p].result.bound);
    EXPECT_EQ(b.pairs[p].margin, a.pairs[p].margin);
    EXPECT_EQ(b.pairs[p].result.contacts, a.pairs[p].result.contacts);
    EXPECT_EQ(b.pairs[p].result.depth, a.pairs[p].result.depth);
    EXPECT_EQ(b.pairs[p].result.force_a, a.pairs[p].result.force_a);
    EXPECT_EQ(b.pairs[p].result.torque_b, a.pairs[p].result.torque_b);
  }
  EXPECT_EQ(b.pairs[0].result.witness_b, a.pairs[0].result.witness_b);
  EXPECT_TRUE(std::isnan(b.pairs[2].result.distance));
  EXPECT_TRUE(b.pairs[2].paused);
  EXPECT_EQ(b.pair_group, a.pair_group);
  EXPECT_EQ(b.groups[0].state, view::PairGroupState::kPaused);
  EXPECT_FALSE(b.torques_on);
  EXPECT_EQ(b.joint_positions, a.joint_positions);
  EXPECT_EQ(b.joint_efforts[1], 4.5);
  EXPECT_EQ(b.movers.person_age, a.movers.person_age);
  EXPECT_EQ(b.robots[0].state, safety::StopState::kProtectiveStop);
  EXPECT_EQ(b.robots[0].cause.value, 0.04);
  EXPECT_EQ(b.robots[0].cause.pair, 1);
  EXPECT_EQ(b.robots[0].since, 6.25);
  EXPECT_EQ(read.input_age, moment.input_age);
  EXPECT_EQ(read.counts.duplicates, 4u);
}

TEST(MomentPacket, ForcesOfAnEarlierMomentDoNotStay) {
  Moment read = makeMoment(exampleCard());
  ASSERT_TRUE(readMoment(exampleFrame(exampleMoment(1.0)), read));
  Moment apart = exampleMoment(2.0);
  apart.shown.pairs[1].result.force_a = apart.shown.pairs[1].result.torque_b = Vector3d::Zero();
  apart.shown.pairs[1].result.depth = 0.0;
  ASSERT_TRUE(readMoment(exampleFrame(apart), read));
  EXPECT_EQ(read.shown.pairs[1].result.force_a, Vector3d(0, 0, 0));
  EXPECT_EQ(read.shown.pairs[1].result.depth, 0.0);
}

TEST(MomentPacket, WhatWouldBeTakenForSafeIsRejected) {
  EXPECT_FALSE(isRejected([](auto&) {}));
  EXPECT_TRUE(isRejected([](auto& s) { s.pairs[0].result.distance = kInfinity; }));
  EXPECT_TRUE(isRejected([](auto& s) { s.pairs[0].result.bound = -0.1; }));
  EXPECT_TRUE(isRejected([](auto& s) { s.pairs[0].result.bound = kNaN; }));
  EXPECT_TRUE(isRejected([](auto& s) { s.pairs[0].margin = kNaN; }));
  EXPECT_TRUE(isRejected([](auto& s) { s.objects[0].X_WB.translation().x() = kNaN; }));
  EXPECT_TRUE(isRejected([](auto& s) { s.objects[0].X_WB.translation().x() = 1e7; }));
  EXPECT_TRUE(isRejected([](auto& s) { s.objects[0].X_WB.linear() *= 2.0; }));
  EXPECT_TRUE(isRejected([](auto& s) { s.objects[0].X_WB.linear().col(0) *= -1.0; }));
  EXPECT_TRUE(isRejected([](auto& s) { s.objects[0].pose_state = static_cast<scene::PoseState>(4); }));
  EXPECT_TRUE(isRejected([](auto& s) { s.objects[0].pose_uncertainty = kNaN; }));
  EXPECT_TRUE(isRejected([](auto& s) { s.objects[0].margin = -0.01; }));
  EXPECT_TRUE(isRejected([](auto& s) { s.robots[0].state = static_cast<safety::StopState>(5); }));
  EXPECT_TRUE(isRejected([](auto& s) { s.robots[0].speed_scale = 1.5; }));
  EXPECT_TRUE(isRejected([](auto& s) { s.pair_group[0] = 2; }));
  EXPECT_TRUE(isRejected([](auto& s) { s.t = kNaN; }));
  EXPECT_TRUE(isRejected([](auto& s) { s.movers.person_age[0] = kNaN; }));
  EXPECT_TRUE(isRejected([](auto& s) { s.joint_positions[0] = kInfinity; }));
}

TEST(MomentPacket, NoLengthButTheRightOneIsRead) {
  const auto frame = exampleFrame(exampleMoment(1.0));
  Moment read = makeMoment(exampleCard());
  for (std::size_t bytes = 0; bytes < frame.size(); ++bytes) {
    std::vector<std::byte> cut(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(bytes));
    EXPECT_FALSE(readMoment(cut, read)) << bytes;
    if (bytes < kFrameHeaderBytes) continue;
    // With a header that says so.
    FrameHeader header = *readHeader(frame);
    header.bytes = static_cast<std::uint32_t>(bytes);
    writeHeader(header, cut);
    EXPECT_FALSE(readMoment(cut, read)) << bytes;
  }
  std::vector<std::byte> longer = frame;
  longer.push_back({});
  EXPECT_FALSE(readMoment(longer, read));
}

TEST(MomentPacket, WritingAndReadingDoNotAllocate) {
  const Moment moment = exampleMoment(1.0);
  std::vector<std::byte> frame(maxMomentBytes(exampleCard()));
  Moment read = makeMoment(exampleCard());
  const testing::NoAlloc guard;
  const std::size_t bytes = writeMoment({}, moment, frame);
  EXPECT_TRUE(readMoment(std::span(frame).first(bytes), read));
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(writeMoment({}, moment, std::span(frame).first(bytes - 1)), 0u);
}

TEST(MomentPacket, TheLargestFrameHasForcesInAllPairs) {
  Moment moment = exampleMoment(1.0);
  for (auto& pair : moment.shown.pairs) pair.result.depth = 0.1;
  EXPECT_EQ(exampleFrame(moment).size(), maxMomentBytes(exampleCard()));
  for (auto& pair : moment.shown.pairs) pair.result = {};
  EXPECT_EQ(exampleFrame(moment).size(), minMomentBytes(exampleCard()));
  // Also of scenes whose moments are too large to be sent: 56 and 80 bytes for each pair.
  SceneCard large = exampleCard();
  large.pairs.assign(300003, {0, 1});
  EXPECT_EQ(maxMomentBytes(large), maxMomentBytes(exampleCard()) + 300000 * std::size_t{136});
  EXPECT_GT(maxMomentBytes(large), kMaxFrameBytes);
}

TEST(SceneCardFrame, IsReadAsWrittenAndCutOnesAreRejected) {
  const auto frame = writeSceneCard(exampleCard());
  const auto read = readSceneCard(frame);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, exampleCard());
  for (std::size_t bytes = 0; bytes < frame.size(); ++bytes) {
    std::vector<std::byte> cut(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(bytes));
    if (bytes >= kFrameHeaderBytes)
      writeHeader({FrameType::kScene, 0, 0, 0, static_cast<std::uint32_t>(bytes)}, cut);
    EXPECT_FALSE(readSceneCard(cut)) << bytes;
  }
  SceneCard wrong = exampleCard();
  wrong.pairs[0].second = 3;  // no such object
  EXPECT_FALSE(readSceneCard(writeSceneCard(wrong)));
}

TEST(SceneCardFrame, AHugeCountIsRejectedBeforeMemoryIsTaken) {
  auto frame = writeSceneCard(exampleCard());
  // The number of objects follows server, key and file name.
  const std::size_t at = kFrameHeaderBytes + 24 + 4 + exampleCard().file.size();
  const std::uint32_t many = 0xffffffff;
  std::memcpy(frame.data() + at, &many, sizeof many);
  EXPECT_FALSE(readSceneCard(frame));
}

TEST(FrameSplitter, GivesFramesHoweverTheyCome) {
  const auto a = exampleFrame(exampleMoment(1.0), 1), b = exampleFrame(exampleMoment(2.0), 2);
  std::vector<std::byte> stream = a;
  stream.insert(stream.end(), b.begin(), b.end());
  for (const std::size_t step : {std::size_t{1}, std::size_t{7}, stream.size()}) {
    FrameSplitter frames;
    std::vector<std::vector<std::byte>> got;
    for (std::size_t at = 0; at < stream.size(); at += step) {
      frames.add(std::span(stream).subspan(at, std::min(step, stream.size() - at)));
      while (const auto frame = frames.next()) got.emplace_back(frame->begin(), frame->end());
    }
    ASSERT_EQ(got.size(), 2u);
    EXPECT_EQ(got[0], a);
    EXPECT_EQ(got[1], b);
    EXPECT_FALSE(frames.damaged());
    EXPECT_EQ(frames.waiting(), 0u);
  }
}

TEST(FrameSplitter, StopsAtDamage) {
  const auto whole = exampleFrame(exampleMoment(1.0));
  const auto is_damage = [&](std::size_t byte, std::byte value) {
    auto bytes = whole;
    bytes[byte] = value;
    FrameSplitter frames;
    frames.add(bytes);
    return !frames.next() && frames.damaged();
  };
  EXPECT_TRUE(is_damage(0, std::byte{0}));      // magic
  EXPECT_TRUE(is_damage(4, std::byte{2}));      // version
  EXPECT_TRUE(is_damage(6, std::byte{77}));     // type
  EXPECT_TRUE(is_damage(31, std::byte{0x7f}));  // 2 GB
  FrameSplitter frames(whole.size() - 1);
  frames.add(whole);
  EXPECT_FALSE(frames.next());
  EXPECT_TRUE(frames.damaged());
}

}  // namespace moment_packet_test
}  // namespace abstand::moment
