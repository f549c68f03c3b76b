// Sends tracked people to a running `abstand serve`.
#pragma once

#include <cerrno>
#include <optional>
#include <string>
#include <vector>

#include "app/serve/skeleton_line.hpp"
#include "app/serve/udp_socket.hpp"

namespace abstand::serve {

/// Sends skeletons as JSON lines, by UDP or to standard output, each with the name of a person of the scene.
/// Names are assigned to people in order of appearance and become free one second after the person was last
/// seen. People without a free name are not sent, but counted. One thread. No allocation after the first
/// line.
class SkeletonSender {
 public:
  /// `to`: HOST:PORT, or "-" for standard output. Throws UsageError.
  SkeletonSender(const std::string& to, std::vector<std::string> names);

  /// Sends one person of an image at `t` (s, increasing); `id` is constant while in view.
  void send(int id, double t, const humanmodel::SkeletonFrame& frame) noexcept;

  /// True if the reader of standard output has closed it. (The caller ignores SIGPIPE.)
  bool isClosed() const { return output_error_ == EPIPE; }
  /// errno of the first failure of standard output; 0 if there was none.
  int outputError() const { return output_error_; }
  long sent() const { return sent_; }
  long refused() const { return refused_; }    ///< by the system
  long nameless() const { return nameless_; }  ///< for people without a free name

 private:
  struct Name {
    std::string text;
    int id{-1};
    double last{-kInfinity};  ///< s, time of the last line
    std::uint32_t sequence{0};
  };
  Name* nameOf(int id, double t) noexcept;
  bool write(std::size_t bytes) noexcept;

  std::optional<Address> to_;  ///< empty: standard output
  std::optional<UdpSocket> socket_;
  std::vector<Name> names_;
  std::array<std::byte, kMaxLineBytes> line_{};
  long sent_{0}, refused_{0}, nameless_{0};
  int output_error_{0};
};

}  // namespace abstand::serve
