#include "app/run/session_log.hpp"

#include "app/session/input_content.hpp"

namespace abstand::run {
namespace {

constexpr double kPointStep = 1e-6;  // m
constexpr const char* kForceColumns = "fx fy fz tx ty tz";
constexpr const char* kTwistColumns = "vx vy vz wx wy wz";
constexpr const char* kTwistUnit = "m/s, rad/s";

/// "0123...  scene.yaml" of each input file.
std::vector<std::string> inputsOf(const scene_file::SceneDescription& scene) {
  std::vector<std::string> lines;
  for (const std::filesystem::path& file : session::inputFiles(scene)) {
    ContentHash hash;
    session::addContent(hash, file);
    lines.push_back(hash.value().hex() + "  " + file.string());
  }
  return lines;
}

}  // namespace

SessionLog::SessionLog(const std::filesystem::path& file, const session::Session& session, bool live,
                       const std::string& program)
    : out_(file) {
  const scene::Scene& scene = session.scene();
  const std::size_t pairs = scene.pairs().size(), objects = scene.objectCount(),
                    joints = session.jointEfforts().size();
  out_.attribute("abstand", kFormat);
  out_.attribute("version", program);
  const scene::QueryCulling& culling = session.description().culling;
  out_.attribute("warm_start", culling.remember ? 1LL : 0LL);
  out_.attribute("far_tolerance", culling.remember ? culling.far_tolerance : 0.0);
  std::vector<std::string> names;
  for (const scene::Object& o : scene.objects()) names.push_back(o.spec.name);
  out_.texts("objects", names);
  if (const auto inputs = inputsOf(session.description()); !inputs.empty()) out_.texts("inputs", inputs);
  std::vector<int> indices;
  for (const scene::Pair& p : scene.pairs()) {
    indices.push_back(static_cast<int>(p.a.index()));
    indices.push_back(static_cast<int>(p.b.index()));
  }
  out_.integers("pairs", indices, 2);
  const auto table = [this](const char* name, std::vector<std::size_t> row, const char* unit,
                            const char* columns = "", hdf5::Storage storage = hdf5::Storage::kDouble,
                            double step = 1.0) {
    const std::size_t number = out_.table(name, std::move(row), storage, step);
    out_.describe(number, unit, columns);
    return number;
  };
  using hdf5::Storage;
  t_ = table("t", {}, "s");
  pair_.distance = table("distance", {pairs}, "m");
  pair_.bound = table("bound", {pairs}, "m");
  pair_.force = table("force", {pairs, 3}, "N", "fx fy fz");
  pair_.torque = table("torque", {pairs, 6}, "N m", "ax ay az bx by bz");
  pair_.points = table("points", {pairs, 6}, "m", "ax ay az bx by bz", Storage::kSteps32, kPointStep);
  pair_.contacts = table("contacts", {pairs}, "1", "", Storage::kSteps32);
  object_.pose = table("pose", {objects, 7}, "m, 1", "x y z qw qx qy qz");
  object_.velocity = table("velocity", {objects, 6}, kTwistUnit, kTwistColumns);
  object_.mean_velocity = table("mean_velocity", {objects, 6}, kTwistUnit, kTwistColumns);
  object_.uncertainty = table("reach", {objects}, "m");
  object_.state = table("pose_state", {objects}, "1", "", Storage::kSteps16);
  object_.contact_force = table("contact_force", {objects, 6}, "N, N m", kForceColumns);
  object_.contacts = table("object_contacts", {objects}, "1", "", Storage::kSteps32);
  q_ = table("q", {joints}, "rad or m");
  effort_ = table("effort", {joints}, "N m or N");
  if (live) age_ = table("age", {pairs}, "s");
}

void SessionLog::write(double t, double shown, const session::Session& session,
                       const std::vector<query::PairResult>& results) {
  out_.add(t_, t);
  if (age_)
    for (std::uint32_t i = 0; i < results.size(); ++i)
      out_.add(*age_, session.scene().ageOf(PairId(i), shown));
  writePairs(results);
  writeObjects(session.scene());
  for (const auto& m : session.mechanisms()) out_.add(q_, m->q());
  out_.add(effort_, session.jointEfforts());
  out_.endRow();
}

void SessionLog::writePairs(const std::vector<query::PairResult>& results) {
  for (const query::PairResult& r : results) {
    out_.add(pair_.distance, r.distance);
    out_.add(pair_.bound, r.bound);
    const bool near = r.distance < kPointsWithin;
    for (const Vector3d* v : {&r.witness_a, &r.witness_b})
      for (int i = 0; i < 3; ++i) out_.add(pair_.points, near ? (*v)[i] : kNaN);
    for (int i = 0; i < 3; ++i) out_.add(pair_.force, r.force_a[i]);
    for (const Vector3d* v : {&r.torque_a, &r.torque_b})
      for (int i = 0; i < 3; ++i) out_.add(pair_.torque, (*v)[i]);
    out_.add(pair_.contacts, r.contacts);
  }
}

void SessionLog::writeObjects(const scene::Scene& scene) {
  const auto add = [this](std::size_t table, const Vector3d& a, const Vector3d& b) {
    for (const Vector3d* v : {&a, &b})
      for (int i = 0; i < 3; ++i) out_.add(table, (*v)[i]);
  };
  for (const scene::Object& o : scene.objects()) {
    const Eigen::Quaterniond q(o.X_WB.linear());
    for (int i = 0; i < 3; ++i) out_.add(object_.pose, o.X_WB.translation()[i]);
    for (const double v : {q.w(), q.x(), q.y(), q.z()}) out_.add(object_.pose, v);
    add(object_.velocity, o.velocity.linear, o.velocity.angular);
    add(object_.mean_velocity, o.mean_velocity.linear, o.mean_velocity.angular);
    out_.add(object_.uncertainty, o.pose_uncertainty);
    out_.add(object_.state, static_cast<double>(o.pose_state));
    add(object_.contact_force, o.contact.force, o.contact.torque);
    out_.add(object_.contacts, o.contacts);
  }
}

void SessionLog::finish() { out_.finish(); }

void SessionLog::commit() { out_.commit(); }

}  // namespace abstand::run
