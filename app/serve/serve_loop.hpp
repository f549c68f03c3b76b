// Server loop: receives packets, runs cycles, sends answers.
#pragma once

#include <functional>
#include <optional>

#include "app/serve/cycle_observer.hpp"
#include "app/serve/joint_owners.hpp"
#include "app/serve/line_input.hpp"
#include "app/serve/packet_stream.hpp"
#include "app/serve/served_scene.hpp"
#include "app/serve/udp_socket.hpp"
#include "core/scene/cycle_statistics.hpp"

namespace abstand::serve {

struct ServeOptions {
  double stale{0.1};               ///< s, after which a silent stream may be restarted
  std::optional<double> rate;      ///< Hz: rate of cycles and answers; nullopt: one for each packet of joints
  std::optional<double> duration;  ///< s, run time; nullopt: until interrupted
  int lines_from{-1};              ///< file descriptor with JSON lines of skeletons; -1: none
  std::function<bool()> interrupted;
  CycleObserver* observer{nullptr};  ///< null: none; outlives the loop
};

struct ServeSummary {
  long packets{0};  ///< datagrams and lines received
  long lines{0};    ///< lines among them
  long joints{0};   ///< accepted packets of joints
  long skeletons{0};
  long controls{0};  ///< accepted control packets, each answered
  long answered{0};  ///< accepted packets of joints that were answered
  long unasked{0};   ///< answers not caused by a packet
  long unsent{0};    ///< answers that the system refused
  std::array<long, kPacketFaults> faults{};
  long bad{0};  ///< sum of the faults and of packets from foreign senders
  StreamCounts streams;
  scene::CycleStatistics cycles{kInfinity};  ///< for answered packets: from the datagram to the answer
  double seconds{0.0};
  bool interrupted{false};
};

/// Single-threaded: waits for datagrams, at most until the next input becomes stale, so that a stop comes in
/// time without input. Lines are one additional sender of skeletons; when they end, their people become
/// stale. A change of a stop state not caused by a packet is sent to the last sender of joints unasked.
///
/// After the first cycle it allocates nothing and locks nothing.
class ServeLoop {
 public:
  ServeLoop(ServedScene& scene, UdpSocket& socket, const ServeOptions& options);
  /// Runs until interrupted or until the duration is over.
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
  void showObserver();

  ServedScene& scene_;
  UdpSocket& socket_;
  ServeOptions options_;
  ServeSummary summary_;
  PacketFormat quoted_format_;
  StateNames quoted_names_;
  std::vector<PacketStream> joints_;     ///< of each mechanism; the last one for all together
  std::vector<PacketStream> skeletons_;  ///< of each person
  JointOwners owners_;                   ///< for both kinds of joint streams
  PacketStream controls_;                ///< of control packets
  Packet packet_;
  std::vector<std::byte> in_, out_;
  std::optional<LineInput> lines_;
  /// Last accepted packet of joints: address to answer to.
  struct Last {
    Address from;
    ReplyTo to;
    bool json{false};
  } last_;
  std::vector<safety::StopState> states_;  ///< as last sent
  std::uint64_t cycles_{0};
  double start_;  ///< s on the steady clock
};

}  // namespace abstand::serve
