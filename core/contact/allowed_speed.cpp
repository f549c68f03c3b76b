#include "core/contact/allowed_speed.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::contact {
namespace {

/// Interval that holds the highest speed whose share of the limit is at most 1. Pressure grows about as a
/// power of the speed, so the next speed comes from the power through the last two evaluations, moved a
/// little towards the middle so that both ends close in. Its distance from the middle is limited as in the
/// ITP method (Oliveira and Takahashi 2020): never more evaluations than bisection and kMoreThanHalvings.
class SpeedBracket {
 public:
  SpeedBracket(double speed, double share)
      : broken_{speed},
        narrow_{std::ldexp(speed, -kPressureHalvings)},
        last_{speed, share},
        before_{kNaN, kNaN} {}

  /// The speed to evaluate next; 0 when the interval is narrow enough.
  double next() const {
    const double width = broken_ - kept_, middle = 0.5 * (kept_ + broken_);
    if (width <= narrow_ || count_ >= kPressureHalvings + kMoreThanHalvings) return 0.0;
    const double power = before_.speed > 0.0
                             ? std::log(last_.share / before_.share) / std::log(last_.speed / before_.speed)
                             : 1.0;
    double at = last_.speed * std::pow(last_.share, -1.0 / power);
    if (!std::isfinite(at) || !std::isfinite(last_.share)) return middle;
    at = std::clamp(at, kept_, broken_);
    const double inward = middle > at ? 1.0 : -1.0, shift = 0.45 * narrow_;
    at = shift <= std::abs(middle - at) ? at + inward * shift : middle;
    const double radius =
        std::max(0.0, std::ldexp(narrow_, kPressureHalvings + kMoreThanHalvings - 1 - count_) - 0.5 * width);
    return std::abs(at - middle) <= radius ? at : middle - inward * radius;
  }

  void add(double speed, double share) {
    ++count_;
    before_ = last_;
    last_ = {speed, share};
    (share <= 1.0 ? kept_ : broken_) = speed;
  }

  /// The highest speed evaluated so far that is within the limit, or 0.
  double kept() const { return kept_; }

 private:
  struct Evaluation {
    double speed, share;
  };

  double kept_{0.0}, broken_;
  double narrow_;  ///< width at which the search ends
  Evaluation last_, before_;
  int count_{0};
};

/// Allowed speed for one region, at most `wanted`.
AllowedSpeed speedOf(const RegionLimits& region, const ContactPartner& partner, double wanted,
                     const AreaAt& area) {
  if (region.excluded()) return {0.0, LimitKind::kExcluded, &region};
  const double by_force = predictContact(region, {0.0, partner.robot, partner.kind}).allowed_speed;
  if (!(by_force > 0.0)) return {0.0, LimitKind::kForce, &region};
  const auto shareAt = [&](double speed) {
    const PredictedContact contact = predictContact(region, {speed, partner.robot, partner.kind});
    return predictPressure(region, contact, area(contact.indentation), partner.kind).share;
  };
  const AllowedSpeed force{std::min(by_force, wanted), LimitKind::kForce, &region};
  // A small indentation has the smaller patch; that of a large one may be certain where the small one's is
  // not.
  const double share = shareAt(force.speed);
  if (share <= 1.0 || (wanted < by_force && shareAt(by_force) <= 1.0)) return force;
  SpeedBracket bracket(force.speed, share);
  while (const double speed = bracket.next()) bracket.add(speed, shareAt(speed));
  return {bracket.kept(), LimitKind::kPressure, &region};
}

}  // namespace

AllowedSpeed allowedSpeed(const std::vector<const RegionLimits*>& regions, const ContactPartner& partner,
                          double wanted, const AreaAt& area) {
  AllowedSpeed least;
  for (const RegionLimits* region : regions)
    if (region->excluded()) return {0.0, LimitKind::kExcluded, region};
  if (!(wanted > 0.0)) return least;
  for (const RegionLimits* region : regions) {
    const AllowedSpeed allowed = speedOf(*region, partner, least.region ? least.speed : wanted, area);
    if (!least.region || allowed.speed < least.speed) least = allowed;
    if (!(least.speed > 0.0)) break;
  }
  return least;
}

double speedShare(double allowed, double robot_speed, double person_speed) {
  if (std::isnan(allowed) || std::isnan(person_speed) || !(robot_speed > 0.0)) return 0.0;
  // Rounding must not reduce a speed that is allowed unchanged.
  if (robot_speed + person_speed <= allowed) return 1.0;
  return std::clamp((allowed - person_speed) / robot_speed, 0.0, 1.0);
}

}  // namespace abstand::contact
