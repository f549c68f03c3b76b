#include "app/viewer/viewer_link.hpp"

#include <poll.h>

#include <algorithm>
#include <chrono>

#include "app/viewer/stream_socket.hpp"
#include "app/viewer/watch_frame.hpp"

namespace abstand::viewer {
namespace {

constexpr double kLongestPause = 0.05;  // s, so that the end is noticed
constexpr double kConnectWithin = 3.0;  // s
constexpr double kRenewEvery = 1.0;     // s; the server waits for 5
constexpr std::size_t kChunk = std::size_t{256} << 10;

}  // namespace

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct ViewerLink::Stream {
  Descriptor socket;
  moment::FrameSplitter frames{};
  moment::Moment moment{};  ///< with the sizes of the scene once it is known
  bool begun{false};
  bool damaged{false};
  LinkState ended{LinkState::kConnecting};
};

ViewerLink::ViewerLink(const serve::Address& server, std::shared_ptr<LiveRecord> record,
                       const LinkOptions& options)
    : server_(server), record_(std::move(record)), options_(options), thread_([this] { run(); }) {}

ViewerLink::~ViewerLink() { stop_ = true; }

/// False if nothing happened, or if it shall end.
bool ViewerLink::wait(int handle, short events, double seconds) const {
  const double until = steadySeconds() + seconds;
  for (double left = seconds; left > 0.0 && !stop_; left = until - steadySeconds()) {
    pollfd p{handle, events, 0};
    if (::poll(&p, 1, static_cast<int>(1e3 * std::min(left, kLongestPause)) + 1) > 0) return !stop_;
  }
  return false;
}

void ViewerLink::run() {
  while (!stop_) {
    connect();
    wait(-1, 0, options_.retry);
  }
}

void ViewerLink::connect() {
  Stream stream{beginConnect(server_)};
  if (!stream.socket.open() || !wait(stream.socket.get(), POLLOUT, kConnectWithin) ||
      !isConnected(stream.socket))
    return;
  follow(stream);
  record_->end(stream.ended, stream.damaged);
}

void ViewerLink::follow(Stream& stream) {
  const auto watch = watchFrame(options_.rate);
  double heard = steadySeconds(), renew = 0.0;
  std::vector<std::byte> bytes(kChunk);
  while (!stop_) {
    const double now = steadySeconds();
    if (now - heard > options_.silence) return;
    if (now >= renew) {
      // So small a frame always fits as a whole while the server reads.
      const auto written = writeSome(stream.socket, watch);
      if (!written || *written != watch.size()) return;
      renew = now + kRenewEvery;
    }
    if (!wait(stream.socket.get(), POLLIN, kLongestPause)) continue;
    const auto count = readSome(stream.socket, bytes);
    if (!count) return;
    if (*count > 0) heard = now;
    stream.frames.add(std::span(bytes).first(*count));
    if (!take(stream)) return;
  }
}

/// False: the connection shall end.
bool ViewerLink::take(Stream& stream) {
  const auto damage = [&] {
    stream.damaged = true;
    return false;
  };
  while (const auto frame = stream.frames.next()) {
    const double now = steadySeconds();
    const moment::FrameType type = moment::readHeader(*frame)->type;
    if (type == moment::FrameType::kScene && !stream.begun) {
      const auto card = moment::readSceneCard(*frame);
      if (!card) return damage();
      if (!record_->begin(*card, LinkState::kConnected, now)) {
        stream.ended = LinkState::kOtherScene;
        return false;
      }
      stream.moment = moment::makeMoment(*card);
      stream.frames.setMaxBytes(moment::maxMomentBytes(*card));
      stream.begun = true;
    } else if (type == moment::FrameType::kMoment && stream.begun) {
      if (!moment::readMoment(*frame, stream.moment)) return damage();
      record_->add(*frame, stream.moment, now);
    } else if (type == moment::FrameType::kAlive && stream.begun &&
               frame->size() == moment::kFrameHeaderBytes) {
      record_->alive(now);
    } else {
      return damage();
    }
  }
  return !stream.frames.damaged() || damage();
}

}  // namespace abstand::viewer
