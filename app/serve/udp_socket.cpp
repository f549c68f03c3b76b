#include "app/serve/udp_socket.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <ctime>
#include <system_error>

#include "core/base/error.hpp"

namespace abstand::serve {
namespace {

// Receive buffer in bytes for times when the process is not running: the usual 208 kB are full after some 160
// small packets. The system may grant less.
constexpr int kWaitingRoom = 4 << 20;

}  // namespace

UdpSocket::UdpSocket(const Address& bind)
    : handle_(::socket(bind.storage.ss_family, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
  const auto fail = [&] {
    const std::string why = std::generic_category().message(errno);
    if (handle_ >= 0) ::close(handle_);
    throw UsageError("cannot listen on " + describe(bind) + ": " + why);
  };
  if (handle_ < 0 || ::bind(handle_, reinterpret_cast<const sockaddr*>(&bind.storage), bind.size) != 0)
    fail();
  ::setsockopt(handle_, SOL_SOCKET, SO_RCVBUF, &kWaitingRoom, sizeof kWaitingRoom);
  address_.size = sizeof address_.storage;
  if (::getsockname(handle_, reinterpret_cast<sockaddr*>(&address_.storage), &address_.size) != 0) fail();
}

UdpSocket::~UdpSocket() { ::close(handle_); }

bool UdpSocket::wait(double seconds, int also) noexcept {
  // The system ignores a negative descriptor.
  std::array<pollfd, 2> p{{{handle_, POLLIN, 0}, {also, POLLIN, 0}}};
  const double s = std::clamp(seconds, 0.0, 1.0);
  const timespec limit{static_cast<time_t>(s), static_cast<long>(1e9 * (s - std::floor(s)))};
  return ::ppoll(p.data(), p.size(), &limit, nullptr) > 0;
}

std::optional<std::size_t> UdpSocket::receive(std::span<std::byte> into, Address& from) noexcept {
  from.size = sizeof from.storage;
  // Truncation is detected by a size larger than the buffer.
  const ssize_t n = ::recvfrom(handle_, into.data(), into.size(), MSG_TRUNC,
                               reinterpret_cast<sockaddr*>(&from.storage), &from.size);
  if (n < 0) return std::nullopt;
  return static_cast<std::size_t>(n);
}

bool UdpSocket::send(std::span<const std::byte> bytes, const Address& to) noexcept {
  return ::sendto(handle_, bytes.data(), bytes.size(), MSG_NOSIGNAL,
                  reinterpret_cast<const sockaddr*>(&to.storage),
                  to.size) == static_cast<ssize_t>(bytes.size());
}

}  // namespace abstand::serve
