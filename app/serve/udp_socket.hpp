// Non-blocking UDP socket.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "app/serve/address.hpp"

namespace abstand::serve {

/// Closed by the destructor. One thread. Only the constructor allocates or throws.
class UdpSocket {
 public:
  /// Throws UsageError if the address cannot be bound.
  explicit UdpSocket(const Address& bind);
  ~UdpSocket();
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;

  Address address() const { return address_; }  ///< with the port that the system chose
  /// Waits until a datagram or input on the file descriptor `also` (-1: none) is available, or `seconds` have
  /// passed; false in the latter case and on a signal.
  bool wait(double seconds, int also = -1) noexcept;
  /// Size of the next datagram, whose beginning is copied to `into`; nullopt if there is none.
  std::optional<std::size_t> receive(std::span<std::byte> into, Address& from) noexcept;
  bool send(std::span<const std::byte> bytes, const Address& to) noexcept;  ///< false: the system refused it

 private:
  int handle_;
  Address address_;
};

}  // namespace abstand::serve
