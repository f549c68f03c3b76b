// What a client sends to `abstand serve`: packets of bytes, or what is wrong with them. See docs/serve.md.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::serve {

inline constexpr std::uint32_t kPacketMagic = 0x54534241;  ///< the bytes "ABST"
inline constexpr std::uint16_t kProtocol = 1;
inline constexpr std::size_t kHeaderBytes = 32;
/// Most that fits into a datagram over IPv4.
inline constexpr std::size_t kMaxPacketBytes = 65507;
/// As the index of a packet of joints: those of all mechanisms, one after the other.
inline constexpr std::uint32_t kAllMechanisms = 0xffffffff;
/// rad or m. Joint values and coordinates farther from 0 are refused, as Scene refuses such poses.
inline constexpr double kMaxCoordinate = 1e6;
inline bool isUsableCoordinate(double v) { return std::abs(v) <= kMaxCoordinate; }

enum class PacketType : std::uint16_t { kJoints = 1, kSkeleton = 2, kState = 3, kControl = 4, kGroups = 5 };

/// Bits of the header's flags.
inline constexpr std::uint32_t kFlagReset = 1;        ///< joints: a person lets a stopped robot go on
inline constexpr std::uint32_t kFlagUnasked = 2;      ///< state: answers no packet
inline constexpr std::uint32_t kFlagRefused = 4;      ///< state: a reset was refused in this cycle
inline constexpr std::uint32_t kFlagTorquesOff = 8;   ///< state: torques are turned off
inline constexpr std::uint32_t kFlagNotChecked = 16;  ///< state: some pairs are not checked: they are stale

/// What is not the same in every scene, and does not change while one is served.
struct PacketFormat {
  struct Mechanism {
    std::string name;
    std::size_t dof{0};
  };
  std::vector<Mechanism> mechanisms;
  std::vector<std::string> people;
  std::vector<std::string> groups{}, objects{};  ///< that a control packet may name

  std::size_t dof() const;                         ///< of all mechanisms
  std::size_t dof(std::uint32_t mechanism) const;  ///< of one, or of kAllMechanisms
  bool hasMechanism(std::uint32_t index) const;
};

/// Bytes of a packet with `dof` joint values, and of one with a skeleton.
constexpr std::size_t jointsBytes(std::size_t dof) { return kHeaderBytes + 8 * dof; }
constexpr std::size_t skeletonBytes() {
  return kHeaderBytes + 24 * humanmodel::kJointCount + (humanmodel::kJointCount + 7) / 8 * 8;
}

/// What a control packet asks for.
enum class ControlOrder : std::uint32_t {
  kReport,
  kRun,
  kPause,
  kStop,
  kAdd,
  kRemove,
  kTorquesOn,
  kTorquesOff
};
inline constexpr std::size_t kControlOrders = 8;
std::string_view orderName(ControlOrder order);  ///< as in JSON: "report", "run" ...
/// As the group of a control packet: all of them.
inline constexpr std::uint32_t kAllGroups = 0xffffffff;

struct Control {
  ControlOrder order{ControlOrder::kReport};
  std::uint32_t group{kAllGroups};  ///< of run, pause, stop, add
  std::uint32_t a{0}, b{0};         ///< objects of the pair of add and remove
};
inline constexpr std::size_t kControlBytes = kHeaderBytes + 16;

/// One packet of a client. Made once by makePacket(), then filled without allocation.
struct Packet {
  PacketType type{PacketType::kJoints};
  bool json{false};  ///< came as a line of JSON; the answer does too
  std::uint32_t sequence{0};
  std::uint32_t index{0};    ///< of the mechanism (or kAllMechanisms) or of the person
  std::uint64_t time_us{0};  ///< clock of the sender
  bool reset{false};
  std::vector<double> q;               ///< rad or m; room for all mechanisms
  std::size_t values{0};               ///< how many of `q` are meant
  humanmodel::SkeletonFrame skeleton;  ///< its t is not set
  Control control;
};
Packet makePacket(const PacketFormat& format);

/// Why a packet was dropped.
enum class PacketFault : std::uint8_t {
  kNone,
  kSize,     ///< not the size of its type, or other than its header says
  kMagic,    ///< neither the magic number nor a `{`
  kVersion,  ///< of the protocol
  kType,     ///< none that a client may send
  kIndex,    ///< no such mechanism, person, group, object or order
  kNumber,   ///< not finite, too large, or no state of a joint
  kJson      ///< no JSON as documented
};
inline constexpr std::size_t kPacketFaults = 8;
std::string_view faultName(PacketFault fault);

/// Reads one datagram. Pure: depends on nothing but its arguments; bytes may be anything. `out` holds a
/// packet only after kNone. No allocation, no throw.
PacketFault parsePacket(std::span<const std::byte> bytes, const PacketFormat& format, Packet& out) noexcept;

/// kIndex for a group or an object that the order needs and the scene has not.
PacketFault checkControl(const PacketFormat& format, const Control& control) noexcept;

/// The part of it for what begins with `{`.
PacketFault parseJsonPacket(std::string_view text, const PacketFormat& format, Packet& out) noexcept;

}  // namespace abstand::serve
