// abstand.distance, contact, distances, contacts.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/python/bodies.hpp"
#include "app/python/interrupt_check.hpp"
#include "app/python/pose_rows.hpp"
#include "app/python/query_results.hpp"
#include "core/base/error.hpp"
#include "core/base/parallel.hpp"

namespace abstand::python {
namespace {

/// Poses of a batch that one thread processes in a row. A warm batch starts each block cold, so results do
/// not depend on the threads.
constexpr std::size_t kBlock = 128;
constexpr int kMaxThreads = 256;

/// Options of a query that starts warm or cold.
query::PairOptions distanceOptions(double tolerance, bool warm) {
  if (!(tolerance >= 0.0 && tolerance <= query::kMaxFarTolerance))
    throw UsageError("tolerance: expected a share from 0 to 0.1");
  query::PairOptions options;
  if (warm) options.far_share = query::farShareOf(tolerance);
  return options;
}

query::PairOptions contactOptions(double margin, double stiffness, const std::string& law,
                                  query::PairOptions options) {
  if (!(margin >= 0.0 && std::isfinite(margin))) throw UsageError("margin: expected metres, 0 or more");
  if (!(stiffness >= 0.0 && std::isfinite(stiffness)))
    throw UsageError("stiffness: expected a number, 0 or more");
  if (law != "volume" && law != "thesis")
    throw UsageError("law: found '" + law + "', expected volume or thesis");
  options.margin = margin;
  options.stiffness = stiffness;
  options.law = law == "volume" ? query::ForceLaw::kVolume : query::ForceLaw::kThesis;
  return options;
}

/// Two structures, their poses and the options of their queries.
struct PairArguments {
  const Structure &a, &b;
  const py::object &X_a, &X_b;
  query::PairOptions options;
};

void ask(const PairArguments& pair, Memory* memory, query::PairResult& result) {
  thread_local kernels::PairScratch scratch;
  const Structure &a = pair.a, &b = pair.b;
  const Transform X_WA = PoseRows(pair.X_a, "X_a").only(), X_WB = PoseRows(pair.X_b, "X_b").only();
  if (memory == nullptr) {
    query::queryPair({*a.haptic, X_WA}, {*b.haptic, X_WB}, pair.options, scratch, result);
    return;
  }
  if (!memory->a) {
    memory->a = a.haptic;
    memory->b = b.haptic;
  }
  if (memory->a != a.haptic || memory->b != b.haptic)
    throw UsageError("memory: found that of another pair of structures, expected one of its own for a pair");
  query::queryPair({*a.haptic, X_WA}, {*b.haptic, X_WB}, pair.options, {memory->memory, scratch}, result);
}

struct BatchArguments {
  int threads;
  bool warm;
  py::object out;  ///< arrays to write to, or None
};

/// Queries all poses, in blocks that are distributed over threads.
void askAll(const PairArguments& pair, const PoseRows& X_a, const PoseRows& X_b, const BatchArguments& args,
            const ResultColumns& out) {
  const structure::HapticStructure &a = *pair.a.haptic, &b = *pair.b.haptic;
  const std::size_t n = commonSize(X_a, X_b);
  const query::PairOptions& options = pair.options;
  const py::gil_scoped_release release;
  X_a.check();
  X_b.check();
  InterruptCheck interrupt;
  parallelFor(args.threads, (n + kBlock - 1) / kBlock, [&](std::size_t block) {
    interrupt.poll();
    kernels::PairScratch scratch;
    query::PairMemory memory;
    query::PairResult result;
    const std::size_t end = std::min(n, (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < end; ++i) {
      if (args.warm)
        query::queryPair({a, X_a[i]}, {b, X_b[i]}, options, {memory, scratch}, result);
      else
        query::queryPair({a, X_a[i]}, {b, X_b[i]}, options, scratch, result);
      out.store(i, result);
    }
  });
}

/// Time (s) of a plain C++ loop over the same queries, without Python: reference for
/// tests/bench/python_overhead.py.
double loopSeconds(const Structure& a, const Structure& b, const py::object& X_a, const py::object& X_b,
                   bool warm) {
  const PoseRows rows_a(X_a, "X_a"), rows_b(X_b, "X_b");
  std::vector<Transform> poses_a, poses_b;
  for (std::size_t i = 0; i < commonSize(rows_a, rows_b); ++i) {
    poses_a.push_back(rows_a[i]);
    poses_b.push_back(rows_b[i]);
  }
  std::vector<query::PairResult> results(poses_a.size());
  const query::PairOptions options = distanceOptions(query::kFarTolerance, warm);
  kernels::PairScratch scratch;
  query::PairMemory memory;
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (i % kBlock == 0) memory = {};
    if (warm)
      query::queryPair({*a.haptic, poses_a[i]}, {*b.haptic, poses_b[i]}, options, {memory, scratch},
                       results[i]);
    else
      query::queryPair({*a.haptic, poses_a[i]}, {*b.haptic, poses_b[i]}, options, scratch, results[i]);
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The arrays to write to: those of `given`, or new ones.
template <class Results>
py::object resultsFor(std::size_t n, py::object given) {
  if (given.is_none()) return py::cast(new Results(n), py::return_value_policy::take_ownership);
  const std::size_t size = py::cast<const Results&>(given).size;
  if (size != n)
    throw UsageError("out: found room for " + std::to_string(size) + " poses, expected " + std::to_string(n));
  return given;
}

template <class Results>
py::object batch(const PairArguments& pair, const BatchArguments& args) {
  if (args.threads < 0 || args.threads > kMaxThreads)
    throw UsageError("threads: found " + std::to_string(args.threads) + ", expected 0 to " +
                     std::to_string(kMaxThreads));
  const PoseRows rows_a(pair.X_a, "X_a"), rows_b(pair.X_b, "X_b");
  py::object out = resultsFor<Results>(commonSize(rows_a, rows_b), args.out);
  askAll(pair, rows_a, rows_b, args, ResultColumns(py::cast<Results&>(out)));
  return out;
}

constexpr const char* kDistanceDoc = R"doc(Distance of the structures a and b at the poses X_a and X_b.

X_a, X_b: (4, 4), X_WB takes points of the body B into the world W, metres; None: the identity. memory: a Memory of this pair,
for a warm start, which is faster and never weakens `bound`. tolerance: 0 to 0.1; with a warm start, a distance beyond 0.1 m may
exceed the smallest one by this share, which `bound` includes. Without a memory, the result depends only on the arguments.

UsageError (a ValueError) for a matrix that is no rigid transform. Takes microseconds and keeps the GIL.)doc";

constexpr const char* kContactDoc = R"doc(Distance, and penalty force and torques, of a and b.

margin: m, the sum of both bodies' safety margins. law 'volume': force = stiffness (N/m^3) times the overlapping volume;
'thesis': unweighted points, stiffness in N/m. The force acts on A, the opposite one on B. Everything else as in distance().)doc";

constexpr const char* kDistancesDoc = R"doc(Distances of the structures a and b at n poses, as arrays.

X_a, X_b: (n, 4, 4), or (4, 4) for a body that stays where it is; None: the identity. Arrays of float64 are read where they are,
whatever their strides; they must not change meanwhile. threads: 0 is all cores; the bits do not depend on it. warm: each query
starts from the result before it, in blocks of 128 that begin cold, for poses that follow each other closely; tolerance: of warm
starts, as in distance(). out: Distances(n) to be written into, and returned.

UsageError (a ValueError) names the first row that is no rigid transform, before anything is computed. Releases the GIL; Ctrl-C
ends it.)doc";

constexpr const char* kContactsDoc =
    "Distances and contacts of a and b at n poses, as arrays; see contact() and distances().";

}  // namespace

void bindQueries(py::module_& module) {
  bindResults(module);
  module.def("_loop_seconds", &loopSeconds);
  py::class_<Memory>(module, "Memory", R"doc(What a pair of structures remembers from one query to the next.

It belongs to the first pair that it is used with. One thread at a time.)doc")
      .def(py::init<>())
      .def(
          "clear", [](Memory& m) { m = Memory(); }, "Discards all data, including the pair.");
  using namespace py::literals;
  module.def(
      "distance",
      [](const Structure& a, const Structure& b, const py::object& X_a, const py::object& X_b, Memory* memory,
         double tolerance) {
        Distance d;
        ask({a, b, X_a, X_b, distanceOptions(tolerance, memory != nullptr)}, memory, d.result);
        return d;
      },
      "a"_a, "b"_a, "X_a"_a = py::none(), "X_b"_a = py::none(), "memory"_a = py::none(),
      "tolerance"_a = query::kFarTolerance, kDistanceDoc);
  module.def(
      "contact",
      [](const Structure& a, const Structure& b, const py::object& X_a, const py::object& X_b, double margin,
         double stiffness, const std::string& law, Memory* memory, double tolerance) {
        const query::PairOptions options = distanceOptions(tolerance, memory != nullptr);
        Contact c;
        ask({a, b, X_a, X_b, contactOptions(margin, stiffness, law, options)}, memory, c.result);
        return c;
      },
      "a"_a, "b"_a, "X_a"_a = py::none(), "X_b"_a = py::none(), "margin"_a = 0.0, "stiffness"_a = 1.0e6,
      "law"_a = "volume", "memory"_a = py::none(), "tolerance"_a = query::kFarTolerance, kContactDoc);
  module.def(
      "distances",
      [](const Structure& a, const Structure& b, const py::object& X_a, const py::object& X_b, int threads,
         bool warm, py::object out, double tolerance) {
        return batch<Distances>({a, b, X_a, X_b, distanceOptions(tolerance, warm)},
                                {threads, warm, std::move(out)});
      },
      "a"_a, "b"_a, "X_a"_a = py::none(), "X_b"_a = py::none(), "threads"_a = 1, "warm"_a = false,
      "out"_a = py::none(), "tolerance"_a = query::kFarTolerance, kDistancesDoc);
  module.def(
      "contacts",
      [](const Structure& a, const Structure& b, const py::object& X_a, const py::object& X_b, double margin,
         double stiffness, const std::string& law, int threads, bool warm, py::object out, double tolerance) {
        const query::PairOptions options = distanceOptions(tolerance, warm);
        return batch<Contacts>({a, b, X_a, X_b, contactOptions(margin, stiffness, law, options)},
                               {threads, warm, std::move(out)});
      },
      "a"_a, "b"_a, "X_a"_a = py::none(), "X_b"_a = py::none(), "margin"_a = 0.0, "stiffness"_a = 1.0e6,
      "law"_a = "volume", "threads"_a = 1, "warm"_a = false, "out"_a = py::none(),
      "tolerance"_a = query::kFarTolerance, kContactsDoc);
}

}  // namespace abstand::python
