#include "app/viewer/viewer_worker.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>

#include "app/viewer/viewer_link.hpp"
#include "app/viewer/watch_frame.hpp"

namespace abstand::viewer {
namespace {

constexpr int kRoundMs = 50;         // ms, longest wait
constexpr double kAliveAfter = 0.1;  // s without a moment
// Frames that the system holds for a slow viewer: what it sees is at most so much late.
constexpr std::size_t kHeldFrames = 4;
// Part of a period by which a moment may come early, so that the rates of loop and viewer do not beat.
constexpr double kEarly = 0.2;

}  // namespace

ViewerHost::Worker::Worker(Descriptor listener, const moment::SceneCard& card, Shared& shared,
                           const HostOptions& options)
    : listener_(std::move(listener)),
      card_(moment::writeSceneCard(card)),
      shared_(shared),
      options_(options),
      frame_bytes_(std::max(moment::maxMomentBytes(card), card_.size())) {
  viewers_.reserve(options_.viewers);
}

void ViewerHost::Worker::run(int wake) {
  std::vector<pollfd> waits;
  while (!shared_.stop) {
    waits.assign({{wake, POLLIN, 0}, {listener_.get(), POLLIN, 0}});
    for (const Viewer& v : viewers_)
      waits.push_back({v.socket.get(), static_cast<short>(v.end > v.begin ? POLLIN | POLLOUT : POLLIN), 0});
    ::poll(waits.data(), waits.size(), kRoundMs);
    std::uint64_t events = 0;
    if (::read(wake, &events, sizeof events) < 0) events = 0;
    const double now = steadySeconds();
    const bool fresh = shared_.offers.fresh();
    if (fresh) {
      shared_.offers.latest();
      has_offer_ = true;
    }
    if (waits[1].revents != 0) accept(now);
    std::erase_if(viewers_, [&](Viewer& v) { return !tend(v, now, fresh); });
    publishRate();
  }
}

void ViewerHost::Worker::accept(double now) {
  const auto buffer = static_cast<int>(std::min(kHeldFrames * frame_bytes_, moment::kMaxFrameBytes));
  for (Descriptor socket = acceptFrom(listener_, buffer); socket.open();
       socket = acceptFrom(listener_, buffer)) {
    if (viewers_.size() >= options_.viewers) {
      ++counts_.refused;
      continue;
    }
    Viewer viewer;
    viewer.socket = std::move(socket);
    viewer.renewed = viewer.heard = now;
    viewer.output.resize(frame_bytes_);
    viewers_.push_back(std::move(viewer));
  }
}

/// False: the viewer is gone, or what it sent is damaged.
bool ViewerHost::Worker::read(Viewer& viewer, double now) {
  std::array<std::byte, kInputBytes> bytes;
  const auto count = readSome(viewer.socket, bytes);
  if (!count) return false;
  viewer.input.add(std::span(bytes).first(*count));
  while (const auto frame = viewer.input.next()) {
    const auto rate = watchedRate(*frame);
    if (!rate) {
      ++counts_.bad;
      return false;
    }
    viewer.renewed = now;
    if (viewer.rate == 0.0) {
      ++counts_.accepted;
      std::copy(card_.begin(), card_.end(), viewer.output.begin());
      viewer.begin = 0;
      viewer.end = card_.size();
      viewer.needs_moment = true;
      shared_.news = true;
    }
    viewer.rate = std::min(*rate, kMaxRate);
  }
  if (viewer.input.damaged()) ++counts_.bad;
  return !viewer.input.damaged();
}

bool ViewerHost::Worker::flush(Viewer& viewer) noexcept {
  while (viewer.end > viewer.begin) {
    const auto rest =
        std::span<const std::byte>(viewer.output).subspan(viewer.begin, viewer.end - viewer.begin);
    const auto count = writeSome(viewer.socket, rest);
    if (!count) return false;
    if (*count == 0) return true;
    viewer.begin += *count;
  }
  return true;
}

/// Puts the next frame into an empty output.
void ViewerHost::Worker::offer(Viewer& viewer, double now, bool fresh) {
  const bool busy = viewer.end > viewer.begin;
  const bool wants = viewer.needs_moment ? has_offer_ : fresh;
  const double period = 1.0 / viewer.rate;
  if (wants && now >= viewer.due - kEarly * period) {
    if (busy) {
      ++viewer.left_out;
      ++counts_.left_out;
      viewer.needs_moment = true;
      return;
    }
    const Offer& offer = shared_.offers.latest();
    const moment::FrameHeader header{moment::FrameType::kMoment, offer.sequence, viewer.left_out,
                                     static_cast<std::uint64_t>(1e6 * shared_.now)};
    viewer.begin = 0;
    viewer.end = moment::writeMoment(header, offer.moment, viewer.output);
    viewer.due = std::max(viewer.due + period, now);
    viewer.heard = now;
    viewer.needs_moment = false;
    ++counts_.sent;
    return;
  }
  viewer.needs_moment |= fresh;
  // A loop that hangs is not alive.
  const double loop = shared_.now;
  if (busy || now - viewer.heard < kAliveAfter || loop == viewer.loop) return;
  moment::writeHeader({moment::FrameType::kAlive, 0, viewer.left_out, static_cast<std::uint64_t>(1e6 * loop),
                       moment::kFrameHeaderBytes},
                      viewer.output);
  viewer.begin = 0;
  viewer.end = moment::kFrameHeaderBytes;
  viewer.loop = loop;
  viewer.heard = now;
}

/// False: the viewer shall go.
bool ViewerHost::Worker::tend(Viewer& viewer, double now, bool fresh) {
  if (!read(viewer, now)) return false;
  if (now - viewer.renewed > options_.renew) {
    ++counts_.expired;
    return false;
  }
  if (viewer.rate == 0.0) return true;
  if (!flush(viewer)) return false;
  offer(viewer, now, fresh);
  return flush(viewer);
}

void ViewerHost::Worker::publishRate() {
  double rate = 0.0;
  for (const Viewer& v : viewers_) rate = std::max(rate, v.rate);
  shared_.rate = rate;
}

}  // namespace abstand::viewer
