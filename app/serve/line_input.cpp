#include "app/serve/line_input.hpp"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace abstand::serve {

LineInput::LineInput(int handle, std::size_t most) : handle_(handle), room_(most + 1) {}

std::optional<std::string_view> LineInput::next() noexcept {
  if (auto line = cut()) return line;
  read();
  return cut();
}

std::optional<std::string_view> LineInput::cut() noexcept {
  while (begin_ < end_) {
    const char* const from = room_.data() + begin_;
    const void* const found = std::memchr(from + searched_, '\n', end_ - begin_ - searched_);
    if (found == nullptr && !has_ended_) {
      searched_ = end_ - begin_;
      return std::nullopt;
    }
    const std::size_t size =
        found ? static_cast<std::size_t>(static_cast<const char*>(found) - from) : end_ - begin_;
    begin_ += found ? size + 1 : size;
    searched_ = 0;
    if (is_skipping_) {
      is_skipping_ = false;
      continue;
    }
    return std::string_view(from, size);
  }
  return std::nullopt;
}

void LineInput::read() noexcept {
  if (has_ended_) return;
  pollfd p{handle_, POLLIN, 0};
  if (::poll(&p, 1, 0) <= 0) return;
  std::memmove(room_.data(), room_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  if (end_ == room_.size()) {
    if (!is_skipping_) ++too_long_;
    is_skipping_ = true;
    end_ = searched_ = 0;
  }
  const ssize_t n = ::read(handle_, room_.data() + end_, room_.size() - end_);
  if (n > 0)
    end_ += static_cast<std::size_t>(n);
  else if (n == 0 || (errno != EINTR && errno != EAGAIN))
    has_ended_ = true;
}

}  // namespace abstand::serve
