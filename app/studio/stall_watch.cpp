#include "app/studio/stall_watch.hpp"

#include "app/studio/process_usage.hpp"

namespace abstand::studio {
namespace {

constexpr int kTickMs = 2;
constexpr double kShortest = 0.02;  // s

}  // namespace

StallWatch::StallWatch(QObject* parent) : QObject(parent) {
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(kTickMs);
  connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
  restart();
  timer_.start();
}

void StallWatch::restart() {
  gaps_.clear();
  since_.start();
  processor_ = ownProcessorTime();
}

void StallWatch::tick() {
  const double seconds = 1e-9 * static_cast<double>(since_.nsecsElapsed());
  const double processor = ownProcessorTime();
  if (seconds >= kShortest) gaps_.push_back({seconds, processor - processor_});
  since_.start();
  processor_ = processor;
}

}  // namespace abstand::studio
