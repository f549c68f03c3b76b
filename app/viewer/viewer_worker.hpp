// The thread of a ViewerHost: accepts viewers, and sends frames.
#pragma once

#include <vector>

#include "app/viewer/stream_socket.hpp"
#include "app/viewer/viewer_host.hpp"

namespace abstand::viewer {

class ViewerHost::Worker {
 public:
  Worker(Descriptor listener, const moment::SceneCard& card, Shared& shared, const HostOptions& options);

  void run(int wake);
  const HostCounts& counts() const { return counts_; }
  const Descriptor& listener() const { return listener_; }

 private:
  struct Viewer {
    Descriptor socket;
    moment::FrameSplitter input{kInputBytes};
    double rate{0.0};     ///< Hz; 0: has not asked yet
    double renewed{0.0};  ///< s, steady clock
    double due{0.0};      ///< s, of the next moment
    double heard{0.0};    ///< s, when the last frame was queued
    double loop{0.0};     ///< s, of the loop, in the last alive frame
    std::uint32_t left_out{0};
    std::vector<std::byte> output;  ///< the frame that is being sent
    std::size_t begin{0}, end{0};   ///< of what is left of it
    bool needs_moment{false};
  };
  static constexpr std::size_t kInputBytes = 4096;

  void accept(double now);
  bool read(Viewer& viewer, double now);
  bool flush(Viewer& viewer) noexcept;
  void offer(Viewer& viewer, double now, bool fresh);
  bool tend(Viewer& viewer, double now, bool fresh);
  void publishRate();

  Descriptor listener_;
  std::vector<std::byte> card_;
  Shared& shared_;
  HostOptions options_;
  HostCounts counts_;
  std::size_t frame_bytes_;
  std::vector<Viewer> viewers_;
  bool has_offer_{false};
};

}  // namespace abstand::viewer
