#include "tracking/tracker/people_across.hpp"

#include <algorithm>

namespace abstand::tracking {
namespace {

constexpr double kSame = 0.5;         // m; what two cameras see of one person has its middle within this
constexpr double kApartPeople = 0.9;  // m; farther apart they are two people
constexpr double kDoubted = 0.5;      // s
constexpr double kRemembered = 1.0;   // s; a place on the floor is that of the person for this long

}  // namespace

bool PeopleAcross::isTaken(std::span<const SeenPlace> seen, std::size_t camera, int person) const {
  for (std::size_t k = 0; k < seen.size(); ++k)
    if (seen[k].camera == camera && ids_[k] == person) return true;
  return false;
}

/// The nearest person whom the camera does not see already; 0 if none is near enough.
int PeopleAcross::nearest(double t, std::span<const SeenPlace> seen, std::size_t i) const {
  int best = 0;
  double smallest = kSame;
  for (const auto& [id, person] : persons_) {
    if (id == ids_[i] || t - person.t > kRemembered || isTaken(seen, seen[i].camera, id)) continue;
    const double distance = (person.place - seen[i].place).norm();
    if (distance >= smallest) continue;
    smallest = distance;
    best = id;
  }
  return best;
}

/// Updates the places of people who are seen.
void PeopleAcross::place(double t, std::span<const SeenPlace> seen) {
  for (auto& [id, person] : persons_) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double count = 0.0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (ids_[k] != id) continue;
      sum += seen[k].place;
      count += 1.0;
    }
    if (count > 0.0) person = {sum / count, t};
  }
}

/// Moves a view to another person once its place has spoken against its own for a while.
void PeopleAcross::doubt(double t, std::span<const SeenPlace> seen, std::size_t i) {
  Eigen::Vector2d others = Eigen::Vector2d::Zero();
  double count = 0.0;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (k == i || ids_[k] != ids_[i]) continue;
    others += seen[k].place;
    count += 1.0;
  }
  Member& member = members_.at({seen[i].camera, seen[i].id});
  // The younger number of two goes.
  const int other = count == 0.0 ? nearest(t, seen, i) : 0;
  const bool is_doubted =
      count > 0.0 ? (seen[i].place - others / count).norm() > kApartPeople : other != 0 && other < ids_[i];
  if (!is_doubted) {
    member.doubted_since = kInfinity;
    return;
  }
  member.doubted_since = std::min(member.doubted_since, t);
  if (t - member.doubted_since < kDoubted) return;
  const int better = other != 0 ? other : nearest(t, seen, i);
  member = {better != 0 ? better : next_++, kInfinity};
  ids_[i] = member.person;
  persons_[member.person] = {seen[i].place, t};
}

std::span<const int> PeopleAcross::match(double t, std::span<const SeenPlace> seen) {
  ids_.assign(seen.size(), 0);
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (const auto it = members_.find({seen[i].camera, seen[i].id}); it != members_.end())
      ids_[i] = it->second.person;
  place(t, seen);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (ids_[i] != 0) continue;
    const int known = nearest(t, seen, i);
    ids_[i] = known != 0 ? known : next_++;
    members_[{seen[i].camera, seen[i].id}] = {ids_[i], kInfinity};
    if (known == 0) persons_[ids_[i]] = {seen[i].place, t};
  }
  // Of two that separate, the first camera's keeps the number.
  for (std::size_t i = seen.size(); i-- > 0;) doubt(t, seen, i);
  return ids_;
}

}  // namespace abstand::tracking
