// A UDP socket that never waits but where it is told to.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "app/serve/address.hpp"

namespace abstand::serve {

/// Closed when it goes. One thread. Nothing allocates or throws but the constructor.
class UdpSocket {
 public:
  /// Throws UsageError when the address cannot be had.
  explicit UdpSocket(const Address& bind);
  ~UdpSocket();
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;

  Address address() const { return address_; }  ///< with the port that the system chose
  /// Until a datagram is there, or something to be read from the file descriptor `also` (-1: none), or
  /// `seconds` have passed; false after the latter and at a signal.
  bool wait(double seconds, int also = -1) noexcept;
  /// Bytes of the next datagram, whose beginning is in `into`; nothing when none is there.
  std::optional<std::size_t> receive(std::span<std::byte> into, Address& from) noexcept;
  bool send(std::span<const std::byte> bytes, const Address& to) noexcept;  ///< false: the system refused it

 private:
  int handle_;
  Address address_;
};

}  // namespace abstand::serve
