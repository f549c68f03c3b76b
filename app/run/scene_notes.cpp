#include "app/run/scene_notes.hpp"

#include <algorithm>

#include "app/run/joint_limits.hpp"

namespace abstand {

std::vector<SceneNote> notesOf(const Session& session) {
  std::vector<Reservation> reservations = reservationsOf(session);
  const std::vector<double> times = session.frameTimes();
  addReservations(reservations, reservationsOf(jointLimitsOf(session, nullptr, times.front(), times.back())));
  std::vector<SceneNote> notes;
  for (const Reservation& r : reservations) notes.push_back({r.kind, r.text, r.fails});
  for (const std::string& remark : session.remarks())
    if (std::none_of(notes.begin(), notes.end(), [&](const SceneNote& n) { return n.text == remark; }))
      notes.push_back({"remark", remark, Severity::kNote});
  std::stable_sort(notes.begin(), notes.end(),
                   [](const SceneNote& a, const SceneNote& b) { return a.fails > b.fails; });
  return notes;
}

}  // namespace abstand
