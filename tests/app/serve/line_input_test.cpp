// Lines from a pipe, and skeletons as such lines.
#include "app/serve/line_input.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <random>
#include <string>

#include "app/serve/packet.hpp"
#include "app/serve/skeleton_line.hpp"
#include "app/serve/skeleton_sender.hpp"
#include "core/base/error.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::serve {
namespace line_input_test {

class Pipe {
 public:
  Pipe() { EXPECT_EQ(::pipe(ends_.data()), 0); }
  ~Pipe() {
    close();
    ::close(ends_[0]);
  }
  int reader() const { return ends_[0]; }
  void write(std::string_view text) {
    EXPECT_EQ(::write(ends_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void close() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// All lines that are there.
std::vector<std::string> lines(LineInput& input) {
  std::vector<std::string> all;
  while (const auto line = input.next()) all.emplace_back(*line);
  return all;
}

TEST(LineInput, ReturnsWholeLinesOnly) {
  Pipe pipe;
  LineInput input(pipe.reader(), 100);
  EXPECT_FALSE(input.next()) << "nothing is there, and it does not wait";
  pipe.write("one\ntwo\n\nthr");
  EXPECT_EQ(lines(input), (std::vector<std::string>{"one", "two", ""}));
  pipe.write("ee\nrest");
  EXPECT_EQ(lines(input), std::vector<std::string>{"three"});
  EXPECT_FALSE(input.hasEnded());
  EXPECT_EQ(input.handle(), pipe.reader());
  pipe.close();
  EXPECT_EQ(lines(input), std::vector<std::string>{"rest"});
  EXPECT_TRUE(input.hasEnded());
  EXPECT_EQ(input.handle(), -1);
  EXPECT_FALSE(input.next());
}

TEST(LineInput, SkipsLinesThatAreTooLong) {
  Pipe pipe;
  LineInput input(pipe.reader(), 8);
  pipe.write("12345678\n123456789\nshort\n" + std::string(100, 'x') + "\nend\n" + std::string(9, 'y'));
  pipe.close();
  std::vector<std::string> all;
  while (!input.hasEnded())
    for (std::string& line : lines(input)) all.push_back(std::move(line));
  EXPECT_EQ(all, (std::vector<std::string>{"12345678", "short", "end"}));
  EXPECT_EQ(input.tooLong(), 3);
}

/// However the bytes are cut, the lines are the same.
TEST(LineInput, LinesAreIndependentOfChunkBoundaries) {
  std::mt19937 random(1);
  std::string text;
  std::vector<std::string> sent;
  for (int i = 0; i < 300; ++i) {
    sent.emplace_back(random() % 20, static_cast<char>('a' + i % 26));
    text += sent.back() + "\n";
  }
  Pipe pipe;
  LineInput input(pipe.reader(), 64);
  std::vector<std::string> got;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t n = std::min<std::size_t>(1 + random() % 50, text.size() - at);
    pipe.write(text.substr(at, n));
    at += n;
    for (std::string& line : lines(input)) got.push_back(std::move(line));
  }
  EXPECT_EQ(got, sent);
  pipe.write("more\n");
  const abstand::testing::NoAlloc guard;
  EXPECT_EQ(input.next().value_or(""), "more");
  EXPECT_EQ(guard.count(), 0);
}

humanmodel::SkeletonFrame someone() {
  humanmodel::SkeletonFrame frame;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-3.0, 3.0);
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    if (j % 5 != 4)
      frame.set(static_cast<humanmodel::Joint>(j),
                {coordinate(random), coordinate(random), coordinate(random)},
                j % 3 == 0 ? humanmodel::JointState::kInferred : humanmodel::JointState::kTracked);
  for (std::size_t j = 0; j < humanmodel::kJointCount; j += 2)
    frame.spread[j] = 1e-3 * (coordinate(random) + 3.5);
  return frame;
}

TEST(SkeletonLine, RoundTripsBitExactly) {
  const PacketFormat format{{}, {"operator", "visitor"}};
  Packet packet = makePacket(format);
  const humanmodel::SkeletonFrame frame = someone();
  std::array<std::byte, kMaxLineBytes> room{};
  const std::size_t bytes = writeSkeletonLine(frame, "visitor", 4294967295u, 1234567, room);
  ASSERT_GT(bytes, 0u);
  ASSERT_EQ(parsePacket(std::span(room).first(bytes), format, packet), PacketFault::kNone);
  EXPECT_EQ(packet.type, PacketType::kSkeleton);
  EXPECT_EQ(packet.index, 1u);
  EXPECT_EQ(packet.sequence, 4294967295u);
  EXPECT_EQ(packet.time_us, 1234567u);
  EXPECT_EQ(packet.skeleton.state, frame.state);
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    if (frame.has(static_cast<humanmodel::Joint>(j))) {
      EXPECT_EQ(packet.skeleton.p[j], frame.p[j]) << j;
      EXPECT_EQ(packet.skeleton.spread[j], frame.spread[j]) << j;
    }

  const std::size_t empty = writeSkeletonLine({}, "operator", 0, 0, room);
  EXPECT_EQ(parsePacket(std::span(room).first(empty), format, packet), PacketFault::kNone);
  EXPECT_FALSE(packet.skeleton.has(humanmodel::Joint::kPelvis));
  EXPECT_EQ(writeSkeletonLine(frame, "operator", 0, 0, std::span(room).first(100)), 0u);
  for (const char* bad : {"", "a\"b", "a\\b", "a\nb"}) EXPECT_FALSE(isLineName(bad)) << bad;
  EXPECT_FALSE(isLineName(std::string(kMaxNameBytes + 1, 'n')));
}

TEST(SkeletonLine, LongestLineFitsBuffer) {
  humanmodel::SkeletonFrame frame;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    frame.set(static_cast<humanmodel::Joint>(j), Vector3d::Constant(-1.2345678901234567e-300),
              humanmodel::JointState::kInferred);
  frame.spread.fill(1.2345678901234567e-300);
  std::array<std::byte, kMaxLineBytes> room{};
  EXPECT_GT(writeSkeletonLine(frame, std::string(kMaxNameBytes, 'n'), 4294967295u, ~std::uint64_t{0}, room),
            0u);
}

TEST(SkeletonSender, AssignsNamesInOrderOfAppearance) {
  UdpSocket server(parseAddress("127.0.0.1:0", "--bind"));
  SkeletonSender sender(describe(server.address()), {"operator", "visitor"});
  const PacketFormat format{{}, {"operator", "visitor"}};
  const humanmodel::SkeletonFrame frame = someone();
  const auto received = [&] {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> got;  // person, sequence number
    std::array<std::byte, kMaxLineBytes> room{};
    Packet packet = makePacket(format);
    Address from;
    while (server.wait(0.0)) {
      const auto bytes = server.receive(room, from);
      EXPECT_EQ(parsePacket(std::span(room).first(bytes.value_or(0)), format, packet), PacketFault::kNone);
      got.emplace_back(packet.index, packet.sequence);
    }
    return got;
  };
  using Got = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  sender.send(7, 0.0, frame);
  sender.send(9, 0.0, frame);
  sender.send(12, 0.0, frame);
  EXPECT_EQ(received(), (Got{{0, 0}, {1, 0}}));
  EXPECT_EQ(sender.nameless(), 1);
  sender.send(9, 0.9, frame);
  sender.send(7, 0.95, frame);
  EXPECT_EQ(received(), (Got{{1, 1}, {0, 1}})) << "each keeps the name";
  sender.send(7, 1.8, frame);
  sender.send(12, 2.0, frame);
  EXPECT_EQ(received(), (Got{{0, 2}, {1, 2}})) << "who was gone for a second gave it back";
  EXPECT_EQ(sender.sent(), 6);
  EXPECT_EQ(sender.refused(), 0);
  const abstand::testing::NoAlloc guard;
  sender.send(7, 2.1, frame);
  EXPECT_EQ(guard.count(), 0);
}

TEST(SkeletonSender, RejectsInvalidAddressesAndNames) {
  EXPECT_THROW(SkeletonSender("127.0.0.1", {"a"}), UsageError);
  EXPECT_THROW(SkeletonSender("127.0.0.1:1", {"a\"b"}), UsageError);
  EXPECT_THROW(SkeletonSender("127.0.0.1:1", {"a", "a"}), UsageError);
}

}  // namespace line_input_test
}  // namespace abstand::serve
