// Lines from a pipe, a terminal or a file, without waiting for them.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace abstand::serve {

/// Splits what comes through a file descriptor into lines. One thread. Nothing allocates or throws but the
/// constructor.
class LineInput {
 public:
  /// `handle` is read, not closed. Lines may have up to `most` bytes.
  LineInput(int handle, std::size_t most);

  /// The next line without its end, there until the next call; nothing where no whole one has come. What
  /// stands behind the last end of line is a line when the input ended. Longer lines than `most` are skipped
  /// and counted. Never waits, and reads from the system once at most.
  std::optional<std::string_view> next() noexcept;

  /// What to wait on for more; -1 once the input has ended.
  int handle() const { return has_ended_ ? -1 : handle_; }
  bool hasEnded() const { return has_ended_; }
  long tooLong() const { return too_long_; }

 private:
  std::optional<std::string_view> cut() noexcept;
  void read() noexcept;

  int handle_;
  std::vector<char> room_;
  std::size_t begin_{0}, end_{0};  ///< of what came and was not handed out
  std::size_t searched_{0};        ///< bytes from begin_ without an end of line
  bool is_skipping_{false};        ///< the rest of a line that is too long
  bool has_ended_{false};
  long too_long_{0};
};

}  // namespace abstand::serve
