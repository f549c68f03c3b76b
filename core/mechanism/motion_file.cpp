#include "core/mechanism/motion_file.hpp"

#include <algorithm>
#include <string_view>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/text_file.hpp"
#include "core/text/message_text.hpp"

namespace abstand::mechanism {
namespace {

constexpr std::uintmax_t kMaxBytes = std::uintmax_t{512} << 20;

/// The cells of one line, in sequence.
class Cells {
 public:
  explicit Cells(std::string_view line) : line_(line) {}
  bool atEnd() const { return begin_ > line_.size(); }
  int column() const { return static_cast<int>(begin_) + 1; }
  std::string_view peek() const {
    return text::trimmed(line_.substr(begin_, line_.find(',', begin_) - begin_));
  }
  void advance() {
    const auto comma = line_.find(',', begin_);
    begin_ = comma == std::string_view::npos ? line_.size() + 1 : comma + 1;
  }

 private:
  std::string_view line_;
  std::size_t begin_{0};
};

std::string columnName(int i) { return i == 0 ? "t" : "q" + std::to_string(i - 1); }

}  // namespace

MotionTable::MotionTable(std::vector<double> t, std::vector<double> q, int dof)
    : t_(std::move(t)), q_(std::move(q)), dof_(dof) {
  ABSTAND_CHECK(dof_ >= 0 && !t_.empty() && q_.size() == t_.size() * static_cast<std::size_t>(dof_));
}

void MotionTable::at(double t, std::span<double> q) const {
  const auto n = static_cast<std::size_t>(dof_);
  ABSTAND_CHECK(q.size() == n);
  if (!(t > t_.front())) {
    std::copy_n(q_.begin(), n, q.begin());
    return;
  }
  if (t >= t_.back()) {
    std::copy_n(q_.end() - dof_, n, q.begin());
    return;
  }
  const auto after = static_cast<std::size_t>(std::upper_bound(t_.begin(), t_.end(), t) - t_.begin());
  const double u = (t - t_[after - 1]) / (t_[after] - t_[after - 1]);
  const double* q0 = q_.data() + (after - 1) * n;
  for (std::size_t i = 0; i < n; ++i) q[i] = (1.0 - u) * q0[i] + u * q0[n + i];
}

MotionTable parseMotion(const std::string& text, const std::string& name, int dof) {
  const auto fail = [&](int line, int column, const std::string& message) {
    throw ParseError({name, line, column}, message);
  };
  std::string header = "t";
  for (int i = 1; i <= dof; ++i) header += "," + columnName(i);

  std::vector<double> t, q;
  int number = 0;
  bool has_header = false;
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  while (!rest.empty()) {
    ++number;
    const auto end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (text::trimmed(line).empty()) continue;

    Cells cells(line);
    for (int i = 0; i <= dof; ++i) {
      if (cells.atEnd())
        fail(number, static_cast<int>(line.size()) + 1,
             "found " + std::to_string(i) + " columns, expected " + std::to_string(dof + 1) + ": " + header);
      const auto cell = cells.peek();
      if (!has_header) {
        if (cell != columnName(i))
          fail(number, cells.column(), "found " + text::inQuotes(cell) + ", expected the header " + header);
      } else if (const auto value = parseDouble(cell); !value) {
        fail(number, cells.column(),
             "found " + text::inQuotes(cell) + ", expected " + columnName(i) + ": a finite number");
      } else if (i > 0) {
        q.push_back(*value);
      } else {
        if (!t.empty() && *value <= t.back())
          fail(number, cells.column(),
               "found t = " + formatDouble(*value) + " behind " + formatDouble(t.back()) +
                   ", expected rising times");
        t.push_back(*value);
      }
      cells.advance();
    }
    if (!cells.atEnd())
      fail(number, cells.column(),
           "found another column " + text::inQuotes(cells.peek()) + ", expected " + std::to_string(dof + 1) +
               ": " + header);
    has_header = true;
  }
  if (t.empty())
    throw ParseError({name}, "found no row of numbers, expected the header " + header + " and rows");
  return {std::move(t), std::move(q), dof};
}

MotionTable loadMotion(const std::filesystem::path& file, int dof) {
  return parseMotion(readFile(file, kMaxBytes), file.string(), dof);
}

std::string formatMotion(const MotionTable& motion) {
  std::string text = "t";
  for (int i = 1; i <= motion.dof(); ++i) text += "," + columnName(i);
  text += "\n";
  const auto dof = static_cast<std::size_t>(motion.dof());
  for (std::size_t row = 0; row < motion.rows(); ++row) {
    text += formatDouble(motion.times()[row]);
    for (std::size_t i = 0; i < dof; ++i) text += "," + formatDouble(motion.values()[row * dof + i]);
    text += "\n";
  }
  return text;
}

}  // namespace abstand::mechanism
