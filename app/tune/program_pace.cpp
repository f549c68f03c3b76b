#include "app/tune/program_pace.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/math/transform.hpp"

namespace abstand::tune {
namespace {

// Relative: pace reduction so that rounded times are never too fast.
constexpr double kPaceRounding = 1e-9;
// s: rows of two motions nearer than this are one node.
constexpr double kSameTime = 1e-9;

/// y at x by linear interpolation of the nodes; slope 1 before the first node, `after` beyond the last.
double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at, double after) {
  if (at <= x.front()) return y.front() + (at - x.front());
  if (at >= x.back()) return after;
  const auto k = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
  const double u = (at - x[k - 1]) / (x[k] - x[k - 1]);
  return (1.0 - u) * y[k - 1] + u * y[k];
}

/// Times of all rows, interval bounds, and steps in between.
std::vector<double> nodesOf(const std::vector<PermittedPace>& permitted,
                            const std::vector<ProgramMotion>& motions) {
  const double begin = programBegin(motions), end = programEnd(motions);
  std::vector<double> all{begin, end};
  for (const ProgramMotion& m : motions)
    all.insert(all.end(), m.motion.times().begin(), m.motion.times().end());
  for (const PermittedPace& p : permitted)
    for (const double t : {p.t0, p.t1})
      if (t > begin && t < end) all.push_back(t);
  std::sort(all.begin(), all.end());
  std::vector<double> nodes{begin};
  for (const double t : all) {
    if (t < nodes.back() + kSameTime) continue;
    const double from = nodes.back();
    const auto steps = static_cast<std::size_t>(std::ceil((t - from) / kPaceStep - kSameTime));
    for (std::size_t i = 1; i < steps; ++i)
      nodes.push_back(from + (t - from) * static_cast<double>(i) / static_cast<double>(steps));
    nodes.push_back(t);
  }
  // Exactly the end, even if a row is just before it.
  nodes.back() = end;
  return nodes;
}

/// Permitted pace between two nodes.
std::vector<double> scalesBetween(const std::vector<double>& nodes,
                                  const std::vector<PermittedPace>& permitted) {
  std::vector<double> scales(nodes.size() - 1, 1.0);
  std::size_t at = 0;
  for (std::size_t k = 0; k < scales.size(); ++k) {
    while (at < permitted.size() && permitted[at].t1 <= nodes[k] + kSameTime) ++at;
    for (std::size_t i = at; i < permitted.size() && permitted[i].t0 < nodes[k + 1] - kSameTime; ++i)
      scales[k] = std::min(scales[k], permitted[i].scale);
  }
  return scales;
}

/// Recorded speed of the fastest joint between two nodes.
std::vector<double> jointSpeeds(const std::vector<double>& nodes, const std::vector<ProgramMotion>& motions) {
  std::vector<double> speeds(nodes.size() - 1, 0.0);
  for (const ProgramMotion& m : motions) {
    std::vector<double> before(static_cast<std::size_t>(m.motion.dof())), now(before.size());
    m.motion.at(nodes.front(), before);
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k, before.swap(now)) {
      m.motion.at(nodes[k + 1], now);
      for (std::size_t j = 0; j < now.size(); ++j)
        speeds[k] = std::max(speeds[k], std::abs(now[j] - before[j]) / (nodes[k + 1] - nodes[k]));
    }
  }
  return speeds;
}

/// Pace at every node. A joint with recorded speed v at pace c decelerates by v dc/dt = v d(c^2 / 2)/dp: so
/// the squared pace may change by at most 2 a / v for each second of the program.
std::vector<double> pacesAt(const std::vector<double>& nodes, const std::vector<double>& scales,
                            const std::vector<double>& speeds, double deceleration) {
  std::vector<double> square(nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const double scale =
        std::min(k > 0 ? scales[k - 1] : scales[k], k < scales.size() ? scales[k] : scales[k - 1]);
    square[k] = scale * scale;
  }
  const auto change = [&](std::size_t k) {
    return speeds[k] > 0.0 ? 2.0 * deceleration / speeds[k] * (nodes[k + 1] - nodes[k]) : kInfinity;
  };
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
    square[k + 1] = std::min(square[k + 1], square[k] + change(k));
  for (std::size_t k = nodes.size() - 1; k-- > 0;) square[k] = std::min(square[k], square[k + 1] + change(k));
  for (double& s : square) s = std::sqrt(s);
  return square;
}

}  // namespace

ProgramPace::ProgramPace(std::vector<double> program, std::vector<double> clock)
    : program_(std::move(program)), clock_(std::move(clock)) {
  ABSTAND_CHECK(program_.size() == clock_.size() && program_.size() >= 2);
}

ProgramPace ProgramPace::uniform(double begin, double end, double scale) {
  ABSTAND_CHECK(scale > 0.0 && end > begin);
  return {{begin, end}, {begin, begin + (end - begin) / scale}};
}

double ProgramPace::clockAt(double program) const {
  return interpolated(program_, clock_, program, clock_.back() + (program - program_.back()));
}

double ProgramPace::programAt(double clock) const {
  return interpolated(clock_, program_, clock, program_.back());
}

ProgramPace permittedProgram(const std::vector<PermittedPace>& permitted,
                             const std::vector<ProgramMotion>& motions, double deceleration) {
  const std::vector<double> nodes = nodesOf(permitted, motions);
  ABSTAND_CHECK(nodes.size() >= 2);
  const std::vector<double> paces =
      pacesAt(nodes, scalesBetween(nodes, permitted), jointSpeeds(nodes, motions), deceleration);
  // With linear changes the pace in the middle of a step is the mean of both ends.
  const auto between = [&](std::size_t k) { return 0.5 * (paces[k] + paces[k + 1]) * (1.0 - kPaceRounding); };
  std::vector<double> program{nodes.front()}, clock{nodes.front()};
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    // Nodes without a change are omitted.
    if (k + 2 < nodes.size() && between(k) == between(k + 1)) continue;
    clock.push_back(clock.back() + (nodes[k + 1] - program.back()) / between(k));
    program.push_back(nodes[k + 1]);
  }
  return {std::move(program), std::move(clock)};
}

mechanism::MotionTable retimed(const mechanism::MotionTable& motion, const ProgramPace& pace) {
  std::vector<double> rows(motion.times().begin(), motion.times().end());
  for (const double t : pace.program()) {
    const auto after = std::lower_bound(motion.times().begin(), motion.times().end(), t - kSameTime);
    const bool is_row = after != motion.times().end() && *after <= t + kSameTime;
    if (t > motion.start() && t < motion.end() && !is_row) rows.push_back(t);
  }
  std::sort(rows.begin(), rows.end());
  std::vector<double> times, values, q(static_cast<std::size_t>(motion.dof()));
  for (const double row : rows) {
    times.push_back(pace.clockAt(row));
    motion.at(row, q);
    values.insert(values.end(), q.begin(), q.end());
  }
  return {std::move(times), std::move(values), motion.dof()};
}

double programBegin(const std::vector<ProgramMotion>& motions) {
  double begin = kInfinity;
  for (const ProgramMotion& m : motions) begin = std::min(begin, m.motion.start());
  return begin;
}

double programEnd(const std::vector<ProgramMotion>& motions) {
  double end = -kInfinity;
  for (const ProgramMotion& m : motions) end = std::max(end, m.motion.end());
  return end;
}

}  // namespace abstand::tune
