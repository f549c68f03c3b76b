// Non-blocking line input from a pipe, a terminal or a file.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace abstand::serve {

/// Splits the input of a file descriptor into lines. One thread. Only the constructor allocates or throws.
class LineInput {
 public:
  /// Reads from `handle` without closing it. Lines may have up to `most` bytes.
  LineInput(int handle, std::size_t most);

  /// The next line without its end, valid until the next call; nullopt if no complete line has arrived. Text
  /// after the last end of line is a line once the input has ended. Longer lines are skipped and counted.
  /// Never waits, and makes at most one read call.
  std::optional<std::string_view> next() noexcept;

  /// Descriptor to poll for more; -1 once the input has ended.
  int handle() const { return has_ended_ ? -1 : handle_; }
  bool hasEnded() const { return has_ended_; }
  long tooLong() const { return too_long_; }

 private:
  std::optional<std::string_view> cut() noexcept;
  void read() noexcept;

  int handle_;
  std::vector<char> room_;
  std::size_t begin_{0}, end_{0};  ///< of the input not yet returned
  std::size_t searched_{0};        ///< bytes from begin_ that contain no end of line
  bool is_skipping_{false};        ///< the rest of an overlong line
  bool has_ended_{false};
  long too_long_{0};
};

}  // namespace abstand::serve
