#include "app/studio/still_robots.hpp"

#include "app/serve/packet.hpp"
#include "app/serve/wire.hpp"
#include "app/viewer/viewer_link.hpp"

namespace abstand::studio {

namespace {

constexpr int kSendEveryMs = 20;            // a fifth of the age at which `abstand serve` stops robots
constexpr std::uint16_t kJointsPacket = 1;  // docs/serve.md, Packets
constexpr double kMicroseconds = 1e6;       // per second

}  // namespace

StillRobots::StillRobots(const QString& server, std::vector<double> joints)
    : server_(serve::parseAddress(server.toStdString(), "server")),
      joints_(std::move(joints)),
      socket_(serve::parseAddress("127.0.0.1:0", "client")),
      packet_(serve::jointsBytes(joints_.size())),
      answer_(serve::kMaxPacketBytes) {
  connect(&timer_, &QTimer::timeout, this, [this] { send(0); });
  timer_.start(kSendEveryMs);
}

void StillRobots::resetStops() { send(serve::kFlagReset); }

void StillRobots::send(std::uint32_t flags) {
  const std::span<std::byte> bytes(packet_);
  serve::store(bytes, 0, serve::kPacketMagic);
  serve::store(bytes, 4, serve::kProtocol);
  serve::store(bytes, 6, kJointsPacket);
  serve::store(bytes, 8, sequence_++);
  serve::store(bytes, 12, serve::kAllMechanisms);
  serve::store(bytes, 16, static_cast<std::uint64_t>(kMicroseconds * viewer::steadySeconds()));
  serve::store(bytes, 24, flags);
  serve::store(bytes, 28, static_cast<std::uint32_t>(packet_.size()));
  for (std::size_t i = 0; i < joints_.size(); ++i)
    serve::store(bytes, serve::kHeaderBytes + sizeof(double) * i, joints_[i]);
  socket_.send(packet_, server_);
  // The answers are for a robot; the window reads what a viewer gets.
  serve::Address from;
  while (socket_.receive(answer_, from)) {
  }
}

}  // namespace abstand::studio
