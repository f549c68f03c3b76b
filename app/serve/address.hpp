// UDP addresses.
#pragma once

#include <sys/socket.h>

#include <string>

namespace abstand::serve {

/// An IPv4 or IPv6 address with its port. A value.
struct Address {
  sockaddr_storage storage{};
  socklen_t size{0};
  bool known() const { return size > 0; }
};
/// Family, address and port are equal.
bool operator==(const Address& a, const Address& b);

/// Parses "127.0.0.1:4780" or "[::1]:4780"; port 0 lets the system choose. Throws UsageError with the name
/// `option`.
Address parseAddress(const std::string& text, const std::string& option);
std::string describe(const Address& address);

}  // namespace abstand::serve
