// Check of certified distances against exact ones, in adversarial poses.
#include "core/verify/certified_bound.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <thread>

#include "core/base/parallel.hpp"
#include "core/math/quantile.hpp"
#include "core/verify/adversarial_poses.hpp"
#include "core/verify/bound_judge.hpp"
#include "core/verify/check_tools.hpp"

namespace abstand::verify {
namespace {

constexpr std::size_t kChunk = 50;
// Shell points are stored and transformed in float, with an error of 6e-8 of their coordinates each, and a
// witness starts at one.
constexpr double kFloatPart = 1e-6;

struct Outcome {
  PoseFamily family{PoseFamily::kRandom};
  bool done{false};
  bool overlapping{false};
  bool swallowed{false};
  std::array<BoundAnswer, kFields.size()> answers;
};

Outcome queryAll(const std::vector<AdversarialBody>& bodies, const AdversarialPose& pose) {
  const AdversarialBody &a = bodies[pose.a], &b = bodies[pose.b];
  const BoundJudge judge(a, pose.X_WA, b, pose.X_WB);
  Outcome o{pose.family, true, judge.exact().overlapping, judge.exact().swallowed, {}};
  for (std::size_t f = 0; f < kFields.size(); ++f)
    o.answers[f] = judge(query(*a.structures[f], pose.X_WA, *b.structures[f], pose.X_WB));
  return o;
}

/// Share of the poses with at least each error.
Series distribution(std::string name, std::vector<double> values) {
  Series s;
  s.name = std::move(name);
  std::ranges::sort(values);
  constexpr int kSteps = 60;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = std::pow(10.0, -4.0 + 5.0 * i / kSteps);
    const auto above = values.end() - std::ranges::lower_bound(values, x);
    s.x.push_back(x);
    s.y.push_back(static_cast<double>(above) / static_cast<double>(std::max<std::size_t>(values.size(), 1)));
  }
  return s;
}

std::vector<double> collect(const std::vector<Outcome>& outcomes, std::size_t field,
                            double BoundAnswer::*member, int family = -1) {
  std::vector<double> values;
  for (const Outcome& o : outcomes) {
    const double value = o.answers[field].*member;
    if ((family < 0 || static_cast<int>(o.family) == family) && !std::isnan(value)) values.push_back(value);
  }
  return values;
}

Table familyTable(const std::vector<Outcome>& outcomes, std::size_t field) {
  Table table;
  table.header = {"poses",
                  "number",
                  "overlapping",
                  "of them swallowed pieces",
                  "breaches",
                  "error p50 [voxels]",
                  "error p99",
                  "largest error",
                  "largest part of the bound used"};
  for (int family = 0; family < kPoseFamilies; ++family) {
    std::size_t number = 0, overlapping = 0, swallowed = 0, breaches = 0;
    for (const Outcome& o : outcomes) {
      if (static_cast<int>(o.family) != family) continue;
      ++number;
      overlapping += o.overlapping;
      swallowed += o.swallowed;
      breaches += o.answers[field].breach;
    }
    const auto errors = collect(outcomes, field, &BoundAnswer::error, family);
    const auto used = collect(outcomes, field, &BoundAnswer::used, family);
    table.rows.push_back({familyName(static_cast<PoseFamily>(family)), std::to_string(number),
                          std::to_string(overlapping), std::to_string(swallowed), std::to_string(breaches),
                          shortNumber(lowerQuantile(errors, 0.5)), shortNumber(lowerQuantile(errors, 0.99)),
                          shortNumber(lowerQuantile(errors, 1.0)), shortNumber(lowerQuantile(used, 1.0))});
  }
  return table;
}

CheckResult boundOf(const std::vector<Outcome>& outcomes, std::size_t field, std::size_t bodies) {
  CheckResult result;
  result.name = "bound." + std::string(structure::fieldName(kFields[field]));
  result.what =
      "The true distance of two meshes, by brute force over all pairs of triangles, is never below "
      "distance - bound: " +
      std::to_string(bodies) + " bodies, " + std::to_string(kPoseFamilies) + " families of poses, " +
      std::string(structure::fieldName(kFields[field])) + " fields.";
  result.quantity = "(distance - true distance) / bound";
  result.reason = "The contract: the true distance is never below distance - bound.";
  judge(result, collect(outcomes, field, &BoundAnswer::used), 1.0);
  // The tolerance includes the rounding of the brute force; NaN is a breach.
  result.breaches = 0;
  for (const Outcome& o : outcomes) result.breaches += o.answers[field].breach;
  result.table = familyTable(outcomes, field);
  Plot plot{"Errors of the distance",
            "|distance - true distance| [voxels]",
            "part of the poses at or above",
            true,
            true,
            {}};
  for (int f = 0; f < kPoseFamilies; ++f)
    plot.series.push_back(distribution(familyName(static_cast<PoseFamily>(f)),
                                       collect(outcomes, field, &BoundAnswer::error, f)));
  result.plots.push_back(std::move(plot));
  return result;
}

CheckResult attainedOf(const std::vector<Outcome>& outcomes, std::size_t field) {
  CheckResult result;
  result.name = "attained." + std::string(structure::fieldName(kFields[field]));
  result.what =
      "The distance is that of two points of the surfaces, so it never lies below the true one (inside: is "
      "no "
      "deeper than the deepest point). Same poses.";
  result.quantity = "(true distance - distance) / size of the pair";
  result.reason = "Witnesses start at shell points, which are kept and moved in float (6e-8 a step).";
  judge(result, collect(outcomes, field, &BoundAnswer::below), kFloatPart);
  return result;
}

}  // namespace

std::vector<CheckResult> checkCertifiedBound(const VerifyOptions& options) {
  const std::vector<AdversarialBody> bodies = adversarialBodies(options.threads);
  std::vector<Outcome> outcomes(options.poses);
  std::atomic<std::size_t> done{0};
  const auto caller = std::this_thread::get_id();
  parallelFor(options.threads, (options.poses + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    if (options.stop()) return;
    const std::size_t end = std::min(options.poses, (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; ++i)
      outcomes[i] = queryAll(bodies, adversarialPose(bodies, options.seed, i));
    done += end - chunk * kChunk;
    if (options.progress && std::this_thread::get_id() == caller) options.progress(done, options.poses);
  });
  std::erase_if(outcomes, [](const Outcome& o) { return !o.done; });
  const bool complete = outcomes.size() == options.poses && !outcomes.empty();

  std::vector<CheckResult> results;
  for (std::size_t f = 0; f < kFields.size(); ++f) {
    results.push_back(boundOf(outcomes, f, bodies.size()));
    results.push_back(attainedOf(outcomes, f));
  }
  for (CheckResult& r : results) r.passed = complete && r.breaches == 0;
  return results;
}

}  // namespace abstand::verify
