// Tracked people on their way to a running `abstand serve`.
#pragma once

#include <cerrno>
#include <optional>
#include <string>
#include <vector>

#include "app/serve/skeleton_line.hpp"
#include "app/serve/udp_socket.hpp"

namespace abstand::serve {

/// Sends skeletons as lines of JSON, by UDP or to standard output, each under the name of a person of the
/// scene. Names are given to people in the order in which they come; who is gone for a second gives the name
/// back. People beyond the names are not sent, and counted. One thread. After the first line nothing
/// allocates.
class SkeletonSender {
 public:
  /// `to`: HOST:PORT, or "-" for standard output. Throws UsageError.
  SkeletonSender(const std::string& to, std::vector<std::string> names);

  /// One person of an image at `t` (s, rises), whose number stays the same while in view.
  void send(int id, double t, const humanmodel::SkeletonFrame& frame) noexcept;

  /// Whether nobody reads standard output any more. (The caller ignores SIGPIPE.)
  bool isClosed() const { return output_error_ == EPIPE; }
  /// errno of the first failure of standard output, 0: none.
  int outputError() const { return output_error_; }
  long sent() const { return sent_; }
  long refused() const { return refused_; }    ///< by the system
  long nameless() const { return nameless_; }  ///< of people for whom there was no name

 private:
  struct Name {
    std::string text;
    int id{-1};
    double last{-kInfinity};  ///< s, when it was sent
    std::uint32_t sequence{0};
  };
  Name* nameOf(int id, double t) noexcept;
  bool write(std::size_t bytes) noexcept;

  std::optional<Address> to_;  ///< none: standard output
  std::optional<UdpSocket> socket_;
  std::vector<Name> names_;
  std::array<std::byte, kMaxLineBytes> line_{};
  long sent_{0}, refused_{0}, nameless_{0};
  int output_error_{0};
};

}  // namespace abstand::serve
