// Check of certified distances of moving bodies with warm starts, against exact distances.
#include "core/verify/moving_bound.hpp"

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

constexpr std::size_t kMotionSteps = 40;   // on one path
constexpr std::size_t kPosesAStep = 5;     // poses at rest for each step here
constexpr std::uint64_t kOtherPoses = 77;  // seed offset: poses differ from those at rest
// m for each step, approximate displacement of the point that moves most.
constexpr std::array kStepSizes{1e-6, 1e-5, 1e-4, 1e-3, 1e-2};

struct BodyPath {
  bool done{false};
  std::size_t size{0};  ///< index in kStepSizes
  std::array<BoundAnswer, kMotionSteps> answers;
  std::array<bool, kMotionSteps> overlapping{};
};

/// Bodies move in a nearly constant direction, as limbs and links do, and rotate about a point of their own.
BodyPath walk(const std::vector<AdversarialBody>& bodies, std::uint64_t seed, std::size_t index) {
  AdversarialPose pose = adversarialPose(bodies, seed + kOtherPoses, index);
  // At kilometres the memory holds nothing that a step would change.
  for (std::uint64_t other = 1; pose.family == PoseFamily::kFar; ++other)
    pose = adversarialPose(bodies, seed + kOtherPoses + other, index);
  const AdversarialBody &a = bodies[pose.a], &b = bodies[pose.b];
  const std::size_t field = index % kFields.size();
  const structure::HapticStructure &A = *a.structures[field], &B = *b.structures[field];
  Random random(seed + kOtherPoses, index);
  BodyPath path;
  path.size = random.below(kStepSizes.size());
  const double step = kStepSizes[path.size];
  const bool rests = random.chance(0.3);  // compilers differ in the order of operands
  const Vector3d displacement = random.direction() * (rests ? 0.0 : step);
  const Vector3d axis = random.direction(), about = b.centre + random.inCube(b.radius);
  const double angle = random.chance(0.3) ? 0.0 : step / std::max(b.radius, 1e-3);
  Transform turn = Transform::Identity();
  turn.linear() = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  turn.translation() = about - turn.linear() * about;

  query::PairMemory memory;
  kernels::PairScratch scratch;
  query::PairResult result;
  for (std::size_t i = 0; i < kMotionSteps; ++i) {
    query::queryPair({A, pose.X_WA}, {B, pose.X_WB}, {}, {memory, scratch}, result);
    const BoundJudge judge(a, pose.X_WA, b, pose.X_WB);
    path.answers[i] = judge(result);
    path.overlapping[i] = judge.exact().overlapping;
    pose.X_WB = pose.X_WB * turn;
    pose.X_WB.translation() += displacement + 0.1 * step * random.direction();
  }
  path.done = true;
  return path;
}

Table tableOf(const std::vector<BodyPath>& paths) {
  Table table;
  table.header = {"metres a step",      "poses",     "overlapping",   "breaches",
                  "error p50 [voxels]", "error p99", "largest error", "largest part of the bound used"};
  for (std::size_t s = 0; s < kStepSizes.size(); ++s) {
    std::size_t overlapping = 0, breaches = 0;
    std::vector<double> errors, used;
    for (const BodyPath& path : paths) {
      if (path.size != s) continue;
      for (std::size_t i = 0; i < kMotionSteps; ++i) {
        const BoundAnswer& answer = path.answers[i];
        overlapping += path.overlapping[i];
        breaches += answer.breach;
        used.push_back(answer.used);
        if (!std::isnan(answer.error)) errors.push_back(answer.error);
      }
    }
    table.rows.push_back({shortNumber(kStepSizes[s]), std::to_string(used.size()),
                          std::to_string(overlapping), std::to_string(breaches),
                          shortNumber(lowerQuantile(errors, 0.5)), shortNumber(lowerQuantile(errors, 0.99)),
                          shortNumber(lowerQuantile(errors, 1.0)), shortNumber(lowerQuantile(used, 1.0))});
  }
  return table;
}

}  // namespace

std::vector<CheckResult> checkMovingBound(const VerifyOptions& options) {
  const std::vector<AdversarialBody> bodies = adversarialBodies(options.threads);
  std::vector<BodyPath> paths(std::max<std::size_t>(1, options.poses / (kPosesAStep * kMotionSteps)));
  std::atomic<std::size_t> done{0};
  const auto caller = std::this_thread::get_id();
  parallelFor(options.threads, paths.size(), [&](std::size_t i) {
    if (options.stop()) return;
    paths[i] = walk(bodies, options.seed, i);
    ++done;
    if (options.progress && std::this_thread::get_id() == caller) options.progress(done, paths.size());
  });
  const auto all = paths.size();
  std::erase_if(paths, [](const BodyPath& path) { return !path.done; });

  CheckResult result;
  result.name = "bound.moving";
  result.what =
      "Bodies move on from adversarial poses, and the engine remembers the step before: the true distance of "
      "their "
      "meshes is never below distance - bound. All kinds of fields.";
  result.quantity = "(distance - true distance) / bound";
  result.reason = "What is remembered may make an answer quicker, and never weaken its bound.";
  std::vector<double> used;
  std::size_t breaches = 0;
  for (const BodyPath& path : paths)
    for (const BoundAnswer& answer : path.answers) {
      used.push_back(answer.used);
      breaches += answer.breach;
    }
  judge(result, used, 1.0);
  // The tolerance includes the rounding of the brute force; NaN is a breach.
  result.breaches = breaches;
  result.passed = paths.size() == all && breaches == 0;
  result.table = tableOf(paths);
  return {result};
}

}  // namespace abstand::verify
