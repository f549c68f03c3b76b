#include "app/python/scene_columns.hpp"

#include <algorithm>
#include <cstring>

#include "core/base/error.hpp"

namespace abstand::python {
namespace {

using session::Session;
using Of = SceneColumn::Of;

template <class T>
void put(char* out, const T& value) {
  std::memcpy(out, &value, sizeof value);
}

void put(char* out, const Vector3d& v) { std::memcpy(out, v.data(), 3 * sizeof(double)); }

const scene::Pair& pairAt(const Session& s, std::size_t i) { return s.scene().pairs()[i]; }
const scene::Object& objectAt(const Session& s, std::size_t i) { return s.scene().objects()[i]; }
double uncertaintyOf(const Session& s, std::size_t i) {
  return s.scene().pairUncertainty(PairId(static_cast<std::uint32_t>(i)));
}
bool fresh(const Session& s, ObjectId id) {
  return s.scene().object(id).pose_state == scene::PoseState::kFresh;
}

double jointPosition(const Session& s, std::size_t i) {
  for (const auto& m : s.mechanisms()) {
    if (i < m->q().size()) return m->q()[i];
    i -= m->q().size();
  }
  return kNaN;
}

void putPose(char* out, const Transform& X) {
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) {
      put(out, X.matrix()(r, c));
      out += sizeof(double);
    }
}

SceneColumn number(const char* name, Of of, void (*store)(const Session&, std::size_t, char*)) {
  return {name, of, "f8", {}, sizeof(double), store};
}
SceneColumn vector(const char* name, Of of, void (*store)(const Session&, std::size_t, char*)) {
  return {name, of, "f8", {3}, 3 * sizeof(double), store};
}
SceneColumn flag(const char* name, Of of, void (*store)(const Session&, std::size_t, char*)) {
  return {name, of, "?", {}, 1, store};
}

void addPairColumns(std::vector<SceneColumn>& all) {
  constexpr Of kOf = Of::kPairs;
  using S = const Session&;
  all.push_back(
      number("distance", kOf, [](S s, std::size_t i, char* o) { put(o, pairAt(s, i).result.distance); }));
  all.push_back(number("bound", kOf, [](S s, std::size_t i, char* o) { put(o, pairAt(s, i).result.bound); }));
  all.push_back(number("reach", kOf, [](S s, std::size_t i, char* o) { put(o, uncertaintyOf(s, i)); }));
  all.push_back(number("at_least", kOf, [](S s, std::size_t i, char* o) {
    const query::PairResult& r = pairAt(s, i).result;
    put(o, r.distance - r.bound - uncertaintyOf(s, i));
  }));
  all.push_back(flag("fresh", kOf, [](S s, std::size_t i, char* o) {
    *o = fresh(s, pairAt(s, i).a) && fresh(s, pairAt(s, i).b) && !pairAt(s, i).paused;
  }));
  all.push_back(
      vector("point_a", kOf, [](S s, std::size_t i, char* o) { put(o, pairAt(s, i).result.witness_a); }));
  all.push_back(
      vector("point_b", kOf, [](S s, std::size_t i, char* o) { put(o, pairAt(s, i).result.witness_b); }));
  all.push_back(
      vector("force", kOf, [](S s, std::size_t i, char* o) { put(o, pairAt(s, i).result.force_a); }));
  all.push_back(
      vector("torque_a", kOf, [](S s, std::size_t i, char* o) { put(o, pairAt(s, i).result.torque_a); }));
  all.push_back(
      vector("torque_b", kOf, [](S s, std::size_t i, char* o) { put(o, pairAt(s, i).result.torque_b); }));
  all.push_back(number("depth", kOf, [](S s, std::size_t i, char* o) { put(o, pairAt(s, i).result.depth); }));
  all.push_back({"contacts", kOf, "i4", {}, sizeof(std::int32_t), [](S s, std::size_t i, char* o) {
                   put(o, static_cast<std::int32_t>(pairAt(s, i).result.contacts));
                 }});
}

void addObjectColumns(std::vector<SceneColumn>& all) {
  constexpr Of kOf = Of::kObjects;
  using S = const Session&;
  all.push_back({"X", kOf, "f8", {4, 4}, 16 * sizeof(double), [](S s, std::size_t i, char* o) {
                   putPose(o, objectAt(s, i).X_WB);
                 }});
  all.push_back({"pose_states", kOf, "u1", {}, 1, [](S s, std::size_t i, char* o) {
                   put(o, static_cast<std::uint8_t>(objectAt(s, i).pose_state));
                 }});
  all.push_back(number("object_reach", kOf,
                       [](S s, std::size_t i, char* o) { put(o, objectAt(s, i).pose_uncertainty); }));
  all.push_back(
      vector("object_force", kOf, [](S s, std::size_t i, char* o) { put(o, objectAt(s, i).contact.force); }));
  all.push_back(vector("object_torque", kOf,
                       [](S s, std::size_t i, char* o) { put(o, objectAt(s, i).contact.torque); }));
  all.push_back(flag("colliding", kOf, [](S s, std::size_t i, char* o) { *o = objectAt(s, i).colliding; }));
  all.push_back(number("joint_positions", Of::kJoints,
                       [](S s, std::size_t i, char* o) { put(o, jointPosition(s, i)); }));
  all.push_back(
      number("joint_efforts", Of::kJoints, [](S s, std::size_t i, char* o) { put(o, s.jointEfforts()[i]); }));
}

const SceneColumn& columnNamed(const std::string& name) {
  std::vector<std::string> known;
  for (const SceneColumn& c : sceneColumns()) {
    if (name == c.name) return c;
    known.emplace_back(c.name);
  }
  const std::string near = nearestName(name, known);
  throw UsageError("fields: found '" + name + "', expected names of StepResult's arrays" +
                   (near.empty() ? "" : " (did you mean '" + near + "'?)"));
}

}  // namespace

const std::vector<SceneColumn>& sceneColumns() {
  static const std::vector<SceneColumn> columns = [] {
    std::vector<SceneColumn> all;
    addPairColumns(all);
    addObjectColumns(all);
    return all;
  }();
  return columns;
}

std::size_t countOf(const Session& session, Of of) {
  switch (of) {
    case Of::kPairs:
      return session.scene().pairs().size();
    case Of::kObjects:
      return session.scene().objectCount();
    case Of::kJoints:
      return session.jointEfforts().size();
  }
  return 0;
}

SceneTable::SceneTable(const Session& session, const std::vector<std::string>& names,
                       std::optional<std::size_t> moments) {
  for (const std::string& name : names) {
    const SceneColumn& column = columnNamed(name);
    const std::size_t count = countOf(session, column.of);
    std::vector<py::ssize_t> shape;
    if (moments) shape.push_back(static_cast<py::ssize_t>(*moments));
    shape.push_back(static_cast<py::ssize_t>(count));
    shape.insert(shape.end(), column.item_shape.begin(), column.item_shape.end());
    py::array array(py::dtype(column.dtype), shape);
    char* data = static_cast<char*>(array.mutable_data());
    filled_.push_back({&column, std::move(array), data, count});
  }
}

void SceneTable::store(const Session& session, std::size_t moment) noexcept {
  for (const Filled& f : filled_) {
    char* out = f.data + moment * f.count * f.column->item_bytes;
    for (std::size_t i = 0; i < f.count; ++i, out += f.column->item_bytes) f.column->store(session, i, out);
  }
}

void SceneTable::giveTo(py::handle target) const {
  for (const Filled& f : filled_) target.attr(f.column->name) = f.array;
}

}  // namespace abstand::python
