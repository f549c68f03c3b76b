#include "app/studio/live_port.hpp"

namespace abstand::studio {

void LivePort::send(const loop::Command& command) {
  waiting_.push_back(command);
  flush();
}

void LivePort::flush() {
  while (!waiting_.empty() && live_->send(waiting_.front())) waiting_.pop_front();
}

}  // namespace abstand::studio
