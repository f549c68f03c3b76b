// Joint values of robots that stand still, for a server.
#pragma once

#include <QObject>
#include <QTimer>
#include <vector>

#include "app/serve/udp_socket.hpp"

namespace abstand::studio {

/// Sends the same joint values again and again, as long as it lives. GUI thread only.
class StillRobots : public QObject {
  Q_OBJECT

 public:
  /// `joints`: rad or m, of all mechanisms of the scene, not empty. Throws UsageError.
  StillRobots(const QString& server, std::vector<double> joints);

  /// Asks the server once to let every robot that waits for a reset go on; it refuses while a cause lasts.
  void resetStops();

 private:
  void send(std::uint32_t flags);

  serve::Address server_;
  std::vector<double> joints_;
  serve::UdpSocket socket_;
  std::vector<std::byte> packet_, answer_;
  std::uint32_t sequence_{0};
  QTimer timer_;
};

}  // namespace abstand::studio
