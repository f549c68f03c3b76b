// Example client of `abstand serve` in C++20, with nothing but the system: sends joint values at a fixed rate
// and measures the round trip.
//
//   g++ -std=c++20 -O2 docs/clients/serve_client.cpp -o serve_client
//   ./serve_client PORT JOINTS PEOPLE [SECONDS [RATE]]
//
// The packets are those of docs/serve.md; `abstand serve SCENE --layout` prints them for one scene.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <unordered_map>
#include <vector>

static_assert(std::endian::native == std::endian::little, "the packets are little-endian");

namespace {

constexpr std::uint16_t kJoints = 1, kSkeleton = 2, kState = 3;
constexpr std::uint32_t kAll = 0xffffffff, kReset = 1, kUnasked = 2;
constexpr int kSkeletonJoints = 22;

struct Header {
  char magic[4] = {'A', 'B', 'S', 'T'};
  std::uint16_t version = 1, type = 0;
  std::uint32_t sequence = 0, index = 0;
  std::uint64_t time_us = 0;
  std::uint32_t flags = 0, bytes = 0;
};
static_assert(sizeof(Header) == 32);

struct SkeletonPacket {
  Header header;
  double p[kSkeletonJoints][3];
  std::uint8_t state[kSkeletonJoints];  // 0 missing, 1 inferred, 2 tracked
  std::uint8_t zero[2];
};
static_assert(sizeof(SkeletonPacket) == 584);

// A person who stands upright: pelvis, spine, thorax, neck, head, head top, left arm, right arm, left leg,
// right leg. Metres, z up.
constexpr double kStanding[kSkeletonJoints][3] = {
    {0, 0, 0.95},        {0, 0, 1.10},        {0, 0, 1.30},         {0, 0, 1.48},
    {0, 0, 1.60},        {0, 0, 1.75},        {0, 0.19, 1.42},      {0, 0.21, 1.14},
    {0.05, 0.21, 0.90},  {0.05, 0.21, 0.80},  {0, -0.19, 1.42},     {0, -0.21, 1.14},
    {0.05, -0.21, 0.90}, {0.05, -0.21, 0.80}, {0, 0.09, 0.92},      {0, 0.09, 0.50},
    {0, 0.09, 0.08},     {0.18, 0.09, 0.02},  {0, -0.09, 0.92},     {0, -0.09, 0.50},
    {0, -0.09, 0.08},    {0.18, -0.09, 0.02}};

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Header header(std::uint16_t type, std::uint32_t sequence, std::uint32_t index, std::size_t bytes) {
  Header h;
  h.type = type;
  h.sequence = sequence;
  h.index = index;
  h.time_us = static_cast<std::uint64_t>(1e6 * now());
  h.bytes = static_cast<std::uint32_t>(bytes);
  return h;
}

bool waitFor(int handle, double seconds) {
  pollfd p{handle, POLLIN, 0};
  const double s = std::max(0.0, seconds);
  const timespec limit{static_cast<time_t>(s), static_cast<long>(1e9 * (s - std::floor(s)))};
  return ppoll(&p, 1, &limit, nullptr) > 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: %s PORT JOINTS PEOPLE [SECONDS [RATE]]\n", argv[0]);
    return 2;
  }
  const int port = std::atoi(argv[1]), joints = std::atoi(argv[2]), people = std::atoi(argv[3]);
  const double seconds = argc > 4 ? std::atof(argv[4]) : 10.0, rate = argc > 5 ? std::atof(argv[5]) : 1000.0;

  sockaddr_in server{};
  server.sin_family = AF_INET;
  server.sin_port = htons(static_cast<std::uint16_t>(port));
  server.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int handle = socket(AF_INET, SOCK_DGRAM, 0);
  // Answers wait here while this program does not run; the system gives what it allows.
  const int room = 4 << 20;
  setsockopt(handle, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
  if (handle < 0 || connect(handle, reinterpret_cast<sockaddr*>(&server), sizeof server) != 0) {
    std::perror("serve_client");
    return 1;
  }

  std::unordered_map<std::uint32_t, double> waiting;  // sequence number -> when it was sent
  std::vector<double> trips;
  std::vector<char> answer(65536);
  const auto receive = [&] {
    const ssize_t n = recv(handle, answer.data(), answer.size(), 0);
    Header h;
    if (n < static_cast<ssize_t>(sizeof h)) return;
    std::memcpy(&h, answer.data(), sizeof h);
    const auto sent = waiting.find(h.sequence);
    if (h.type != kState || (h.flags & kUnasked) || sent == waiting.end()) return;
    trips.push_back(now() - sent->second);
    waiting.erase(sent);
  };

  std::vector<char> packet(sizeof(Header) + 8 * static_cast<std::size_t>(joints));
  const long skeletons = std::max(1L, std::lround(rate / 100));  // one every 10 ms
  const double begin = now();
  for (long i = 0; i < static_cast<long>(seconds * rate); ++i) {
    for (int person = 0; i % skeletons == 0 && person < people; ++person) {
      SkeletonPacket s{};
      s.header = header(kSkeleton, static_cast<std::uint32_t>(i / skeletons), static_cast<std::uint32_t>(person),
                        sizeof s);
      for (int j = 0; j < kSkeletonJoints; ++j) {
        for (int k = 0; k < 3; ++k) s.p[j][k] = kStanding[j][k] + (k == 0 ? 1.5 : 0.0);
        s.state[j] = 2;
      }
      send(handle, &s, sizeof s, 0);
    }
    Header h = header(kJoints, static_cast<std::uint32_t>(i), kAll, packet.size());
    h.flags = i == 0 ? kReset : 0;
    std::memcpy(packet.data(), &h, sizeof h);
    for (int j = 0; j < joints; ++j) {
      const double q = 0.2 * std::sin(static_cast<double>(i) / rate + j);
      std::memcpy(packet.data() + sizeof h + 8 * static_cast<std::size_t>(j), &q, sizeof q);
    }
    waiting[h.sequence] = now();
    send(handle, packet.data(), packet.size(), 0);
    while (waitFor(handle, begin + static_cast<double>(i + 1) / rate - now())) receive();
  }
  while (!waiting.empty() && waitFor(handle, 0.5)) receive();
  close(handle);

  std::sort(trips.begin(), trips.end());
  const auto share = [&](double part) {
    if (trips.empty()) return std::nan("");
    return 1e6 * trips[std::min(trips.size() - 1, static_cast<std::size_t>(part * static_cast<double>(trips.size())))];
  };
  std::printf("%zu answered, %zu unanswered; round trip: median %.0f us, p99 %.0f us, max %.0f us\n", trips.size(),
              waiting.size(), share(0.5), share(0.99), share(1.0));
  return waiting.empty() ? 0 : 1;
}
