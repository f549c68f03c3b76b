#include "app/viewer/stream_socket.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/base/error.hpp"

namespace abstand::viewer {
namespace {

Descriptor makeStream(const serve::Address& address) {
  return Descriptor(::socket(address.storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

/// Frames are sent at once.
void setNoDelay(const Descriptor& socket) {
  const int on = 1;
  ::setsockopt(socket.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

std::optional<std::size_t> moved(ssize_t n) {
  if (n > 0) return static_cast<std::size_t>(n);
  if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return 0;
  return {};
}

}  // namespace

Descriptor::~Descriptor() {
  if (handle_ >= 0) ::close(handle_);
}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  if (this == &other) return *this;
  if (handle_ >= 0) ::close(handle_);
  handle_ = std::exchange(other.handle_, -1);
  return *this;
}

Descriptor listenAt(const serve::Address& address) {
  constexpr int kWaiting = 8;
  Descriptor socket = makeStream(address);
  // A server that starts again takes the port of its predecessor.
  const int on = 1;
  if (socket.open()) ::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (!socket.open() ||
      ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address.storage), address.size) != 0 ||
      ::listen(socket.get(), kWaiting) != 0)
    throw UsageError("cannot listen on " + serve::describe(address) +
                     " for viewers: " + std::generic_category().message(errno));
  return socket;
}

serve::Address addressOf(const Descriptor& socket) {
  serve::Address address;
  address.size = sizeof address.storage;
  if (::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&address.storage), &address.size) != 0)
    return {};
  return address;
}

Descriptor acceptFrom(const Descriptor& listener, int send_buffer) {
  Descriptor socket(::accept4(listener.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (!socket.open()) return socket;
  setNoDelay(socket);
  ::setsockopt(socket.get(), SOL_SOCKET, SO_SNDBUF, &send_buffer, sizeof send_buffer);
  return socket;
}

Descriptor beginConnect(const serve::Address& address) {
  Descriptor socket = makeStream(address);
  if (!socket.open()) return socket;
  setNoDelay(socket);
  const int r = ::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address.storage), address.size);
  if (r != 0 && errno != EINPROGRESS) return Descriptor();
  return socket;
}

bool isConnected(const Descriptor& socket) {
  int error = 0;
  socklen_t size = sizeof error;
  if (::getsockopt(socket.get(), SOL_SOCKET, SO_ERROR, &error, &size) != 0 || error != 0) return false;
  sockaddr_storage peer{};
  size = sizeof peer;
  return ::getpeername(socket.get(), reinterpret_cast<sockaddr*>(&peer), &size) == 0;
}

std::optional<std::size_t> readSome(const Descriptor& socket, std::span<std::byte> into) noexcept {
  return moved(::recv(socket.get(), into.data(), into.size(), 0));
}

std::optional<std::size_t> writeSome(const Descriptor& socket, std::span<const std::byte> bytes) noexcept {
  return moved(::send(socket.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL));
}

}  // namespace abstand::viewer
