#include "app/serve/address.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <charconv>
#include <cstring>

#include "core/base/error.hpp"

namespace abstand::serve {
namespace {

sockaddr_in v4(const Address& a) {
  sockaddr_in in{};
  std::memcpy(&in, &a.storage, sizeof in);
  return in;
}

sockaddr_in6 v6(const Address& a) {
  sockaddr_in6 in{};
  std::memcpy(&in, &a.storage, sizeof in);
  return in;
}

template <class Sockaddr>
Address from(const Sockaddr& in) {
  Address a;
  std::memcpy(&a.storage, &in, sizeof in);
  a.size = sizeof in;
  return a;
}

}  // namespace

bool operator==(const Address& a, const Address& b) {
  if (a.size != b.size || a.storage.ss_family != b.storage.ss_family) return false;
  if (!a.known()) return true;
  if (a.storage.ss_family == AF_INET)
    return v4(a).sin_port == v4(b).sin_port && v4(a).sin_addr.s_addr == v4(b).sin_addr.s_addr;
  return v6(a).sin6_port == v6(b).sin6_port &&
         std::memcmp(v6(a).sin6_addr.s6_addr, v6(b).sin6_addr.s6_addr, sizeof(in6_addr)) == 0;
}

Address parseAddress(const std::string& text, const std::string& option) {
  const auto wrong = [&] {
    return UsageError(option + ": found '" + text +
                      "', expected an address and a port, as 127.0.0.1:4780 or [::1]:4780");
  };
  const std::size_t colon = text.rfind(':');
  if (colon == text.npos) throw wrong();
  std::uint16_t port = 0;
  const char* const end = text.data() + text.size();
  const auto r = std::from_chars(text.data() + colon + 1, end, port);
  if (r.ec != std::errc() || r.ptr != end) throw wrong();
  std::string host = text.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') {
    sockaddr_in6 in{};
    in.sin6_family = AF_INET6;
    in.sin6_port = htons(port);
    if (::inet_pton(AF_INET6, host.substr(1, host.size() - 2).c_str(), &in.sin6_addr) != 1) throw wrong();
    return from(in);
  }
  sockaddr_in in{};
  in.sin_family = AF_INET;
  in.sin_port = htons(port);
  if (::inet_pton(AF_INET, host.c_str(), &in.sin_addr) != 1) throw wrong();
  return from(in);
}

std::string describe(const Address& address) {
  char buffer[INET6_ADDRSTRLEN] = "";
  if (address.storage.ss_family == AF_INET) {
    const sockaddr_in in = v4(address);
    ::inet_ntop(AF_INET, &in.sin_addr, buffer, sizeof buffer);
    return std::string(buffer) + ":" + std::to_string(ntohs(in.sin_port));
  }
  const sockaddr_in6 in = v6(address);
  ::inet_ntop(AF_INET6, &in.sin6_addr, buffer, sizeof buffer);
  return "[" + std::string(buffer) + "]:" + std::to_string(ntohs(in.sin6_port));
}

}  // namespace abstand::serve
