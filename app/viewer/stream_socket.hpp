// Non-blocking TCP sockets.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "app/serve/address.hpp"

namespace abstand::viewer {

/// A file descriptor that is closed by its owner. Movable.
class Descriptor {
 public:
  explicit Descriptor(int handle = -1) : handle_(handle) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  int get() const { return handle_; }
  bool open() const { return handle_ >= 0; }

 private:
  int handle_;
};

/// Throws UsageError if the address cannot be bound.
Descriptor listenAt(const serve::Address& address);
/// With the port that the system chose.
serve::Address addressOf(const Descriptor& socket);
/// The next connection that waits; not open: there is none. `send_buffer`: bytes that the system may hold for
/// a slow reader.
Descriptor acceptFrom(const Descriptor& listener, int send_buffer);
/// Begins to connect; not open: the system refuses at once. Ready for writing when it is decided.
Descriptor beginConnect(const serve::Address& address);
/// True if a connection that was begun is there.
bool isConnected(const Descriptor& socket);

/// Bytes that were read, 0 if there are none now; nothing: the other side has closed, or an error.
std::optional<std::size_t> readSome(const Descriptor& socket, std::span<std::byte> into) noexcept;
/// Bytes that were written, 0 if there is no room now; nothing: the other side has closed, or an error.
std::optional<std::size_t> writeSome(const Descriptor& socket, std::span<const std::byte> bytes) noexcept;

}  // namespace abstand::viewer
