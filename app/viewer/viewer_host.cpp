#include "app/viewer/viewer_host.hpp"

#include <sched.h>
#include <sys/eventfd.h>

#include <algorithm>
#include <chrono>

#include "app/viewer/viewer_worker.hpp"
#include "core/base/background_thread.hpp"
#include "core/base/error.hpp"

namespace abstand::viewer {
namespace {

/// A loop of real-time priority does not share it with viewers.
void takeOrdinaryPriority() {
  sched_param none{};
  ::sched_setscheduler(0, SCHED_OTHER, &none);
  beBackgroundThread("viewers");
}

}  // namespace

moment::SceneCard cardOf(const serve::ServedScene& scene) {
  const session::Session& session = scene.session();
  const std::filesystem::path file = std::filesystem::absolute(session.description().file);
  moment::SceneCard card;
  card.server = static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
  card.scene = moment::sceneKey(file.string());
  card.file = file.string();
  card.objects = scene.format().objects;
  card.people = scene.format().people;
  card.groups = scene.format().groups;
  for (const auto& m : scene.format().mechanisms)
    card.robots.push_back({m.name, static_cast<std::uint32_t>(m.dof)});
  for (const scene::Pair& pair : session.scene().pairs())
    card.pairs.emplace_back(pair.a.index(), pair.b.index());
  return card;
}

ViewerHost::ViewerHost(const serve::Address& bind, moment::SceneCard card, serve::ServedScene& scene,
                       const HostOptions& options) {
  const std::size_t bytes = moment::maxMomentBytes(card);
  if (bytes > moment::kMaxFrameBytes)
    throw UsageError("found moments of up to " + std::to_string(bytes) + " bytes, expected at most " +
                     std::to_string(moment::kMaxFrameBytes));
  Offer sized{moment::makeMoment(card)};
  scene.capture(sized.moment.shown);
  // Every buffer is captured as a whole the first time.
  sized.moment.shown.captured = -1;
  shared_ = std::make_unique<Shared>(sized);
  worker_ = std::make_unique<Worker>(listenAt(bind), card, *shared_, options);
  wake_ = ::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
  if (wake_ < 0) throw UsageError("cannot make an event for viewers");
  thread_ = std::jthread([this] {
    takeOrdinaryPriority();
    worker_->run(wake_);
  });
}

ViewerHost::~ViewerHost() {
  stop();
  if (wake_ >= 0) ::close(wake_);
}

void ViewerHost::stop() {
  shared_->stop = true;
  if (thread_.joinable()) thread_.join();
}

const HostCounts& ViewerHost::counts() const { return worker_->counts(); }
serve::Address ViewerHost::address() const { return addressOf(worker_->listener()); }

void ViewerHost::look(double now, std::uint64_t cycles, serve::ServedScene& scene) noexcept {
  shared_->now.store(now, std::memory_order_relaxed);
  const double rate = shared_->rate.load(std::memory_order_relaxed);
  if (rate <= 0.0 || now < due_) return;
  const bool news = shared_->news.exchange(false, std::memory_order_relaxed);
  if (cycles == shown_ && !news) return;
  shown_ = cycles;
  due_ = std::max(due_ + 1.0 / rate, now);
  Offer& offer = shared_->offers.back();
  scene.capture(offer.moment.shown);
  const serve::StateReport& report = scene.report();
  for (std::size_t m = 0; m < report.robots.size(); ++m)
    offer.moment.input_age[m] = report.robots[m].input_age;
  offer.moment.counts = {report.bad, report.late, report.lost, report.duplicates};
  offer.sequence = ++sequence_;
  shared_->offers.publish();
  const std::uint64_t one = 1;
  // Fails only if the worker has not been woken for 2^64 times.
  static_cast<void>(::write(wake_, &one, sizeof one) == sizeof one);
}

}  // namespace abstand::viewer
