// Order of the numbers in the binary answer, in one place for all users.
#pragma once

#include "app/serve/state_packet.hpp"

namespace abstand::serve {

/// Meaning of a number: `of` states what `index` counts.
struct FieldLabel {
  enum class Of : std::uint8_t { kPacket, kPerson, kRobot, kJoint, kLink, kSeparation, kNearest };
  Of of;
  std::size_t index;
  const char* what;
};

/// Calls visit(label, value) for every number, with the type that it has on the wire.
template <class Visit>
void eachField(const StateReport& r, const ReplyTo& to, std::uint32_t bytes, Visit visit) {
  using Of = FieldLabel::Of;
  const auto packet = [&](const char* what, auto value) { visit(FieldLabel{Of::kPacket, 0, what}, value); };
  const auto vector = [&](Of of, std::size_t i, std::array<const char*, 3> what, const Vector3d& v) {
    for (std::size_t k = 0; k < 3; ++k) visit(FieldLabel{of, i, what[k]}, v[static_cast<Eigen::Index>(k)]);
  };
  const auto pair = [&](Of of, std::size_t i, const PairReport& p) {
    visit(FieldLabel{of, i, "object a, -1: none"}, static_cast<std::int32_t>(p.a));
    visit(FieldLabel{of, i, "object b"}, static_cast<std::int32_t>(p.b));
    visit(FieldLabel{of, i, "trust: 0 none, 1 inferred, 2 fresh"}, static_cast<std::uint32_t>(p.trust));
    visit(FieldLabel{of, i, "0"}, std::uint32_t{0});
    visit(FieldLabel{of, i, "distance, m"}, p.distance);
    visit(FieldLabel{of, i, "bound, m"}, p.bound);
    vector(of, i, {"nearest point on a, x, m", "y", "z"}, p.witness_a);
    vector(of, i, {"nearest point on b, x, m", "y", "z"}, p.witness_b);
  };
  packet("magic, \"ABST\"", kPacketMagic);
  packet("version of the protocol", kProtocol);
  packet("type, 3", static_cast<std::uint16_t>(PacketType::kState));
  packet("sequence number of the packet answered", to.sequence);
  packet("its index", to.index);
  packet("its time stamp, us", to.time_us);
  std::uint32_t flags = to.unasked ? kFlagUnasked : 0;
  for (const RobotReport& m : r.robots)
    if (m.refusal != safety::ResetRefusal::kNone) flags |= kFlagRefused;
  if (!r.torques_on) flags |= kFlagTorquesOff;
  if (r.not_checked > 0) flags |= kFlagNotChecked;
  packet("flags; 2: unasked, 4: a reset was refused, 8: torques off, 16: pairs not checked", flags);
  packet("bytes of this packet", bytes);
  packet("time of the server, us", r.time_us);
  packet("last cycle, us", r.cycle_us);
  packet("bad packets", r.bad);
  packet("late packets", r.late);
  packet("lost packets", r.lost);
  packet("duplicates", r.duplicates);
  for (std::size_t i = 0; i < r.person_age.size(); ++i)
    visit(FieldLabel{Of::kPerson, i, "age, s"}, r.person_age[i]);
  for (std::size_t i = 0; i < r.robots.size(); ++i) {
    const RobotReport& m = r.robots[i];
    visit(FieldLabel{Of::kRobot, i, "speed scale, 0 to 1"}, m.speed_scale);
    visit(FieldLabel{Of::kRobot, i, "age of its joint values, s"}, m.input_age);
    visit(FieldLabel{Of::kRobot, i, "state since, s"}, m.since);
    visit(FieldLabel{Of::kRobot, i, "state"}, static_cast<std::uint32_t>(m.state));
    visit(FieldLabel{Of::kRobot, i, "reason"},
          m.has_reason ? static_cast<std::uint32_t>(m.reason) : std::uint32_t{0xffffffff});
  }
  for (std::size_t i = 0; i < r.torque.size(); ++i)
    visit(FieldLabel{Of::kJoint, i, "torque, N m or N"}, r.torque[i]);
  for (std::size_t i = 0; i < r.links.size(); ++i) {
    vector(Of::kLink, i, {"force x, N", "y", "z"}, r.links[i].force);
    vector(Of::kLink, i, {"torque x, N m", "y", "z"}, r.links[i].torque);
  }
  for (std::size_t i = 0; i < r.separation.size(); ++i) pair(Of::kSeparation, i, r.separation[i]);
  for (std::size_t i = 0; i < r.nearest.size(); ++i) pair(Of::kNearest, i, r.nearest[i]);
  for (std::size_t i = 0; i < r.offset.size(); ++i)
    visit(FieldLabel{Of::kJoint, i, "offset, rad or m"}, r.offset[i]);
}

}  // namespace abstand::serve
