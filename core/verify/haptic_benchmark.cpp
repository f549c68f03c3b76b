// Check of the accuracy of forces and torques: reconstruction of the haptic benchmark of 2010.
#include "core/verify/haptic_benchmark.hpp"

#include <array>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/verify/check_tools.hpp"
#include "core/verify/haptic_scenes.hpp"
#include "core/verify/statistics.hpp"

namespace abstand::verify {
namespace {

constexpr double kBenchmarkVoxel = 0.002;    // m, also the point spacing
constexpr double kBenchmarkStiffness = 1e6;  // N/m^3

struct Method {
  const char* name;
  structure::FieldKind field;
  query::ForceLaw law;
};
constexpr std::array kMethods{
    Method{"layered, thesis law", structure::FieldKind::kLayered, query::ForceLaw::kThesis},
    Method{"layered, volume law", structure::FieldKind::kLayered, query::ForceLaw::kVolume},
    Method{"float", structure::FieldKind::kFloat, query::ForceLaw::kVolume},
    Method{"mixed", structure::FieldKind::kMixed, query::ForceLaw::kVolume}};

/// RMS values over a path.
struct Quality {
  double angle_deg, size_percent, noise_percent, torque_percent;
};

// Layers err by up to half a voxel of depth, and depths are one to six voxels here. Float distances on flat
// and gently curved faces are accurate; the rest is the error of points one voxel apart at rims and tips.
constexpr Quality kLayeredLimits{10.0, 15.0, 8.0, 5.0};
constexpr Quality kFloatLimits{0.5, 2.0, 0.2, 0.5};

struct Signal {
  std::vector<Vector3d> force, torque_a, torque_b;
};

Signal measure(const HapticScene& scene, const Method& method, int threads) {
  const structure::HapticOptions options{.voxel_size = kBenchmarkVoxel,
                                         .point_spacing = kBenchmarkVoxel,
                                         .outer_layers = kOuterLayers,
                                         .field = method.field};
  const auto a = structure::buildHapticStructure("a", scene.a, options, threads);
  const auto b = structure::buildHapticStructure("b", scene.b, options, threads);
  const std::size_t n = scene.path.size();
  Signal signal{std::vector<Vector3d>(n), std::vector<Vector3d>(n), std::vector<Vector3d>(n)};
  parallelFor(threads, n, [&](std::size_t i) {
    const query::PairResult r = query(*a, scene.path[i].X_WA, *b, Transform::Identity(),
                                      {.stiffness = kBenchmarkStiffness, .law = method.law});
    signal.force[i] = r.force_a;
    signal.torque_a[i] = r.torque_a;
    signal.torque_b[i] = r.torque_b;
  });
  return signal;
}

/// The factor that fits the measured forces to the true ones over all poses (least squares).
double gainOf(const HapticScene& scene, const Signal& signal) {
  double along = 0.0, size = 0.0;
  for (std::size_t i = 0; i < scene.path.size(); ++i) {
    along += signal.force[i].dot(kBenchmarkStiffness * scene.path[i].force_a);
    size += signal.force[i].squaredNorm();
  }
  return along / size;
}

Quality qualityOf(const HapticScene& scene, const Signal& signal) {
  const std::size_t n = scene.path.size();
  const double length = scene.a->bounds().extent().norm();
  std::vector<Vector3d> errors(n);
  std::vector<double> angles, sizes, noise, torques;
  double mean = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    mean += kBenchmarkStiffness * scene.path[i].force_a.norm() / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3d truth = kBenchmarkStiffness * scene.path[i].force_a, &force = signal.force[i];
    errors[i] = force - truth;
    angles.push_back(std::atan2(force.cross(truth).norm(), force.dot(truth)) * 180.0 / kPi);
    sizes.push_back(100.0 * (force.norm() / truth.norm() - 1.0));
    torques.push_back(100.0 * (signal.torque_a[i] - kBenchmarkStiffness * scene.path[i].torque_a).norm() /
                      (mean * length));
    torques.push_back(100.0 * (signal.torque_b[i] - kBenchmarkStiffness * scene.path[i].torque_b).norm() /
                      (mean * length));
    if (i >= 2 && !(i >= scene.second_part && i < scene.second_part + 2))
      noise.push_back(100.0 * (errors[i] - 2.0 * errors[i - 1] + errors[i - 2]).norm() / mean);
  }
  return {rms(angles), rms(sizes), rms(noise), rms(torques)};
}

CheckResult checkScene(const HapticScene& scene, const VerifyOptions& options) {
  CheckResult result;
  result.name = "haptic." + scene.name;
  for (char& c : result.name)
    if (c == ' ') c = '_';
  result.what = "Haptic benchmark: " + scene.what + ". Voxels and points of 2 mm.";
  result.quantity = "measurement / its limit";
  result.reason =
      "Float and mixed: angle 0.5 deg, size 2 %, noise 0.2 %, torque 0.5 %, what points one voxel apart cost "
      "at "
      "rims and tips. Layered: 10 deg, 15 %, 8 %, 5 %, as layers err by half a voxel of one to six voxels' "
      "depth.";
  result.table.header = {"method", "force angle [deg, rms]", "force size [%, rms]", "force noise [%, rms]",
                         "torque [% of force times size, rms]"};
  Plot plot{"Size of the force, " + scene.name, "pose", "force / true force", false, false, {}};
  std::vector<double> parts;
  for (const Method& method : kMethods) {
    if (options.stop()) break;
    Signal signal = measure(scene, method, options.threads);
    if (method.law == query::ForceLaw::kThesis) {
      const double gain = gainOf(scene, signal);
      for (auto* values : {&signal.force, &signal.torque_a, &signal.torque_b})
        for (Vector3d& v : *values) v *= gain;
    }
    const Quality q = qualityOf(scene, signal),
                  limit = method.field == structure::FieldKind::kLayered ? kLayeredLimits : kFloatLimits;
    for (const double part : {q.angle_deg / limit.angle_deg, q.size_percent / limit.size_percent,
                              q.noise_percent / limit.noise_percent, q.torque_percent / limit.torque_percent})
      parts.push_back(part);
    result.table.rows.push_back({method.name, shortNumber(q.angle_deg), shortNumber(q.size_percent),
                                 shortNumber(q.noise_percent), shortNumber(q.torque_percent)});
    Series series{method.name, {}, {}};
    for (std::size_t i = 0; i < scene.path.size(); ++i) {
      series.x.push_back(static_cast<double>(i));
      series.y.push_back(signal.force[i].norm() / (kBenchmarkStiffness * scene.path[i].force_a.norm()));
    }
    plot.series.push_back(std::move(series));
  }
  judge(result, parts, 1.0);
  result.poses = scene.path.size() * kMethods.size();
  result.passed = result.passed && parts.size() == 4 * kMethods.size();
  result.plots.push_back(std::move(plot));
  return result;
}

}  // namespace

std::vector<CheckResult> checkHapticBenchmark(const VerifyOptions& options) {
  std::vector<CheckResult> results;
  for (const HapticScene& scene : hapticScenes()) results.push_back(checkScene(scene, options));
  return results;
}

}  // namespace abstand::verify
