#include "core/base/progress_report.hpp"

#include <utility>

namespace abstand {

ProgressReport::ProgressReport(std::string label, bool on_terminal,
                               std::function<void(const std::string&)> write, std::function<double()> seconds)
    : label_(std::move(label)),
      on_terminal_(on_terminal),
      write_(std::move(write)),
      seconds_(std::move(seconds)),
      begin_(seconds_()),
      last_(begin_) {}

void ProgressReport::operator()(std::size_t done, std::size_t all) {
  const std::size_t percent = all ? 100 * done / all : 100;
  if (on_terminal_) {
    if (percent == percent_) return;
    percent_ = percent;
    const std::string number = std::to_string(percent);
    write_("\r" + label_ + std::string(number.size() < 3 ? 4 - number.size() : 1, ' ') + number + " %" +
           (done == all ? "\n" : ""));
    return;
  }
  const double now = seconds_();
  if (now - last_ < kInterval) return;
  last_ = now;
  write_(label_ + ": " + std::to_string(percent) + " % after " +
         std::to_string(static_cast<long>(now - begin_)) + " s\n");
}

}  // namespace abstand
