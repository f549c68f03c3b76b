#include "app/run/joint_limits.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/mechanism/motion_limits.hpp"

namespace abstand::run {
namespace {

std::vector<mechanism::LimitBreach> plannedBreaches(const session::MechanismDriver& driver, bool reacts,
                                                    double start, double end) {
  if (driver.motion())
    return mechanism::motionBreaches(driver.mechanism(), *driver.motion(),
                                     reacts ? mechanism::MotionLine::kSmooth : mechanism::MotionLine::kLinear,
                                     start, end, driver.X_WB().linear().transpose() * mechanism::kGravity);
  mechanism::JointLimitWatch watch(mechanism::dofLimits(driver.mechanism()));
  watch.check(start, driver.home(), {}, {}, {});
  return watch.breaches();
}

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  for (char* c = text; *c; ++c)
    if (*c == ',') *c = '.';  // independent of the locale
  return text;
}

}  // namespace

std::vector<JointLimitReport> reportsOf(const std::string& name, const mechanism::Mechanism& mechanism,
                                        const std::vector<mechanism::LimitBreach>& breaches, bool planned) {
  const std::vector<std::string> joints = mechanism::dofNames(mechanism);
  std::vector<JointLimitReport> reports;
  for (const mechanism::LimitBreach& b : breaches) {
    JointLimitReport& r = reports.emplace_back(
        JointLimitReport{name, joints[static_cast<std::size_t>(b.dof)], b, false, planned});
    for (const auto& f : mechanism.frames)
      if (f.dof == b.dof && !f.mimic) r.slides = f.type == mechanism::JointType::kPrismatic;
  }
  return reports;
}

std::vector<JointLimitReport> jointLimitsOf(const session::Session& session, const loop::ClosedLoop* loop,
                                            double start, double end) {
  std::vector<JointLimitReport> all;
  for (std::size_t m = 0; m < session.mechanisms().size(); ++m) {
    const session::MechanismDriver& driver = *session.mechanisms()[m];
    const std::string& name = session.description().mechanisms[m].name;
    const loop::ReactingRobot* const robot = loop ? loop->robots()[m].get() : nullptr;
    const auto add = [&](const std::vector<mechanism::LimitBreach>& breaches, bool planned) {
      const auto reports = reportsOf(name, driver.mechanism(), breaches, planned);
      all.insert(all.end(), reports.begin(), reports.end());
    };
    add(plannedBreaches(driver, robot != nullptr, start, end), true);
    if (robot) add(robot->limits().breaches(), false);
  }
  return all;
}

std::vector<Reservation> reservationsOf(const std::vector<JointLimitReport>& reports) {
  std::vector<Reservation> all;
  for (const JointLimitReport& r : reports) {
    Reservation& one = all.emplace_back();
    one.kind = "joint_limit";
    one.text = "joint limit exceeded: " + describe(r);
    one.t0 = r.worst.since;
    one.fails = scene::Severity::kStrict;
  }
  return all;
}

std::string describe(const JointLimitReport& r) {
  constexpr std::array<const char*, mechanism::kLimitKinds> kTurns{"rad", "rad/s", "rad/s^2", "N m"};
  constexpr std::array<const char*, mechanism::kLimitKinds> kSlides{"m", "m/s", "m/s^2", "N"};
  const mechanism::LimitBreach& b = r.worst;
  const auto kind = static_cast<std::size_t>(b.kind);
  std::string text = r.mechanism.empty() ? "" : r.mechanism + " ";
  text += "joint " + r.joint + ": " + (r.planned ? "planned " : "") +
          std::string(mechanism::limitName(b.kind)) + " " + number(b.value) + " " +
          (r.slides ? kSlides : kTurns)[kind] + ", limit " + number(b.limit);
  if (std::isfinite(b.t)) text += ", at " + number(b.t) + " s";
  if (b.count > 1)
    text += ", exceeded in " + std::to_string(b.count) + " samples since " + number(b.since) + " s";
  return text;
}

}  // namespace abstand::run
