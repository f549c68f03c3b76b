// Recorded joint motion: a table of joint values over time.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace abstand::mechanism {

/// Constant after loading; shared by all threads. Always has at least one row.
class MotionTable {
 public:
  /// `q`: `dof` values for each row, SI (rad, m); `t` (s): strictly increasing.
  MotionTable(std::vector<double> t, std::vector<double> q, int dof);

  int dof() const { return dof_; }
  std::size_t rows() const { return t_.size(); }
  double start() const { return t_.front(); }
  double end() const { return t_.back(); }
  /// Times of the rows (s), and the joint values, row by row.
  std::span<const double> times() const { return t_; }
  std::span<const double> values() const { return q_; }

  /// Joint values at time t (s): linear between rows, the first or last row outside. `q` has size dof(). No
  /// allocation, no throw.
  void at(double t, std::span<double> q) const;

 private:
  std::vector<double> t_, q_;
  int dof_;
};

/// Reads a CSV file with the header `t,q0,q1,...` (`dof` joints) and one row for each time: finite numbers in
/// SI, t strictly increasing. Throws ParseError with file, line and column.
MotionTable loadMotion(const std::filesystem::path& file, int dof);

/// The same from text; `name` is used as the file name in messages.
MotionTable parseMotion(const std::string& text, const std::string& name, int dof);

/// Text that parseMotion() reads back to exactly the same numbers.
std::string formatMotion(const MotionTable& motion);

}  // namespace abstand::mechanism
