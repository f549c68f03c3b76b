// Follows a running `abstand serve`.
#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include "app/serve/address.hpp"
#include "app/viewer/live_record.hpp"

namespace abstand::viewer {

struct LinkOptions {
  double rate{60.0};    ///< Hz, of moments
  double silence{2.0};  ///< s without a frame after which it connects again
  double retry{0.5};    ///< s between two attempts
};

/// s on the clock of all links and records.
double steadySeconds();

/// Connects on a thread of its own, and again whenever the connection ends, and puts what comes into a
/// LiveRecord. Does not follow a server that serves another scene than the first.
class ViewerLink {
 public:
  ViewerLink(const serve::Address& server, std::shared_ptr<LiveRecord> record,
             const LinkOptions& options = {});
  ~ViewerLink();

 private:
  struct Stream;
  void run();
  void connect();
  void follow(Stream& stream);
  bool take(Stream& stream);
  bool wait(int handle, short events, double seconds) const;

  serve::Address server_;
  std::shared_ptr<LiveRecord> record_;
  LinkOptions options_;
  std::atomic<bool> stop_{false};
  std::jthread thread_;  // last member: joined before the others are destroyed
};

}  // namespace abstand::viewer
