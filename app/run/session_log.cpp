#include "app/run/session_log.hpp"

namespace abstand::run {
namespace {

constexpr long long kFormat = 1;

}  // namespace

SessionLog::SessionLog(const std::filesystem::path& file, const session::Session& session, bool live)
    : out_(file, false) {
  const scene::Scene& scene = session.scene();
  const std::size_t pairs = scene.pairs().size(), joints = session.jointEfforts().size();
  out_.attribute("abstand", kFormat);
  std::vector<std::string> names;
  for (const scene::Object& o : scene.objects()) names.push_back(o.spec.name);
  out_.texts("objects", names);
  std::vector<int> indices;
  for (const scene::Pair& p : scene.pairs()) {
    indices.push_back(static_cast<int>(p.a.index()));
    indices.push_back(static_cast<int>(p.b.index()));
  }
  out_.integers("pairs", indices, 2);
  t_ = out_.table("t", {});
  distance_ = out_.table("distance", {pairs});
  bound_ = out_.table("bound", {pairs});
  force_ = out_.table("force", {pairs, 3});
  pose_uncertainty_ = out_.table("reach", {scene.objectCount()});
  q_ = out_.table("q", {joints});
  effort_ = out_.table("effort", {joints});
  if (live) age_ = out_.table("age", {pairs});
}

void SessionLog::write(double t, double shown, const session::Session& session,
                       const std::vector<query::PairResult>& results) {
  out_.add(t_, t);
  if (age_)
    for (std::uint32_t i = 0; i < results.size(); ++i)
      out_.add(*age_, session.scene().ageOf(PairId(i), shown));
  for (const auto& r : results) {
    out_.add(distance_, r.distance);
    out_.add(bound_, r.bound);
    for (int i = 0; i < 3; ++i) out_.add(force_, r.force_a[i]);
  }
  for (const scene::Object& o : session.scene().objects()) out_.add(pose_uncertainty_, o.pose_uncertainty);
  for (const auto& m : session.mechanisms()) out_.add(q_, m->q());
  out_.add(effort_, session.jointEfforts());
  out_.endRow();
}

void SessionLog::finish() { out_.finish(); }

void SessionLog::commit() { out_.commit(); }

}  // namespace abstand::run
