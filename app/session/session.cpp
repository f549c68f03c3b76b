#include "app/session/session.hpp"

#include <algorithm>

#include "app/scene_file/pair_selection.hpp"
#include "core/base/error.hpp"
#include "core/base/message_line.hpp"

namespace abstand::session {
namespace {

constexpr double kMotionRate = 1000.0;  // Hz, if only joint motion determines the frames

// s, duration of a scene without recordings in which objects fall.
constexpr double kFallTime = 5.0;

bool somethingFalls(const scene_file::SceneDescription& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [](const scene_file::ObjectDescription& o) { return o.mass.has_value(); });
}

std::string fileName(const std::filesystem::path& p) { return p.filename().string(); }

}  // namespace

Session::Session(scene_file::SceneDescription description, const SessionOptions& options)
    : description_(std::move(description)),
      library_(options.cache ? store::userCacheFolder() : std::filesystem::path()),
      remarks_(description_.remarks) {
  if (!options.recording.empty() && description_.humans.empty())
    throw UsageError(description_.file.string() + ": found no person whom " + options.recording.string() +
                     " could move, expected a scene with `humans`");
  for (auto& human : description_.humans) {
    if (!options.recording.empty()) human.recording.file = options.recording;
    human.recording.speed *= options.person_speed;
    if (options.cut_things) human.recording.cut_things = options.cut_things;
  }

  // Reads everything that can fail because of invalid files before expensive builds.
  std::vector<Planned> plan;
  planMechanisms(plan, options);
  planHumans(plan, options);
  planObjects(plan, options);
  if (!options.poses.empty()) poses_ = loadPoses(options.poses);
  scene::QueryCulling& culling = description_.culling;
  culling.rest = options.rest.value_or(culling.rest);
  culling.horizon = options.horizon.value_or(culling.horizon);
  culling.budget = options.budget.value_or(culling.budget);
  culling.remember = options.remember.value_or(culling.remember);
  culling.far_tolerance = options.far_tolerance.value_or(culling.far_tolerance);
  scene_.setCulling(culling);
  if (options.planned) options.planned(library_.size());
  library_.build(0, options.monitor);

  for (auto& body : plan)
    body.placed(scene_.addObject({body.name, body.group, library_.get(body.key), body.margin}));
  selectAndAddPairs();
  if (poses_) bindPoses(options.poses);
  setSpeeds(plan);
  for (const auto& remark : library_.remarks()) remarks_.push_back(remark);
  pair_groups_ = makePairGroups(scene_, description_.threads, remarks_);
  // Remarks quote untrusted files.
  for (std::string& remark : remarks_) remark = messageLine(remark);

  std::size_t dof = 0;
  for (const auto& m : mechanisms_) dof += static_cast<std::size_t>(m->dof());
  joint_efforts_.assign(dof, 0.0);
  scene_.setForceLaw(description_.defaults.thesis_law ? query::ForceLaw::kThesis : query::ForceLaw::kVolume,
                     description_.defaults.stiffness);
  scene_.setThreads(options.threads);
}

structure::HapticOptions Session::hapticOptions(const scene_file::BodySettings& settings) const {
  structure::HapticOptions o = description_.defaults.haptic;
  o.voxel_size = settings.voxel.value_or(o.voxel_size);
  o.point_spacing = settings.point.value_or(o.point_spacing);
  o.outer_layers = settings.outer_layers.value_or(o.outer_layers);
  return o;
}

/// For a link or an object.
template <class Body>
StructureLibrary::Key Session::request(const Body& body, const structure::HapticOptions& options) {
  if (!body.structure.empty()) return library_.requestStored(body.structure);
  if (body.shape) return library_.request(*body.shape, options);
  return library_.request(body.mesh, body.scale, options);
}

void Session::planMechanisms(std::vector<Planned>& plan, const SessionOptions& options) {
  for (const auto& d : description_.mechanisms) {
    mechanisms_.push_back(std::make_unique<MechanismDriver>(d));
    MechanismDriver* driver = mechanisms_.back().get();
    const int first = static_cast<int>(plan.size());
    for (std::size_t i = 0; i < d.links.size(); ++i) {
      const auto& link = d.links[i];
      scene_file::BodySettings settings = link.settings;
      settings.fillFrom(d.settings);
      const auto made = options.made.find(link.name);
      const auto key =
          made != options.made.end() ? library_.take(made->second) : request(link, hapticOptions(settings));
      plan.push_back({link.name, d.name, key, settings.margin.value_or(description_.defaults.margin),
                      settings.max_speed, driver->motion() ? kInfinity : 0.0,
                      [driver, i](ObjectId id) { driver->bind(i, id); }});
    }
    for (const auto& [a, b] : driver->adjacentLinks())
      adjacent_.emplace_back(first + static_cast<int>(a), first + static_cast<int>(b));
  }
}

void Session::planHumans(std::vector<Planned>& plan, const SessionOptions& options) {
  for (const auto& d : description_.humans) {
    std::shared_ptr<const tracking::FittedClip> fitted;
    tracking::TrackMonitor monitor{options.tracked, options.monitor.cancelled, {}};
    if (options.keep_fits) monitor.fitted = [&fitted](auto clip) { fitted = std::move(clip); };
    humans_.push_back(std::make_unique<HumanDriver>(d, options.known, monitor));
    humans_.back()->keepFitted(std::move(fitted));
    HumanDriver* driver = humans_.back().get();
    const int first = static_cast<int>(plan.size());
    for (const humanmodel::HumanPart& part : driver->model().parts) {
      const std::string part_name{humanmodel::partName(part.part)};
      scene_file::BodySettings settings;
      if (const auto own = d.parts.find(part.part); own != d.parts.end()) settings = own->second;
      settings.fillFrom(d.settings);
      const std::string name = d.name + "/" + part_name;
      const auto made = options.made.find(name);
      const auto key = made != options.made.end() ? library_.take(made->second)
                                                  : library_.request(part.shape, hapticOptions(settings));
      plan.push_back({name, d.name, key, settings.margin.value_or(description_.defaults.margin),
                      settings.max_speed, driver->recording() ? kHandSpeed : 0.0,
                      [driver, id = part.part](ObjectId object) { driver->bind(id, object); }});
    }
    for (const scene_file::ToolDescription& tool : d.tools) planTool(plan, options, d, tool, first);
    for (const auto& [a, b] : humanmodel::adjacentParts()) {
      const int i = first + static_cast<int>(a), j = first + static_cast<int>(b);
      adjacent_.emplace_back(std::min(i, j), std::max(i, j));
    }
    if (const tracking::Recording* r = driver->recording()) {
      const auto& report = r->report;
      const std::string stature =
          report.stature > 0.0 ? std::to_string(report.stature).substr(0, 4) + " m" : "not known";
      remarks_.push_back(fileName(d.recording.file) + ": read as " + report.units.name + ", " +
                         report.up.axis + " up, stature " + stature);
      for (const auto& note : report.notes) remarks_.push_back(fileName(d.recording.file) + ": " + note);
    }
  }
}

void Session::planTool(std::vector<Planned>& plan, const SessionOptions& options,
                       const scene_file::HumanDescription& d, const scene_file::ToolDescription& tool,
                       int first_part) {
  scene_file::BodySettings settings = tool.settings;
  if (const auto hand = d.parts.find(tool.hand); hand != d.parts.end()) settings.fillFrom(hand->second);
  settings.fillFrom(d.settings);
  // The tip of a tool may be faster than the hand.
  settings.max_speed = tool.settings.max_speed;
  const std::string name = tool.bodyName(d.name);
  const auto made = options.made.find(name);
  const auto key =
      made != options.made.end() ? library_.take(made->second) : request(tool, hapticOptions(settings));
  HumanDriver* driver = humans_.back().get();
  adjacent_.emplace_back(first_part + static_cast<int>(tool.hand), static_cast<int>(plan.size()));
  plan.push_back({name, d.name, key, settings.margin.value_or(description_.defaults.margin),
                  settings.max_speed, driver->recording() ? kInfinity : 0.0,
                  [this, driver, hand = tool.hand, X_HT = tool.X_HT](ObjectId id) {
                    const geometry::EnclosingSphere& sphere =
                        scene_.object(id).spec.structure->bounding_sphere;
                    driver->hold(hand, id, X_HT, (X_HT * sphere.centre).norm() + sphere.radius);
                  }});
}

void Session::planObjects(std::vector<Planned>& plan, const SessionOptions& options) {
  for (const auto& d : description_.objects) {
    const auto made = options.made.find(d.name);
    const auto key =
        made != options.made.end() ? library_.take(made->second) : request(d, hapticOptions(d.settings));
    plan.push_back({d.name, "objects", key, d.settings.margin.value_or(description_.defaults.margin),
                    d.settings.max_speed, d.mass ? kInfinity : 0.0,
                    [this, X_WB = d.X_WB](ObjectId id) { scene_.setPose(id, X_WB, 0.0); }});
  }
}

void Session::selectAndAddPairs() {
  std::vector<scene_file::SelectableBody> bodies;
  const auto is_person = [&](const std::string& group) {
    return std::any_of(description_.humans.begin(), description_.humans.end(),
                       [&](const scene_file::HumanDescription& h) { return h.name == group; });
  };
  for (const scene::Object& o : scene_.objects())
    bodies.push_back({o.spec.name, o.spec.group, is_person(o.spec.group)});
  for (const auto& [a, b] : scene_file::selectPairs(bodies, description_.pairs, adjacent_))
    scene_.addPair(ObjectId(static_cast<std::uint32_t>(a)), ObjectId(static_cast<std::uint32_t>(b)));
}

void Session::bindPoses(const std::filesystem::path& file) {
  for (const auto& name : poses_->names) {
    ObjectId id(0);
    if (!scene_.find(name, &id)) {
      std::vector<std::string> known;
      for (const scene::Object& o : scene_.objects()) known.push_back(o.spec.name);
      const std::string near = nearestName(name, known);
      throw ParseError({file.string(), 1},
                       "found '" + name + "', expected the name of an object of the scene",
                       near.empty() ? "" : "did you mean '" + near + "'?");
    }
    poses_objects_.push_back(id);
  }
}

/// The scene's objects are in the order of the plan.
void Session::setSpeeds(const std::vector<Planned>& plan) {
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const ObjectId id(static_cast<std::uint32_t>(i));
    if (plan[i].max_speed) {
      scene_.setMaxSpeed(id, *plan[i].max_speed);
    } else if (description_.culling.rest > 0.0 && !posed(id)) {
      scene_.setMaxSpeed(id, plan[i].usual_speed);
    }
  }
}

void Session::applyMotion(double t) {
  for (const auto& m : mechanisms_) m->apply(t, scene_);
  for (const auto& h : humans_) h->apply(t, scene_);
  applyPoses(t);
}

void Session::applyPoses(double t) {
  if (!poses_) return;
  const std::size_t row = poses_->rowAt(t);
  for (std::size_t i = 0; i < poses_objects_.size(); ++i) {
    scene_.setPose(poses_objects_[i], poses_->pose(row, i), t);
    scene_.setPoseUncertainty(poses_objects_[i], 0.0);
  }
}

bool Session::posed(ObjectId id) const {
  return std::find(poses_objects_.begin(), poses_objects_.end(), id) != poses_objects_.end();
}

bool Session::reacts() const {
  return std::any_of(description_.mechanisms.begin(), description_.mechanisms.end(),
                     [](const scene_file::MechanismDescription& m) { return m.reaction.has_value(); }) ||
         somethingFalls(description_);
}

void Session::step(double t) {
  applyMotion(t);
  scene_.step();
  sumEfforts();
}

void Session::sumEfforts() {
  std::size_t first = 0;
  for (const auto& m : mechanisms_) {
    const auto n = static_cast<std::size_t>(m->dof());
    m->efforts(scene_, std::span(joint_efforts_).subspan(first, n));
    first += n;
  }
}

bool Session::placeThing(ObjectId id, const Transform& X_WB) {
  // Things are the last objects of the scene.
  const std::size_t first = scene_.objectCount() - description_.objects.size();
  if (id.index() < first || id.index() >= scene_.objectCount()) return false;
  if (!scene_.setPose(id, X_WB, scene_.object(id).t)) return false;
  description_.objects[id.index() - first].X_WB = X_WB;
  return true;
}

void Session::placePerson(std::size_t human, const Vector3d& xyz, double yaw) {
  description_.humans.at(human).recording.place_xyz = xyz;
  description_.humans.at(human).recording.place_yaw = yaw;
  humans_.at(human)->setPlace(xyz, yaw);
}

void Session::placeRobot(std::size_t mechanism, const Transform& X_WB) {
  description_.mechanisms.at(mechanism).X_WB = X_WB;
  mechanisms_.at(mechanism)->setBase(X_WB);
}

std::vector<double> Session::frameTimes() const {
  for (const auto& h : humans_) {
    if (!h->recording()) continue;
    std::vector<double> t;
    for (const auto& frame : h->recording()->frames) t.push_back(frame.t);
    return t;
  }
  if (poses_) return poses_->t;
  bool moves = somethingFalls(description_);
  for (const auto& m : mechanisms_) moves = moves || m->motion();
  return moves ? frameTimes(kMotionRate) : std::vector<double>{0.0};
}

std::vector<double> Session::frameTimes(double rate) const {
  double start = kInfinity, end = -kInfinity;
  const auto cover = [&](double from, double to) {
    start = std::min(start, from);
    end = std::max(end, to);
  };
  for (const auto& h : humans_)
    if (h->recording()) cover(h->recording()->frames.front().t, h->recording()->frames.back().t);
  if (poses_) cover(poses_->t.front(), poses_->t.back());
  // Joint motion alone determines the range only without recordings of people.
  if (start > end)
    for (const auto& m : mechanisms_)
      if (m->motion()) cover(m->motion()->start(), m->motion()->end());
  if (start > end && somethingFalls(description_)) cover(0.0, kFallTime);
  if (start > end) return {0.0};
  std::vector<double> t;
  const auto count = static_cast<std::size_t>((end - start) * rate + 1e-6) + 1;
  for (std::size_t i = 0; i < count; ++i) t.push_back(start + static_cast<double>(i) / rate);
  return t;
}

void Session::capture(double t, view::SceneSnapshot& out) const {
  abstand::view::capture(scene_, out);
  out.t = t;
  out.joint_efforts = joint_efforts_;
  out.joint_positions.resize(joint_efforts_.size());
  out.movers.joint_axes.resize(joint_efforts_.size());
  std::size_t i = 0;
  for (const auto& m : mechanisms_) {
    m->axes(std::span(out.movers.joint_axes).subspan(i, m->q().size()));
    for (double q : m->q()) out.joint_positions[i++] = q;
  }
  out.movers.by_hand.resize(mechanisms_.size());
  for (std::size_t m = 0; m < mechanisms_.size(); ++m) out.movers.by_hand[m] = mechanisms_[m]->byHand();
  out.movers.person_age.resize(humans_.size());
  for (std::size_t h = 0; h < humans_.size(); ++h) out.movers.person_age[h] = humans_[h]->recordedAge();
}

}  // namespace abstand::session
