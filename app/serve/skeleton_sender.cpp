#include "app/serve/skeleton_sender.hpp"

#include <unistd.h>

#include "core/base/descriptor_stream.hpp"
#include "core/base/error.hpp"

namespace abstand::serve {
namespace {

constexpr double kGone = 1.0;  // s, after which a name becomes free

}  // namespace

SkeletonSender::SkeletonSender(const std::string& to, std::vector<std::string> names) {
  for (std::string& name : names) {
    if (!isLineName(name))
      throw UsageError(
          "--as: found an invalid name, expected 1 to 256 bytes without quotes, "
          "backslashes and control characters");
    for (const Name& other : names_)
      if (other.text == name) throw UsageError("--as: found '" + name + "' twice, expected distinct names");
    names_.push_back({std::move(name)});
  }
  if (to == "-") return;
  to_ = parseAddress(to, "--send");
  socket_.emplace(parseAddress(to.front() == '[' ? "[::]:0" : "0.0.0.0:0", "--send"));
}

SkeletonSender::Name* SkeletonSender::nameOf(int id, double t) noexcept {
  Name* vacant = nullptr;
  for (Name& name : names_) {
    const bool is_gone = t - name.last > kGone;
    if (name.id == id && !is_gone) return &name;
    if (is_gone && !vacant) vacant = &name;
  }
  if (vacant) vacant->id = id;
  return vacant;
}

void SkeletonSender::send(int id, double t, const humanmodel::SkeletonFrame& frame) noexcept {
  Name* const name = nameOf(id, t);
  if (!name) {
    ++nameless_;
    return;
  }
  name->last = t;
  const auto time_us = static_cast<std::uint64_t>(1e6 * std::max(t, 0.0));
  std::size_t bytes = writeSkeletonLine(frame, name->text, name->sequence++, time_us, line_);
  ++(write(bytes) ? sent_ : refused_);
}

bool SkeletonSender::write(std::size_t bytes) noexcept {
  if (bytes == 0 || bytes == line_.size()) return false;
  if (to_) return socket_->send(std::span(line_).first(bytes), *to_);
  line_[bytes] = std::byte{'\n'};
  if (output_error_ == 0)
    output_error_ = writeAll(STDOUT_FILENO, {reinterpret_cast<const char*>(line_.data()), bytes + 1});
  return output_error_ == 0;
}

}  // namespace abstand::serve
