// Sends what a served scene shows to viewers, over TCP.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <thread>

#include "app/moment/moment_packet.hpp"
#include "app/serve/address.hpp"
#include "app/serve/cycle_observer.hpp"
#include "app/serve/served_scene.hpp"
#include "core/base/triple_buffer.hpp"

namespace abstand::viewer {

struct HostOptions {
  static constexpr std::size_t kMaxViewers = 64;
  std::size_t viewers{4};  ///< at most kMaxViewers
  double renew{5.0};       ///< s without a watch frame after which a viewer is dropped
};

struct HostCounts {
  long accepted{0};  ///< viewers that began to watch
  long refused{0};   ///< connections beyond the limit
  long expired{0};   ///< viewers that did not renew in time
  long bad{0};       ///< connections dropped because of damaged frames
  long sent{0};      ///< moments, of all viewers
  long left_out{0};  ///< moments that a viewer was too slow for
};

/// Listens on a thread of its own, of ordinary priority. The loop's thread only copies a snapshot, at most
/// 100 times a second, and only while somebody watches; it never waits for a viewer. Every viewer gets whole
/// frames in order; while one is still being sent, newer moments are left out for this viewer.
class ViewerHost final : public serve::CycleObserver {
 public:
  static constexpr double kMaxRate = 100.0;  ///< Hz

  /// Throws UsageError if the address cannot be bound, or if the moments of the scene are too large. `card`:
  /// of `scene`.
  ViewerHost(const serve::Address& bind, moment::SceneCard card, serve::ServedScene& scene,
             const HostOptions& options = {});
  ~ViewerHost() override;

  void look(double now, std::uint64_t cycles, serve::ServedScene& scene) noexcept override;
  serve::Address address() const;
  /// Ends the thread; all viewers are disconnected.
  void stop();
  /// After stop().
  const HostCounts& counts() const;

 private:
  class Worker;
  struct Offer {
    moment::Moment moment;
    std::uint32_t sequence{0};
  };
  /// Shared by both threads.
  struct Shared {
    explicit Shared(const Offer& sized) : offers(sized) {}
    TripleBuffer<Offer> offers;
    std::atomic<double> rate{0.0};  ///< Hz, largest that a viewer wants; 0: nobody watches
    std::atomic<bool> news{false};  ///< a viewer has come: it needs a moment, even an old one
    std::atomic<double> now{0.0};   ///< s, latest round of the loop
    std::atomic<bool> stop{false};
  };

  std::unique_ptr<Shared> shared_;
  std::unique_ptr<Worker> worker_;
  int wake_{-1};  ///< event that wakes the worker
  // Loop's thread only.
  double due_{0.0};         ///< s, of the next offer
  std::uint64_t shown_{0};  ///< cycle of the last offer
  std::uint32_t sequence_{0};
  std::jthread thread_;  // last member: joined before the others are destroyed
};

/// Of a served scene; reads the scene file for its fingerprint. Throws ParseError.
moment::SceneCard cardOf(const serve::ServedScene& scene);

}  // namespace abstand::viewer
