#include "app/moment/moment_packet.hpp"

#include "app/moment/moment_fields.hpp"

namespace abstand::moment {
Moment makeMoment(const SceneCard& card) {
  Moment moment;
  view::SceneSnapshot& s = moment.shown;
  s.objects.resize(card.objects.size());
  s.pairs.resize(card.pairs.size());
  s.pair_group.assign(card.pairs.size(), -1);
  s.groups.resize(card.groups.size());
  s.robots.resize(card.robots.size());
  s.joint_positions.resize(card.dof());
  s.joint_efforts.resize(card.dof());
  s.joint_torques.resize(card.dof());
  s.movers.joint_axes.resize(card.dof());
  s.movers.by_hand.resize(card.robots.size());
  s.movers.person_age.resize(card.people.size());
  moment.input_age.assign(card.robots.size(), kInfinity);
  return moment;
}

std::size_t minMomentBytes(const SceneCard& card) {
  const Moment moment = makeMoment(card);
  CountFields count;
  exchangeMoment(count, moment);
  return kFrameHeaderBytes + count.bytes();
}

std::size_t maxMomentBytes(const SceneCard& card) {
  const query::PairResult touching;
  CountFields force;
  exchangeForce(force, touching);
  return minMomentBytes(card) + force.bytes() * card.pairs.size();
}

std::size_t writeMoment(const FrameHeader& header, const Moment& moment, std::span<std::byte> into) noexcept {
  if (into.size() < kFrameHeaderBytes) return 0;
  PutFields out(into.subspan(kFrameHeaderBytes));
  exchangeMoment(out, moment);
  if (!out.good()) return 0;
  FrameHeader whole = header;
  whole.type = FrameType::kMoment;
  whole.bytes = static_cast<std::uint32_t>(kFrameHeaderBytes + out.written());
  writeHeader(whole, into);
  return whole.bytes;
}

bool readMoment(std::span<const std::byte> frame, Moment& out) noexcept {
  if (frame.size() < kFrameHeaderBytes) return false;
  const auto header = readHeader(frame);
  if (!header || header->type != FrameType::kMoment || header->bytes != frame.size()) return false;
  GetFields in(frame.subspan(kFrameHeaderBytes));
  exchangeMoment(in, out);
  for (std::size_t i = 0; i < out.shown.joint_torques.size(); ++i)
    out.shown.joint_efforts[i] = out.shown.joint_torques[i].contact;
  return in.good();
}

}  // namespace abstand::moment
