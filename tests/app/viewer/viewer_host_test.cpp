// A served scene and its viewers over real sockets: what they get is what the server found.
#include "app/viewer/viewer_host.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/serve/state_packet.hpp"
#include "app/viewer/stream_socket.hpp"
#include "app/viewer/viewer_link.hpp"
#include "app/viewer/watch_frame.hpp"
#include "tests/app/viewer/served_ball.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::viewer {
namespace viewer_host_test {

using testing::kAllowance;

struct ViewerHostTest : ::testing::Test, testing::ServedBall {
  std::shared_ptr<LiveRecord> record = std::make_shared<LiveRecord>();
  std::unique_ptr<ViewerLink> link(std::shared_ptr<LiveRecord> into, double rate = 60.0) {
    return std::make_unique<ViewerLink>(host->address(), std::move(into), LinkOptions{rate});
  }
  /// A connection that has sent `bytes`.
  Descriptor connection(std::span<const std::byte> bytes) {
    Descriptor socket = beginConnect(host->address());
    for (const double until = now() + kAllowance; now() < until && !isConnected(socket);)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(writeSome(socket, bytes), bytes.size());
    return socket;
  }
  /// True when the host has closed the connection.
  bool isClosed(const Descriptor& socket) {
    std::array<std::byte, 65536> bytes;
    return runUntil([&] { return !readSome(socket, bytes).has_value(); });
  }
};

TEST_F(ViewerHostTest, ShowsWhatTheServerFound) {
  const auto viewer = link(record);
  ASSERT_TRUE(runUntil([&] { return record->span().kept > 5; }));
  // The last cycle, until it has arrived.
  cycle(0.4);
  const double t = 1e-6 * static_cast<double>(scene->report().time_us);
  LiveRecord::Copy copy;
  for (const double until = now() + kAllowance; now() < until && !(copy.t >= t);) {
    host->look(now(), cycles, *scene);
    record->copyNewest(copy);
  }
  moment::Moment moment = moment::makeMoment(*record->card());
  ASSERT_TRUE(moment::readMoment(copy.frame, moment));
  const serve::PairReport& nearest = scene->report().nearest[0];
  const view::PairSnapshot& pair = moment.shown.pairs[0];
  EXPECT_EQ(pair.result.distance, nearest.distance);
  EXPECT_EQ(pair.result.bound, nearest.bound);
  // Ball of 0.1 m at 0.4 m over a plate.
  EXPECT_LE(pair.result.distance - pair.result.bound, 0.3);
  EXPECT_NEAR(pair.result.distance, 0.3, pair.result.bound + 1e-9);
  const auto& objects = scene->session().scene().objects();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    EXPECT_EQ(moment.shown.objects[i].X_WB.matrix(), objects[i].X_WB.matrix());
    EXPECT_EQ(moment.shown.objects[i].margin, objects[i].spec.margin);
  }
  EXPECT_EQ(moment.shown.joint_positions[0], 0.4);
  EXPECT_EQ(moment.shown.robots[0].state, scene->report().robots[0].state);
  EXPECT_EQ(moment.input_age[0], scene->report().robots[0].input_age);
  const auto card = record->card();
  EXPECT_EQ(card->objects, scene->names().objects);
  EXPECT_EQ(card->scene, moment::sceneKey((folder.path() / "scene.yaml").string()));
}

TEST_F(ViewerHostTest, AnUnchangedSceneIsAliveAndAHungLoopIsNot) {
  const auto viewer = link(record);
  ASSERT_TRUE(runUntil([&] { return record->status(steadySeconds()).state == LinkState::kConnected; }));
  // Rounds without a cycle, as of a server without input.
  bool alive = false;
  for (const double until = now() + kAllowance; now() < until && !alive;) {
    host->look(now(), cycles, *scene);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const LinkStatus status = record->status(steadySeconds());
    alive = status.moment_age > 1.5 && status.frame_age < 0.5;
  }
  EXPECT_TRUE(alive);
  // No rounds at all.
  const double hung = now();
  while (!record->status(steadySeconds()).stale() && now() < hung + kAllowance)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(record->status(steadySeconds()).stale());
}

TEST_F(ViewerHostTest, NobodyWatchesNothingIsCopied) {
  cycle(0.5);
  const testing::NoAlloc guard;
  for (int i = 0; i < 100; ++i) cycle(0.5);
  EXPECT_EQ(guard.count(), 0);
  host->stop();
  EXPECT_EQ(host->counts().sent, 0);
}

TEST_F(ViewerHostTest, TheLoopDoesNotAllocateWhileItIsWatched) {
  const auto viewer = link(record);
  ASSERT_TRUE(runUntil([&] { return record->span().kept > 5; }));
  const long number = static_cast<long>(record->span().kept);
  const testing::NoAlloc guard;
  long allocated = 0;
  for (const double until = now() + kAllowance;
       now() < until && record->span().kept < 30 + static_cast<std::size_t>(number);) {
    cycle(0.3);
    allocated = guard.count();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_EQ(allocated, 0);
  EXPECT_GT(record->span().kept, static_cast<std::size_t>(number));
}

TEST_F(ViewerHostTest, ASlowViewerLosesMomentsAndDisturbsNobody) {
  const auto slow = connection(watchFrame(100.0));  // never reads
  const auto viewer = link(record);
  const auto other = std::make_shared<LiveRecord>();
  const auto second = link(other, 20.0);
  // A wait for the slow viewer would have no end.
  ASSERT_TRUE(runUntil([&] {
    host->look(now(), cycles, *scene);
    return record->span().kept > 60 && other->span().kept > 20;
  }));
  // Until what the system holds for the slow one is full.
  runUntil([&] { return now() > 8.0; });
  host->stop();
  EXPECT_EQ(host->counts().accepted, 3);
  EXPECT_GT(host->counts().left_out, 0);
}

TEST_F(ViewerHostTest, DamagedFramesEndTheConnection) {
  auto frame = watchFrame(60.0);
  const auto with = [&](std::size_t at, std::byte value) {
    auto changed = frame;
    changed[at] = value;
    return changed;
  };
  EXPECT_TRUE(isClosed(connection(with(0, std::byte{0}))));  // magic
  EXPECT_TRUE(isClosed(connection(with(4, std::byte{2}))));  // version
  EXPECT_TRUE(isClosed(connection(with(6, std::byte{8}))));  // a moment
  EXPECT_TRUE(isClosed(connection(watchFrame(kNaN))));
  EXPECT_TRUE(isClosed(connection(watchFrame(-1.0))));
  host->stop();
  EXPECT_EQ(host->counts().bad, 5);
  EXPECT_EQ(host->counts().accepted, 0);
}

TEST_F(ViewerHostTest, ViewersAreLimitedAndExpire) {
  open({.viewers = 1, .renew = 0.5});
  const auto first = connection(watchFrame(10.0));
  std::array<std::byte, 65536> bytes;
  ASSERT_TRUE(runUntil([&] { return readSome(first, bytes).value_or(0) > 0; }));
  EXPECT_TRUE(isClosed(connection(watchFrame(10.0))));
  // It does not renew.
  EXPECT_TRUE(isClosed(first));
  // Then there is room again.
  const auto third = connection(watchFrame(10.0));
  EXPECT_TRUE(runUntil([&] { return readSome(third, bytes).value_or(0) > 0; }));
  host->stop();
  EXPECT_EQ(host->counts().refused, 1);
  EXPECT_EQ(host->counts().expired, 1);
  EXPECT_EQ(host->counts().accepted, 2);
}

TEST_F(ViewerHostTest, ALinkConnectsAgain) {
  const auto viewer = link(record);
  ASSERT_TRUE(runUntil([&] { return record->span().kept > 2; }));
  const double before = record->span().last;
  const serve::Address address = host->address();
  host.reset();
  for (const double until = now() + kAllowance; now() < until && !record->status(steadySeconds()).stale();)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_TRUE(record->status(steadySeconds()).stale());
  host = std::make_unique<ViewerHost>(address, cardOf(*scene), *scene);
  EXPECT_TRUE(runUntil([&] { return record->span().last > before + 0.1; }));
  EXPECT_FALSE(record->status(steadySeconds()).stale());
}

}  // namespace viewer_host_test
}  // namespace abstand::viewer
