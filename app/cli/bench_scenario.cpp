// abstand bench --scenario: one row of a peer benchmark's tables.
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <optional>
#include <set>
#include <thread>

#include "app/bench/scenario.hpp"
#include "app/cli/bench_scenario.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/parallel.hpp"
#include "core/base/standard_output.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "core/query/pair_set.hpp"
#include "core/scene/scene.hpp"

namespace abstand::cli {
namespace {

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Peak resident memory (VmHWM) of this process in MB.
double highWaterMb() {
  std::ifstream in("/proc/self/status");
  for (std::string word; in >> word;)
    if (word == "VmHWM:") {
      double kb = 0;
      in >> kb;
      return kb / 1024.0;
    }
  return 0.0;
}

/// Parses "hV" or "hVpP": V and P are the voxel size and the point spacing in mm.
structure::HapticOptions variantOptions(const std::string& variant) {
  double voxel = 0.0, point = 0.0;
  int read = 0;
  const bool named = variant == "h1" || variant == "h2" || variant == "h4";
  const bool both = std::sscanf(variant.c_str(), "h%lfp%lf%n", &voxel, &point, &read) == 2 &&
                    read == static_cast<int>(variant.size());
  // The negated form also rejects NaN.
  if (!named && !(both && voxel >= 0.1 && voxel <= 1000.0 && point >= 0.1 && point <= 1000.0))
    throw UsageError("--variant: found '" + variant +
                     "', expected h1, h2 or h4 (voxels of 1, 2 or 4 mm), or as h1p1.5, with points 1.5 mm "
                     "apart; with the suffix -rest and a share: temporal culling");
  structure::HapticOptions o;
  o.voxel_size = 1e-3 * (named ? variant[1] - '0' : voxel);
  o.point_spacing = variant == "h2" ? 0.003 : 1e-3 * (named ? variant[1] - '0' : point);
  return o;
}

/// Removes "-restS" from the name and returns the share (0 to 1) of QueryCulling::rest; 0 if absent.
double takeRest(std::string& variant) {
  const auto at = variant.find("-rest");
  if (at == std::string::npos) return 0.0;
  double share = 0.0;
  int read = 0;
  const std::string number = variant.substr(at + 5);
  const bool whole =
      std::sscanf(number.c_str(), "%lf%n", &share, &read) == 1 && read == static_cast<int>(number.size());
  if (!whole || !(share > 0.0 && share <= 1.0))
    throw UsageError("--variant: found '" + variant + "', expected a share above 0, at most 1 after '-rest'");
  variant.resize(at);
  return share;
}

using Structures = std::vector<std::shared_ptr<const structure::HapticStructure>>;

bool same(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b) {
  return a.vertices == b.vertices && a.triangles == b.triangles;
}

/// Bodies with equal meshes share one structure.
Structures build(const bench::Scenario& scenario, const structure::HapticOptions& options) {
  const std::size_t n = scenario.bodies.size();
  std::vector<geometry::TriangleMesh> meshes(n);
  parallelFor(0, n, [&](std::size_t i) {
    meshes[i] = mesh_file::loadMesh(scenario.bodies[i].mesh, scenario.bodies[i].scale).mesh;
  });
  std::vector<std::size_t> first(n), order;
  for (std::size_t i = 0; i < n; ++i) {
    const auto equal =
        std::find_if(order.begin(), order.end(), [&](std::size_t k) { return same(meshes[i], meshes[k]); });
    first[i] = equal != order.end() ? *equal : i;
    if (first[i] == i) order.push_back(i);
  }
  // Largest first, so that none is left over at the end.
  std::vector<double> area(n, 0.0);
  for (const std::size_t i : order) area[i] = geometry::surfaceArea(meshes[i]);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t k) { return area[i] > area[k]; });
  const int each = std::max(1, static_cast<int>(std::thread::hardware_concurrency() / order.size()));
  Structures structures(n);
  parallelFor(0, order.size(), [&](std::size_t k) {
    const std::size_t i = order[k];
    structures[i] = structure::buildHapticStructure(
        scenario.bodies[i].name, geometry::makeSurface(std::move(meshes[i])), options, each);
  });
  for (std::size_t i = 0; i < n; ++i) structures[i] = structures[first[i]];
  return structures;
}

double structuresMb(const Structures& structures) {
  std::set<const structure::HapticStructure*> distinct;
  double bytes = 0.0;
  for (const auto& structure : structures)
    if (distinct.insert(structure.get()).second) bytes += static_cast<double>(structure->memoryBytes());
  return bytes / 1e6;
}

query::PairSet makePairs(const bench::Scenario& scenario, const Structures& structures) {
  std::vector<const structure::HapticStructure*> bodies;
  for (const auto& structure : structures) bodies.push_back(structure.get());
  std::vector<query::PairSet::Bodies> pairs;
  for (const auto& [a, b] : scenario.pairs)
    pairs.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
  return query::PairSet(std::move(bodies), std::move(pairs));
}

/// The harness's value for: not computed.
constexpr float kNotComputed = 1e9f;

/// Queries one frame in the way of a mode: the values that the harness needs of each pair.
using Ask = std::function<void(std::span<const Transform>)>;

Ask asker(const std::string& mode, query::PairSet& pairs, std::vector<float>& answers) {
  if (mode == "distance" || mode == "both")
    return [&pairs, &answers, results = std::vector<query::PairResult>(pairs.size())](auto X_WB) mutable {
      pairs.distances(X_WB, {}, results);
      for (std::size_t i = 0; i < results.size(); ++i) answers[i] = static_cast<float>(results[i].distance);
    };
  if (mode == "dmin")
    return [&pairs, &answers](auto X_WB) {
      std::fill(answers.begin(), answers.end(), kNotComputed);
      const query::PairSet::Nearest& nearest = pairs.nearest(X_WB, {});
      answers[nearest.pair] = static_cast<float>(nearest.result.distance);
    };
  const bool depth = mode == "contact";
  return [&pairs, &answers, depth](auto X_WB) {
    std::fill(answers.begin(), answers.end(), 0.0f);
    for (const query::PairSet::Touch& touch : pairs.contacts(X_WB, {}))
      answers[touch.pair] = depth ? static_cast<float>(touch.penalty.depth) : 1.0f;
  };
}

/// A scene with warm starts and temporal culling, as in users' scenes.
scene::Scene makeScene(const bench::Scenario& scenario, const Structures& structures, double rest) {
  scene::Scene scene;
  std::vector<ObjectId> ids;
  for (std::size_t i = 0; i < structures.size(); ++i)
    ids.push_back(scene.addObject({scenario.bodies[i].name, "objects", structures[i]}));
  for (const auto& [a, b] : scenario.pairs)
    scene.addPair(ids[static_cast<std::size_t>(a)], ids[static_cast<std::size_t>(b)]);
  scene.setThreads(1);
  scene.setCulling({.rest = rest, .remember = true});
  return scene;
}

Ask resting(scene::Scene& scene, double dt, std::vector<float>& answers) {
  return [&scene, &answers, dt, t = 0.0](auto X_WB) mutable {
    for (std::size_t i = 0; i < X_WB.size(); ++i)
      scene.setPose(ObjectId(static_cast<std::uint32_t>(i)), X_WB[i], t);
    t += dt;
    scene.step();
    for (std::size_t i = 0; i < answers.size(); ++i)
      answers[i] = static_cast<float>(scene.pairs()[i].result.distance);
  };
}

auto isTouching(const std::string& mode) {
  const bool distance = mode == "distance" || mode == "both" || mode == "dmin";
  return [distance](float value) { return distance ? value <= 0.0f : value > 0.0f; };
}

nlohmann::ordered_json statistics(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  double sum = 0.0;
  for (double s : seconds) sum += s;
  const auto us = [](double s) { return std::round(s * 1e9) / 1e3; };
  const std::size_t n = seconds.size();
  return {{"median", us(seconds[n / 2])},
          {"p99", us(seconds[std::min(n - 1, n * 99 / 100)])},
          {"max", us(seconds[n - 1])},
          {"min", us(seconds[0])},
          {"mean", us(sum / static_cast<double>(n))}};
}

void writeDump(std::ostream& out, const std::vector<std::int32_t>& frames, std::size_t pairs,
               const std::vector<float>& values) {
  const std::int32_t head[2] = {static_cast<std::int32_t>(frames.size()), static_cast<std::int32_t>(pairs)};
  out.write(reinterpret_cast<const char*>(head), sizeof head);
  out.write(reinterpret_cast<const char*>(frames.data()),
            static_cast<std::streamsize>(frames.size() * sizeof(std::int32_t)));
  out.write(reinterpret_cast<const char*>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(float)));
}

}  // namespace

int benchScenario(const BenchScenario& args) {
  const bench::Scenario scenario = bench::loadScenario(args.scenario);
  const double before = highWaterMb();
  const auto build_begin = Clock::now();
  std::string variant = args.variant;
  const double rest = takeRest(variant);
  if (rest > 0.0 && args.mode != "distance" && args.mode != "both")
    throw UsageError("--variant: found '" + args.variant + "', expected -rest with --mode distance or both");
  const Structures structures = build(scenario, variantOptions(variant));
  const double build_s = secondsSince(build_begin);

  std::optional<query::PairSet> pairs;
  std::optional<scene::Scene> scene;
  std::vector<float> answers(scenario.pairs.size());
  const Ask ask = rest > 0.0
                      ? resting(scene.emplace(makeScene(scenario, structures, rest)), scenario.dt, answers)
                      : asker(args.mode, pairs.emplace(makePairs(scenario, structures)), answers);
  const auto frame = [&](std::size_t f) { ask({scenario.frame(f), scenario.bodies.size()}); };
  std::vector<double> times;
  std::vector<std::int32_t> frames;
  std::vector<float> values;
  double spent = 0.0;
  std::size_t touching = 0;
  for (std::size_t f = static_cast<std::size_t>(args.start); f < scenario.frames() && spent <= args.budget;
       ++f) {
    if ((static_cast<int>(f) - args.start) % args.period >= args.block) continue;
    if (times.empty()) frame(f);  // one frame without timing
    const auto begin = Clock::now();
    frame(f);
    times.push_back(secondsSince(begin));
    spent += times.back();
    frames.push_back(static_cast<std::int32_t>(f));
    values.insert(values.end(), answers.begin(), answers.end());
    touching +=
        static_cast<std::size_t>(std::count_if(answers.begin(), answers.end(), isTouching(args.mode)));
    if (interrupted()) return kInterrupted;
  }
  if (times.empty()) throw UsageError("no frame of the scenario was chosen");
  std::optional<OutputFile> dump;
  if (!args.dump.empty()) {
    writeDump(dump.emplace(args.dump).stream(), frames, scenario.pairs.size(), values);
    dump->finish();
  }
  const nlohmann::ordered_json row{
      {"peer", "abstand"},
      {"variant", args.variant},
      {"scenario", scenario.name},
      {"mode", args.mode},
      {"frames", times.size()},
      {"pairs", scenario.pairs.size()},
      {"build_s", build_s},
      {"us", statistics(times)},
      {"structures_mb", structuresMb(structures)},
      {"hwm_mb", highWaterMb()},
      {"hwm_before_build_mb", before},
      {"touching_per_frame", static_cast<double>(touching) / static_cast<double>(times.size())}};
  if (!args.out.empty()) appendToFile(args.out, row.dump() + "\n");
  if (dump) dump->commit();
  if (!isStandardOutputClaimed()) writeStandardOutput(row.dump() + "\n");
  return kDone;
}

}  // namespace abstand::cli
