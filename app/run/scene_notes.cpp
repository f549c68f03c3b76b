#include "app/run/scene_notes.hpp"

#include <algorithm>

#include "app/run/joint_limits.hpp"

namespace abstand::run {

std::vector<scene::SceneNote> notesOf(const session::Session& session) {
  std::vector<Reservation> reservations = reservationsOf(session);
  const std::vector<double> times = session.frameTimes();
  addReservations(reservations, reservationsOf(jointLimitsOf(session, nullptr, times.front(), times.back())));
  std::vector<scene::SceneNote> notes;
  for (const Reservation& r : reservations) notes.push_back({r.kind, r.text, r.fails});
  for (const std::string& remark : session.remarks())
    if (std::none_of(notes.begin(), notes.end(), [&](const scene::SceneNote& n) { return n.text == remark; }))
      notes.push_back({"remark", remark, scene::Severity::kNote});
  std::stable_sort(notes.begin(), notes.end(),
                   [](const scene::SceneNote& a, const scene::SceneNote& b) { return a.fails > b.fails; });
  return notes;
}

}  // namespace abstand::run
