// Distances of pairs against exact distances of meshes, over poses that are hard on the engine.
#include "core/verify/certified_bound.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "core/base/number.hpp"
#include "core/base/parallel.hpp"
#include "core/haptic/pair_query.hpp"
#include "core/verify/exact_pair.hpp"
#include "core/verify/nasty_poses.hpp"
#include "core/verify/statistics.hpp"

namespace abstand::verify {
namespace {

constexpr std::size_t kChunk = 50;
// m, and of the way between the bodies: rounding of the brute force itself, in double.
constexpr double kOracleRounding = 1e-9;
constexpr double kOraclePart = 1e-12;
// Of a voxel: how closely depths are enclosed.
constexpr double kDepthTolerance = 0.05;
// Shell points are kept and moved in float, 6e-8 of their coordinates a step, and a witness starts at one.
constexpr double kFloatPart = 1e-6;

struct Outcome {
  PoseFamily family{PoseFamily::kRandom};
  bool done{false};
  bool overlapping{false};
  double used{0.0};    ///< (distance - true) / bound
  double below{0.0};   ///< (true - distance) / size
  double error{0.0};   ///< |distance - true| in voxels; NaN where the truth is not enclosed
  bool breach{false};
};

Outcome judge(const std::vector<NastyBody>& bodies, const NastyPose& pose) {
  const NastyBody &a = bodies[pose.a], &b = bodies[pose.b];
  PairScratch scratch;
  PairResult r;
  queryPair(*a.structure, pose.X_WA, *b.structure, pose.X_WB, {}, scratch, r);

  const bool from_a = pointsFromA(*a.structure, *b.structure);
  const NastyBody &P = from_a ? a : b, &F = from_a ? b : a;
  const Transform X_FP = from_a ? Transform(pose.X_WB.inverse() * pose.X_WA) : Transform(pose.X_WA.inverse() * pose.X_WB);
  const double voxel = std::max(P.options.voxel_size, F.options.voxel_size);
  const double least_voxel = std::min(P.options.voxel_size, F.options.voxel_size);
  const ExactDistance exact = exactDistance(P, F, X_FP, kDepthTolerance * least_voxel);
  const double rounding = kOracleRounding * (voxel / 0.005) +
                          kOraclePart * (X_FP.translation().norm() + pose.X_WA.translation().norm());

  Outcome o;
  o.family = pose.family;
  o.done = true;
  o.overlapping = exact.overlapping;
  // Written so that NaN is a breach.
  o.breach = !(r.distance - r.bound <= exact.most + rounding);
  o.used = r.bound > 0.0 ? (r.distance - exact.most) / r.bound : (o.breach ? kInfinity : 0.0);
  const double size = P.structure->bounding_sphere.radius + F.structure->bounding_sphere.radius;
  o.below = std::max(0.0, exact.least - r.distance - rounding) / (size + X_FP.translation().norm());
  o.error = std::isfinite(exact.least)
                ? std::max({0.0, r.distance - exact.most, exact.least - r.distance}) / voxel
                : kNaN;
  return o;
}

std::string shortNumber(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", v);
  return text;
}

/// Parts of the poses at or above each error.
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

std::vector<double> collect(const std::vector<Outcome>& outcomes, double Outcome::* member, int family = -1) {
  std::vector<double> values;
  for (const Outcome& o : outcomes)
    if ((family < 0 || static_cast<int>(o.family) == family) && !std::isnan(o.*member)) values.push_back(o.*member);
  return values;
}

Table familyTable(const std::vector<Outcome>& outcomes) {
  Table table;
  table.header = {"poses", "number", "overlapping", "breaches", "error p50 [voxels]", "error p99", "largest error",
                  "largest part of the bound used"};
  for (int f = 0; f < kPoseFamilies; ++f) {
    std::size_t number = 0, overlapping = 0, breaches = 0;
    for (const Outcome& o : outcomes) {
      if (static_cast<int>(o.family) != f) continue;
      ++number;
      overlapping += o.overlapping;
      breaches += o.breach;
    }
    const auto errors = collect(outcomes, &Outcome::error, f);
    table.rows.push_back({familyName(static_cast<PoseFamily>(f)), std::to_string(number),
                          std::to_string(overlapping), std::to_string(breaches), shortNumber(quantile(errors, 0.5)),
                          shortNumber(quantile(errors, 0.99)), shortNumber(quantile(errors, 1.0)),
                          shortNumber(quantile(collect(outcomes, &Outcome::used, f), 1.0))});
  }
  return table;
}

void summarize(CheckResult& result, const std::vector<double>& values) {
  result.p50 = quantile(values, 0.5);
  result.p99 = quantile(values, 0.99);
  result.worst = quantile(values, 1.0);
}

}  // namespace

std::vector<CheckResult> checkCertifiedBound(FieldKind field, const VerifyOptions& options) {
  const std::vector<NastyBody> bodies = nastyBodies(field, options.threads);
  std::vector<Outcome> outcomes(options.poses);
  std::atomic<std::size_t> done{0};
  const auto caller = std::this_thread::get_id();
  parallelFor(options.threads, (options.poses + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    if (options.stop()) return;
    const std::size_t end = std::min(options.poses, (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; ++i)
      outcomes[i] = judge(bodies, nastyPose(bodies, options.seed, i));
    done += end - chunk * kChunk;
    if (options.progress && std::this_thread::get_id() == caller) options.progress(done, options.poses);
  });
  std::erase_if(outcomes, [](const Outcome& o) { return !o.done; });
  const bool complete = outcomes.size() == options.poses && !outcomes.empty();

  CheckResult bound;
  bound.name = "bound." + std::string(fieldName(field));
  bound.what = "The true distance of two meshes, by brute force over all pairs of triangles, is never below "
               "distance - bound: " +
               std::to_string(bodies.size()) + " bodies in nine families of poses, " + std::string(fieldName(field)) +
               " field.";
  bound.quantity = "(distance - true distance) / bound";
  bound.reason = "The contract: the true distance is never below distance - bound.";
  bound.poses = outcomes.size();
  bound.limit = 1.0;
  bound.breaches = static_cast<std::size_t>(std::ranges::count_if(outcomes, &Outcome::breach));
  summarize(bound, collect(outcomes, &Outcome::used));
  bound.passed = complete && bound.breaches == 0;
  bound.table = familyTable(outcomes);
  Plot plot{"Errors of the distance", "|distance - true distance| [voxels]", "part of the poses at or above",
            true, true, {}};
  for (int f = 0; f < kPoseFamilies; ++f)
    plot.series.push_back(
        distribution(familyName(static_cast<PoseFamily>(f)), collect(outcomes, &Outcome::error, f)));
  bound.plots.push_back(std::move(plot));

  CheckResult attained;
  attained.name = "attained." + std::string(fieldName(field));
  attained.what = "The distance is that of two points of the surfaces, so it never lies below the true one "
                  "(inside: no deeper than the deepest point). Same poses.";
  attained.quantity = "(true distance - distance) / size of the pair";
  attained.reason = "Witnesses start at shell points, which are kept and moved in float (6e-8 a step).";
  attained.poses = outcomes.size();
  attained.limit = kFloatPart;
  const auto below = collect(outcomes, &Outcome::below);
  attained.breaches = static_cast<std::size_t>(std::ranges::count_if(below, [](double v) { return v > kFloatPart; }));
  summarize(attained, below);
  attained.passed = complete && attained.breaches == 0;
  return {bound, attained};
}

}  // namespace abstand::verify
