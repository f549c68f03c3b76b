// Constant data of a session for the window.
#include <set>

#include "app/session/recording_card.hpp"
#include "app/session/session.hpp"
#include "app/session/unchecked_pairs.hpp"

namespace abstand::session {
namespace {

constexpr double kDrawingSagitta = 5e-4;  // m: below the resolution of the window

view::BodyCard bodyCard(const structure::HapticStructure& body) {
  const geometry::Bounds box = body.surface->bounds();
  return {box.upper - box.lower, body.shell.size(), body.options.point_spacing, body.grid.voxel_size,
          body.errorBound()};
}

view::PersonCard personCard(const scene_file::HumanDescription& description, const HumanDriver& driver) {
  const humanmodel::HumanModel& model = driver.model();
  view::PersonCard card{description.name,
                        model.height,
                        model.mass,
                        {},
                        model.options.percentile,
                        description.recording.file.string(),
                        description.recording.place_xyz,
                        description.recording.place_yaw};
  if (model.options.sex) card.sex = *model.options.sex == humanmodel::Sex::kFemale ? "f" : "m";
  return card;
}

/// Appends the joints of a mechanism to the outline's.
void addJoints(const std::string& name, const MechanismDriver& driver, view::SceneOutline& outline) {
  std::vector<view::SceneOutline::JointInfo> joints(static_cast<std::size_t>(driver.dof()));
  for (const auto& frame : driver.mechanism().frames) {
    if (frame.dof < 0) continue;
    const auto i = static_cast<std::size_t>(frame.dof);
    const mechanism::DofLimits& limits = driver.limits()[i];
    joints[i] = {name,         frame.name,   frame.type == mechanism::JointType::kPrismatic,
                 limits.lower, limits.upper, limits.effort};
  }
  outline.joints.insert(outline.joints.end(), joints.begin(), joints.end());
}

}  // namespace

view::SceneOutline Session::outline() const {
  view::SceneOutline outline;
  std::set<std::string> people, movers;
  for (const auto& h : description_.humans) {
    people.insert(h.name);
    if (!h.recording.file.empty()) movers.insert(h.name);
  }
  for (const auto& m : description_.mechanisms)
    if (!m.motion.empty() || m.reaction) movers.insert(m.name);
  for (const auto& m : description_.mechanisms)
    if (m.reaction) {
      outline.reacting.push_back(m.name);
      outline.reactions.push_back(*m.reaction);
    }
  std::set<std::string> falling;
  for (const auto& o : description_.objects)
    if (o.mass) falling.insert(o.name);
  outline.falls = !falling.empty();
  for (const scene::Object& o : scene_.objects()) {
    outline.objects.push_back({o.spec.name, o.spec.group, people.contains(o.spec.group),
                               movers.contains(o.spec.group) || falling.contains(o.spec.name)});
    outline.meshes.push_back(o.spec.structure->surface->mesh(kDrawingSagitta));
    outline.bodies.push_back(bodyCard(*o.spec.structure));
  }
  for (const PairGroup& group : pair_groups_) outline.pair_groups.push_back(group.name);
  for (const scene::Pair& p : scene_.pairs())
    outline.pairs.emplace_back(static_cast<int>(p.a.index()), static_cast<int>(p.b.index()));
  for (std::size_t m = 0; m < mechanisms_.size(); ++m) {
    const scene_file::MechanismDescription& description = description_.mechanisms[m];
    const MechanismDriver& driver = *mechanisms_[m];
    outline.robots.push_back({description.name, description.file.string(), description.motion.string(),
                              driver.X_WB(), static_cast<int>(outline.joints.size()), driver.dof()});
    addJoints(description.name, driver, outline);
  }
  for (std::size_t h = 0; h < humans_.size(); ++h)
    outline.people.push_back(personCard(description_.humans[h], *humans_[h]));
  addUnchecked(description_.pairs, adjacent_, outline);
  const auto times = frameTimes();
  outline.start = times.front();
  outline.end = times.back();
  if (times.size() > 1)
    outline.frame_period = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  outline.title = description_.file.filename().string();
  for (std::size_t h = 0; h < humans_.size(); ++h)
    if (const tracking::Recording* recording = humans_[h]->recording())
      outline.recordings.push_back(
          recordingCard(description_.humans[h].name, description_.humans[h].recording.file, *recording));
  return outline;
}

}  // namespace abstand::session
