#include "app/run/csv_outputs.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/scene/directed_uncertainty.hpp"

namespace abstand::run {
namespace {

/// `,value`: fewest digits that read back to the same double, independent of the locale.
void addNumber(std::string& line, double value) {
  char buffer[32];
  const auto r = std::to_chars(buffer, buffer + sizeof buffer, value);
  line += ',';
  line.append(buffer, r.ptr);
}

void addVector(std::string& line, const Vector3d& v) {
  for (int i = 0; i < 3; ++i) addNumber(line, v[i]);
}

void startLine(std::string& line, double t) {
  line.clear();
  addNumber(line, t);
  line.erase(0, 1);
}

std::unique_ptr<OutputFile> open(const std::filesystem::path& file, const std::string& header) {
  if (file.empty()) return nullptr;
  auto out = std::make_unique<OutputFile>(file);
  out->stream() << header << '\n';
  return out;
}

/// Columns of reacting robots: plan, torque of the reaction, speed scale, state.
std::string loopHeader(const loop::ClosedLoop& loop) {
  std::string header;
  for (std::size_t m = 0; m < loop.robots().size(); ++m) {
    if (!loop.robots()[m]) continue;
    const std::string name = "," + loop.session().description().mechanisms[m].name + ".";
    for (const char* what : {"planned", "torque"})
      for (std::size_t j = 0; j < loop.robots()[m]->q().size(); ++j)
        header += name + what + std::to_string(j);
    header += name + "speed_scale" + name + "state";
  }
  return header;
}

std::string jointsHeader(const session::Session& session, const loop::ClosedLoop* loop) {
  std::string header = "t";
  for (const char* what : {"q", "effort"})
    for (std::size_t m = 0; m < session.mechanisms().size(); ++m)
      for (int j = 0; j < session.mechanisms()[m]->dof(); ++j)
        header += "," + session.description().mechanisms[m].name + "." + what + std::to_string(j);
  return loop ? header + loopHeader(*loop) : header;
}

}  // namespace

CsvOutputs::CsvOutputs(const CsvPaths& paths, const session::Session& session, const loop::ClosedLoop* loop,
                       bool live)
    : loop_(loop),
      live_(live),
      pairs_(open(paths.pairs, std::string("t,a,b,distance,bound,fx,fy,fz,tx,ty,tz,contacts,") +
                                   "ax,ay,az,bx,by,bz,reach" + (live ? ",age" : ""))),
      objects_(open(paths.objects,
                    "t,object,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz,fx,fy,fz,tx,ty,tz,colliding,reach")),
      joints_(open(paths.joints, jointsHeader(session, loop))),
      cycles_(open(paths.cycles, "cycle,t,work_us,colliding_pairs")),
      cycles_every_(paths.cycles_every) {}

void CsvOutputs::addCycle(double t, double worked, const std::vector<query::PairResult>& results) {
  if (!cycles_) return;
  const long number = cycle_count_++;
  if (number % cycles_every_ != 0) return;
  const auto colliding =
      std::count_if(results.begin(), results.end(), [](const auto& r) { return r.contacts > 0; });
  kept_.push_back({number, t, worked, colliding});
}

void CsvOutputs::write(double t, double shown, const session::Session& session,
                       const std::vector<query::PairResult>& results) {
  if (pairs_) writePairs(t, shown, session, results);
  if (objects_) writeObjects(t, session);
  if (joints_) writeJoints(t, session);
  if (cycles_) writeCycles();
}

void CsvOutputs::writePairs(double t, double shown, const session::Session& session,
                            const std::vector<query::PairResult>& results) {
  const scene::Scene& scene = session.scene();
  for (std::size_t i = 0; i < results.size(); ++i) {
    const scene::Pair& pair = scene.pairs()[i];
    const query::PairResult& r = results[i];
    startLine(line_, t);
    line_ += ',' + scene.object(pair.a).spec.name + ',' + scene.object(pair.b).spec.name;
    addNumber(line_, r.distance);
    addNumber(line_, r.bound);
    addVector(line_, r.force_a);
    addVector(line_, r.torque_a);
    line_ += ',' + std::to_string(r.contacts);
    addVector(line_, r.witness_a);
    addVector(line_, r.witness_b);
    const PairId id(static_cast<std::uint32_t>(i));
    addNumber(line_, scene::directedUncertainty(scene, id, r));
    if (live_) addNumber(line_, scene.ageOf(id, shown));
    line_ += '\n';
    pairs_->stream() << line_;
  }
}

void CsvOutputs::writeObjects(double t, const session::Session& session) {
  for (const scene::Object& o : session.scene().objects()) {
    const Quaterniond q(o.X_WB.linear());
    startLine(line_, t);
    line_ += ',' + o.spec.name;
    addVector(line_, o.X_WB.translation());
    addVector(line_, q.vec());
    addNumber(line_, q.w());
    addVector(line_, o.velocity.linear);
    addVector(line_, o.velocity.angular);
    addVector(line_, o.contact.force);
    addVector(line_, o.contact.torque);
    line_ += o.colliding ? ",1" : ",0";
    addNumber(line_, o.pose_uncertainty);
    line_ += '\n';
    objects_->stream() << line_;
  }
}

void CsvOutputs::writeJoints(double t, const session::Session& session) {
  startLine(line_, t);
  for (const auto& m : session.mechanisms())
    for (double q : m->q()) addNumber(line_, q);
  for (double effort : session.jointEfforts()) addNumber(line_, effort);
  if (loop_)
    for (const auto& robot : loop_->robots()) {
      if (!robot) continue;
      for (const double x : robot->planned()) addNumber(line_, x);
      for (const double x : robot->torque()) addNumber(line_, x);
      addNumber(line_, robot->speedScale());
      line_ += ',';
      line_ += safety::stateName(robot->stops().state());
    }
  line_ += '\n';
  joints_->stream() << line_;
}

void CsvOutputs::writeCycles() {
  for (const Cycle& cycle : kept_) {
    line_ = std::to_string(cycle.number);
    addNumber(line_, cycle.t);
    addNumber(line_, std::round(1e9 * cycle.worked) / 1e3);
    line_ += ',' + std::to_string(cycle.colliding) + '\n';
    cycles_->stream() << line_;
  }
  kept_.clear();
}

void CsvOutputs::finish() {
  if (cycles_) writeCycles();
  for (auto* file : {&pairs_, &objects_, &joints_, &cycles_})
    if (*file) (*file)->finish();
}

void CsvOutputs::commit() {
  for (auto* file : {&pairs_, &objects_, &joints_, &cycles_})
    if (*file) (*file)->commit();
}

}  // namespace abstand::run
