#include "app/serve/packet.hpp"

#include <algorithm>
#include <cmath>

#include "app/serve/wire.hpp"

namespace abstand::serve {
namespace {

constexpr std::array<std::string_view, kPacketFaults> kFaultNames{"none", "size",  "magic",  "version",
                                                                  "type", "index", "number", "json"};
constexpr std::array<std::string_view, kControlOrders> kOrderNames{
    "report", "run", "pause", "stop", "add", "remove", "torques_on", "torques_off"};
constexpr std::size_t kMagicBytes = 4;

PacketFault readJoints(std::span<const std::byte> bytes, const PacketFormat& format, Packet& out) {
  if (!format.hasMechanism(out.index)) return PacketFault::kIndex;
  out.values = format.dof(out.index);
  if (bytes.size() != jointsBytes(out.values)) return PacketFault::kSize;
  for (std::size_t i = 0; i < out.values; ++i) {
    out.q[i] = load<double>(bytes, kHeaderBytes + 8 * i);
    if (!isUsableCoordinate(out.q[i])) return PacketFault::kNumber;
  }
  return PacketFault::kNone;
}

PacketFault readSkeleton(std::span<const std::byte> bytes, const PacketFormat& format, Packet& out) {
  if (out.index >= format.people.size()) return PacketFault::kIndex;
  if (bytes.size() != skeletonBytes()) return PacketFault::kSize;
  constexpr std::size_t kStates = kHeaderBytes + 24 * humanmodel::kJointCount;
  out.skeleton.spread.fill(0.0);
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const auto state = load<std::uint8_t>(bytes, kStates + j);
    if (state > static_cast<std::uint8_t>(humanmodel::JointState::kTracked)) return PacketFault::kNumber;
    Vector3d p = Vector3d::Constant(kNaN);
    if (state != static_cast<std::uint8_t>(humanmodel::JointState::kMissing)) {
      for (std::size_t k = 0; k < 3; ++k) {
        p[static_cast<Eigen::Index>(k)] = load<double>(bytes, kHeaderBytes + 24 * j + 8 * k);
        if (!isUsableCoordinate(p[static_cast<Eigen::Index>(k)])) return PacketFault::kNumber;
      }
    }
    out.skeleton.set(static_cast<humanmodel::Joint>(j), p, static_cast<humanmodel::JointState>(state));
  }
  return PacketFault::kNone;
}

PacketFault readControl(std::span<const std::byte> bytes, const PacketFormat& format, Packet& out) {
  if (bytes.size() != kControlBytes) return PacketFault::kSize;
  const auto order = load<std::uint32_t>(bytes, kHeaderBytes);
  if (order >= kControlOrders) return PacketFault::kIndex;
  out.control = {static_cast<ControlOrder>(order), load<std::uint32_t>(bytes, kHeaderBytes + 4),
                 load<std::uint32_t>(bytes, kHeaderBytes + 8), load<std::uint32_t>(bytes, kHeaderBytes + 12)};
  return checkControl(format, out.control);
}

}  // namespace

std::string_view orderName(ControlOrder order) { return kOrderNames[static_cast<std::size_t>(order)]; }

PacketFault checkControl(const PacketFormat& format, const Control& control) noexcept {
  const ControlOrder order = control.order;
  const bool one = order == ControlOrder::kAdd, pair = one || order == ControlOrder::kRemove;
  const bool groups =
      one || order == ControlOrder::kRun || order == ControlOrder::kPause || order == ControlOrder::kStop;
  if (groups && control.group >= format.groups.size() && (one || control.group != kAllGroups))
    return PacketFault::kIndex;
  if (pair && (control.a >= format.objects.size() || control.b >= format.objects.size()))
    return PacketFault::kIndex;
  return PacketFault::kNone;
}

std::size_t PacketFormat::dof() const {
  std::size_t sum = 0;
  for (const Mechanism& m : mechanisms) sum += m.dof;
  return sum;
}

std::size_t PacketFormat::dof(std::uint32_t mechanism) const {
  return mechanism == kAllMechanisms ? dof() : mechanisms[mechanism].dof;
}

bool PacketFormat::hasMechanism(std::uint32_t index) const {
  return index < mechanisms.size() || (index == kAllMechanisms && !mechanisms.empty());
}

Packet makePacket(const PacketFormat& format) {
  Packet packet;
  packet.q.assign(format.dof(), 0.0);
  return packet;
}

std::string_view faultName(PacketFault fault) { return kFaultNames[static_cast<std::size_t>(fault)]; }

PacketFault parsePacket(std::span<const std::byte> bytes, const PacketFormat& format, Packet& out) noexcept {
  ABSTAND_CHECK(out.q.size() == format.dof());
  if (!bytes.empty() && bytes[0] == std::byte{'{'})
    return parseJsonPacket({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, format, out);
  if (bytes.size() >= kMagicBytes && load<std::uint32_t>(bytes, 0) != kPacketMagic)
    return PacketFault::kMagic;
  if (bytes.size() < kHeaderBytes) return PacketFault::kSize;
  if (load<std::uint16_t>(bytes, 4) != kProtocol) return PacketFault::kVersion;
  out.json = false;
  out.type = static_cast<PacketType>(load<std::uint16_t>(bytes, 6));
  out.sequence = load<std::uint32_t>(bytes, 8);
  out.index = load<std::uint32_t>(bytes, 12);
  out.time_us = load<std::uint64_t>(bytes, 16);
  out.reset = (load<std::uint32_t>(bytes, 24) & kFlagReset) != 0;
  if (load<std::uint32_t>(bytes, 28) != bytes.size()) return PacketFault::kSize;
  if (out.type == PacketType::kJoints) return readJoints(bytes, format, out);
  if (out.type == PacketType::kSkeleton) return readSkeleton(bytes, format, out);
  if (out.type == PacketType::kControl) return readControl(bytes, format, out);
  return PacketFault::kType;
}

}  // namespace abstand::serve
