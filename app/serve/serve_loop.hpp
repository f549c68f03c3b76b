// The live loop: packets in, a cycle, answers out.
#pragma once

#include <functional>
#include <optional>

#include "app/serve/joint_owners.hpp"
#include "app/serve/line_input.hpp"
#include "app/serve/packet_stream.hpp"
#include "app/serve/served_scene.hpp"
#include "app/serve/udp_socket.hpp"
#include "core/scene/cycle_statistics.hpp"

namespace abstand::serve {

struct ServeOptions {
  double stale{0.1};           ///< s, after which a silent stream may begin anew
  std::optional<double> rate;  ///< Hz: cycles and answers at this rate; none: one for each packet of joints
  std::optional<double> duration;  ///< s, after which it ends; none: it runs until it is interrupted
  int lines_from{-1};              ///< file descriptor of lines of JSON with skeletons; -1: none
  std::function<bool()> interrupted;
};

struct ServeSummary {
  long packets{0};  ///< datagrams and lines that came
  long lines{0};    ///< of these, lines
  long joints{0};   ///< accepted packets of joints
  long skeletons{0};
  long controls{0};  ///< accepted control packets, each with an answer of its own
  long answered{0};  ///< accepted packets of joints with an answer of their own
  long unasked{0};   ///< answers to no packet
  long unsent{0};    ///< answers that the system did not take
  std::array<long, kPacketFaults> faults{};
  long bad{0};  ///< the sum of the faults and of what came from foreign senders
  StreamCounts streams;
  scene::CycleStatistics cycles{kInfinity};  ///< of answered packets: from the datagram to the answer
  double seconds{0.0};
  bool interrupted{false};
};

/// One thread does everything: it waits for datagrams, never longer than until the next input becomes stale,
/// so that a stop comes in time where nothing comes in. Lines are one sender of skeletons more; when they
/// end, their people become stale. A change of a state of stop that no packet brought about is told to the
/// last sender of joints unasked.
///
/// After the first cycle it allocates nothing and locks nothing.
class ServeLoop {
 public:
  ServeLoop(ServedScene& scene, UdpSocket& socket, const ServeOptions& options);
  /// Until it is interrupted or the duration is over.
  void run();
  const ServeSummary& summary() const { return summary_; }

 private:
  void freeRun();
  void onRequest();
  bool goesOn();
  double now() const;
  void drain(bool answer);
  void drainLines();
  PacketFault parse(std::size_t bytes) noexcept;
  PacketFault parse(std::string_view line) noexcept;
  bool take(PacketFault fault, const Address& from, double t);
  void cycle(double t);
  void send(bool unasked);
  bool tellChange();
  void control(const Address& from, double t);
  void countInReport();

  ServedScene& scene_;
  UdpSocket& socket_;
  ServeOptions options_;
  ServeSummary summary_;
  PacketFormat quoted_format_;
  StateNames quoted_names_;
  std::vector<PacketStream> joints_;     ///< of each mechanism, the last of all together
  std::vector<PacketStream> skeletons_;  ///< of each person
  JointOwners owners_;                   ///< of the mechanisms, over both kinds of streams of joints
  PacketStream controls_;                ///< of control packets
  Packet packet_;
  std::vector<std::byte> in_, out_;
  std::optional<LineInput> lines_;
  /// The last accepted packet of joints: who is to be answered.
  struct Last {
    Address from;
    ReplyTo to;
    bool json{false};
  } last_;
  std::vector<safety::StopState> states_;  ///< as the last answer told them
  double start_;                           ///< s on the steady clock
};

}  // namespace abstand::serve
