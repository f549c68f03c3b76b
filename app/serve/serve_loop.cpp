#include "app/serve/serve_loop.hpp"

#include <algorithm>
#include <chrono>

#include "app/serve/groups_packet.hpp"
#include "core/base/error.hpp"
#include "core/base/pacer.hpp"

namespace abstand::serve {
namespace {

// s: longest wait, so that Ctrl-C and the end are noticed.
constexpr double kLongestWait = 0.05;
// s added to the time at which an input becomes stale, so that it is stale by then.
constexpr double kPast = 2e-5;
// Limit of datagrams between two checks of the end conditions.
constexpr int kMaxAtOnce = 256;

double steady() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::uint32_t clipped(long n) { return static_cast<std::uint32_t>(std::clamp(n, 0L, 0xffffffffL)); }

}  // namespace

ServeLoop::ServeLoop(ServedScene& scene, UdpSocket& socket, const ServeOptions& options)
    : scene_(scene),
      socket_(socket),
      options_(options),
      quoted_format_(quoted(scene.format())),
      quoted_names_(quoted(scene.names())),
      joints_(scene.format().mechanisms.size() + 1, PacketStream(options.stale)),
      skeletons_(scene.format().people.size(), PacketStream(options.stale)),
      owners_(scene.format().mechanisms.size(), options.stale),
      controls_(options.stale),
      packet_(makePacket(scene.format())),
      in_(kMaxPacketBytes),
      out_(kMaxPacketBytes),
      states_(scene.robots().size(), safety::StopState::kProtectiveStop),
      start_(steady()) {
  const std::size_t bytes = stateBytes(scene.report());
  if (bytes > kMaxPacketBytes)
    throw UsageError("the answer of this scene has " + std::to_string(bytes) + " bytes, expected at most " +
                     std::to_string(kMaxPacketBytes) + ", the size of a datagram");
  if (options.lines_from >= 0) lines_.emplace(options.lines_from, kMaxPacketBytes);
  scene_.cycle(now());
}

double ServeLoop::now() const { return steady() - start_; }

bool ServeLoop::goesOn() {
  summary_.seconds = now();
  if (options_.interrupted && options_.interrupted()) summary_.interrupted = true;
  return !summary_.interrupted && !(options_.duration && summary_.seconds >= *options_.duration);
}

void ServeLoop::run() {
  if (options_.rate)
    freeRun();
  else
    onRequest();
}

void ServeLoop::onRequest() {
  while (goesOn()) {
    const double t = now();
    double until = std::min(scene_.nextStale() + kPast, t + kLongestWait);
    if (options_.duration) until = std::min(until, *options_.duration);
    socket_.wait(until - t, lines_ ? lines_->handle() : -1);
    drainLines();
    drain(true);
    if (now() >= scene_.nextStale()) {
      cycle(now());
      tellChange();
    }
    showObserver();
  }
}

/// Sends an unasked answer if a stop state differs from the last one sent.
bool ServeLoop::tellChange() {
  const auto& robots = scene_.report().robots;
  for (std::size_t m = 0; m < robots.size(); ++m) {
    if (robots[m].state == states_[m]) continue;
    send(true);
    return true;
  }
  return false;
}

/// Executes and answers packet_; the sender of joints is told about a stop that it causes.
void ServeLoop::control(const Address& from, double t) {
  ++summary_.controls;
  const session::PairControl::Outcome outcome = scene_.handle(packet_.control, t);
  cycle(t);
  const ReplyTo to{packet_.sequence, packet_.index, packet_.time_us, false};
  const GroupsReport report{scene_.control(), scene_.torquesOn(), outcome, scene_.report().time_us};
  const std::size_t bytes =
      packet_.json ? writeGroupsJson(report, to, quoted_format_, out_) : writeGroups(report, to, out_);
  if (bytes == 0 || !socket_.send(std::span(out_).first(bytes), from)) ++summary_.unsent;
  if (!options_.rate) tellChange();
}

void ServeLoop::freeRun() {
  Pacer pacer{std::chrono::nanoseconds(static_cast<long>(1e9 / *options_.rate))};
  while (goesOn()) {
    drainLines();
    drain(false);
    const double begin = steady();
    cycle(now());
    send(true);
    summary_.cycles.add(steady() - begin);
    showObserver();
    pacer.wait();
  }
}

void ServeLoop::drain(bool answer) {
  Address from;
  for (int i = 0; i < kMaxAtOnce; ++i) {
    const auto bytes = socket_.receive(in_, from);
    if (!bytes) return;
    const double begin = steady();
    ++summary_.packets;
    const double t = now();
    if (!take(parse(*bytes), from, t)) continue;
    if (packet_.type == PacketType::kControl) control(from, t);
    if (packet_.type != PacketType::kJoints) continue;
    if (!answer) continue;
    cycle(t);
    send(false);
    const double took = steady() - begin;
    summary_.cycles.add(took);
    scene_.report().cycle_us = 1e6 * took;
    showObserver();
  }
}

void ServeLoop::drainLines() {
  if (!lines_) return;
  const long too_long = lines_->tooLong();
  for (int i = 0; i < kMaxAtOnce; ++i) {
    const auto line = lines_->next();
    if (!line) break;
    if (line->find_first_not_of(" \t\r") == line->npos) continue;
    ++summary_.packets;
    ++summary_.lines;
    // A sender without an address: no other sender can have its streams.
    take(parse(*line), Address{}, now());
  }
  for (long i = too_long; i < lines_->tooLong(); ++i) {
    ++summary_.packets;
    ++summary_.lines;
    take(PacketFault::kSize, Address{}, now());
  }
}

PacketFault ServeLoop::parse(std::size_t bytes) noexcept {
  if (bytes > in_.size()) return PacketFault::kSize;
  return parsePacket(std::span(in_).first(bytes), scene_.format(), packet_);
}

/// Rejects joints, as there is no address to answer to.
PacketFault ServeLoop::parse(std::string_view line) noexcept {
  const PacketFault fault = parseJsonPacket(line, scene_.format(), packet_);
  if (fault != PacketFault::kNone) return fault;
  return packet_.type == PacketType::kSkeleton ? PacketFault::kNone : PacketFault::kType;
}

/// True if packet_, parsed with that fault, was accepted and applied to the scene.
bool ServeLoop::take(PacketFault fault, const Address& from, double t) {
  if (fault != PacketFault::kNone) {
    ++summary_.faults[static_cast<std::size_t>(fault)];
    ++summary_.bad;
    return false;
  }
  if (packet_.type == PacketType::kControl) {
    const long others = summary_.streams.foreign;
    const bool mine = controls_.take(packet_.sequence, t, from, summary_.streams);
    summary_.bad += summary_.streams.foreign - others;
    return mine;
  }
  const bool is_joints = packet_.type == PacketType::kJoints;
  const std::size_t index = std::min<std::size_t>(packet_.index, joints_.size() - 1);
  PacketStream& stream = is_joints ? joints_[index] : skeletons_[packet_.index];
  if (is_joints && !owners_.mayTake(packet_.index, t, from)) {
    ++summary_.streams.foreign;
    ++summary_.bad;
    return false;
  }
  const long foreign = summary_.streams.foreign;
  const bool taken = stream.take(packet_.sequence, t, from, summary_.streams);
  summary_.bad += summary_.streams.foreign - foreign;
  if (!taken) return false;
  scene_.take(packet_, t);
  if (is_joints) {
    owners_.took(packet_.index, t, from);
    ++summary_.joints;
    last_ = {from, {packet_.sequence, packet_.index, packet_.time_us, false}, packet_.json};
  } else {
    ++summary_.skeletons;
  }
  return true;
}

void ServeLoop::cycle(double t) {
  scene_.cycle(t);
  ++cycles_;
  countInReport();
}

/// When answers have been sent, so that it delays none.
void ServeLoop::showObserver() {
  if (options_.observer) options_.observer->look(now(), cycles_, scene_);
}

void ServeLoop::countInReport() {
  StateReport& r = scene_.report();
  r.bad = clipped(summary_.bad);
  r.late = clipped(summary_.streams.late);
  r.lost = clipped(summary_.streams.lost);
  r.duplicates = clipped(summary_.streams.duplicates);
}

void ServeLoop::send(bool unasked) {
  const StateReport& r = scene_.report();
  for (std::size_t m = 0; m < states_.size(); ++m) states_[m] = r.robots[m].state;
  if (!last_.from.known()) return;
  last_.to.unasked = unasked;
  const std::size_t bytes = last_.json ? writeStateJson(r, last_.to, quoted_format_, quoted_names_, out_)
                                       : writeState(r, last_.to, out_);
  if (bytes == 0 || !socket_.send(std::span(out_).first(bytes), last_.from))
    ++summary_.unsent;
  else
    ++(unasked ? summary_.unasked : summary_.answered);
}

}  // namespace abstand::serve
