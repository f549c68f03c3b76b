// Packets that clients send to `abstand serve`, and their errors. See docs/serve.md.
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
/// Largest payload of a datagram over IPv4.
inline constexpr std::size_t kMaxPacketBytes = 65507;
/// Index of a packet with the joints of all mechanisms, concatenated.
inline constexpr std::uint32_t kAllMechanisms = 0xffffffff;
/// rad or m. Joint values and coordinates beyond this are rejected, as Scene rejects such poses.
inline constexpr double kMaxCoordinate = 1e6;
inline bool isUsableCoordinate(double v) { return std::abs(v) <= kMaxCoordinate; }

enum class PacketType : std::uint16_t { kJoints = 1, kSkeleton = 2, kState = 3, kControl = 4, kGroups = 5 };

/// Bits of the header's flags.
inline constexpr std::uint32_t kFlagReset = 1;        ///< joints: the user releases a stopped robot
inline constexpr std::uint32_t kFlagUnasked = 2;      ///< state: not an answer to a packet
inline constexpr std::uint32_t kFlagRefused = 4;      ///< state: a reset was refused in this cycle
inline constexpr std::uint32_t kFlagTorquesOff = 8;   ///< state: torques are off
inline constexpr std::uint32_t kFlagNotChecked = 16;  ///< state: some pairs are not checked, hence stale

/// Scene-dependent parts of the format; constant while a scene is served.
struct PacketFormat {
  struct Mechanism {
    std::string name;
    std::size_t dof{0};
  };
  std::vector<Mechanism> mechanisms;
  std::vector<std::string> people;
  std::vector<std::string> groups{}, objects{};  ///< names that a control packet may use

  std::size_t dof() const;                         ///< total of all mechanisms
  std::size_t dof(std::uint32_t mechanism) const;  ///< of one, or of kAllMechanisms
  bool hasMechanism(std::uint32_t index) const;
};

/// Size of a packet with `dof` joint values, and of one with a skeleton.
constexpr std::size_t jointsBytes(std::size_t dof) { return kHeaderBytes + 8 * dof; }
constexpr std::size_t skeletonBytes() {
  return kHeaderBytes + 24 * humanmodel::kJointCount + (humanmodel::kJointCount + 7) / 8 * 8;
}

/// Command of a control packet.
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
std::string_view orderName(ControlOrder order);  ///< name in JSON: "report", "run" ...
/// Group of a control packet for all groups.
inline constexpr std::uint32_t kAllGroups = 0xffffffff;

struct Control {
  ControlOrder order{ControlOrder::kReport};
  std::uint32_t group{kAllGroups};  ///< for run, pause, stop, add
  std::uint32_t a{0}, b{0};         ///< objects of the pair for add and remove
};
inline constexpr std::size_t kControlBytes = kHeaderBytes + 16;

/// One packet of a client. Created by makePacket(), then filled without allocation.
struct Packet {
  PacketType type{PacketType::kJoints};
  bool json{false};  ///< it was a line of JSON; so is the answer
  std::uint32_t sequence{0};
  std::uint32_t index{0};    ///< mechanism (or kAllMechanisms) or person
  std::uint64_t time_us{0};  ///< sender's clock
  bool reset{false};
  std::vector<double> q;               ///< rad or m; capacity for all mechanisms
  std::size_t values{0};               ///< number of valid entries in `q`
  humanmodel::SkeletonFrame skeleton;  ///< its t is not set
  Control control;
};
Packet makePacket(const PacketFormat& format);

/// Reason why a packet was dropped.
enum class PacketFault : std::uint8_t {
  kNone,
  kSize,     ///< wrong size for its type, or different from its header
  kMagic,    ///< neither the magic number nor a `{`
  kVersion,  ///< wrong protocol version
  kType,     ///< not a type that clients may send
  kIndex,    ///< unknown mechanism, person, group, object or command
  kNumber,   ///< not finite, too large, or not a joint state
  kJson      ///< not JSON as documented
};
inline constexpr std::size_t kPacketFaults = 8;
std::string_view faultName(PacketFault fault);

/// Parses one untrusted datagram. Pure function of its arguments. `out` is valid only after kNone. No
/// allocation, no throw.
PacketFault parsePacket(std::span<const std::byte> bytes, const PacketFormat& format, Packet& out) noexcept;

/// kIndex for an unknown group or object that the command needs.
PacketFault checkControl(const PacketFormat& format, const Control& control) noexcept;

/// For texts that begin with `{`.
PacketFault parseJsonPacket(std::string_view text, const PacketFormat& format, Packet& out) noexcept;

}  // namespace abstand::serve
