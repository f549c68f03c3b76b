// Constant data of a session for the window.
#include <set>

#include "app/session/recording_card.hpp"
#include "app/session/session.hpp"

namespace abstand::session {
namespace {

constexpr double kDrawingSagitta = 5e-4;  // m: below the resolution of the window

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
    if (m.reaction) outline.reacting.push_back(m.name);
  std::set<std::string> falling;
  for (const auto& o : description_.objects)
    if (o.mass) falling.insert(o.name);
  outline.falls = !falling.empty();
  for (const scene::Object& o : scene_.objects()) {
    outline.objects.push_back({o.spec.name, o.spec.group, people.contains(o.spec.group),
                               movers.contains(o.spec.group) || falling.contains(o.spec.name)});
    outline.meshes.push_back(o.spec.structure->surface->mesh(kDrawingSagitta));
  }
  for (const PairGroup& group : pair_groups_) outline.pair_groups.push_back(group.name);
  for (const scene::Pair& p : scene_.pairs())
    outline.pairs.emplace_back(static_cast<int>(p.a.index()), static_cast<int>(p.b.index()));
  for (std::size_t m = 0; m < mechanisms_.size(); ++m) {
    const mechanism::Mechanism& mechanism = mechanisms_[m]->mechanism();
    std::vector<view::SceneOutline::JointInfo> joints(static_cast<std::size_t>(mechanism.dof));
    for (const auto& frame : mechanism.frames)
      if (frame.dof >= 0)
        joints[static_cast<std::size_t>(frame.dof)] = {description_.mechanisms[m].name, frame.name,
                                                       frame.type == mechanism::JointType::kPrismatic};
    outline.joints.insert(outline.joints.end(), joints.begin(), joints.end());
  }
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
