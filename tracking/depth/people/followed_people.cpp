// Matches heads and surfaces to known people.
#include "tracking/depth/people/followed_people.hpp"

#include <algorithm>
#include <cmath>

#include "tracking/depth/people/body_area.hpp"

namespace abstand::tracking {
namespace {

using Place = PlanView::Place;

constexpr double kGate = 0.35, kGateGrowth = 1.5, kMaxGate = 1.0;  // m, m/s, m: search radius around the last
                                                                   // position
constexpr double kJump = 0.3;   // m: limit of a person's motion between two images
constexpr double kYoung = 1.0;  // s
// s, m, m/s: who appears at the side of the image, where somebody was not seen for longer, is the same person
// if the head is as high, compared with the highest of the last second. Elsewhere things hide people, who
// bend behind them.
constexpr double kSureAbsence = 0.5, kSameHeight = 0.12, kTopFalls = 0.3;
constexpr double kAtSide = 0.5;  // m
// m, s: a person who was found this near to an arrival is the one who arrived.
constexpr double kSameArrival = 0.5, kSameTime = 1.0;
// m: people move things within their reach, and hide what is behind their arms.
constexpr double kMovesWithin = 1.2, kBroadestHalf = 0.5;
// Share of the surface at the arrival. With 0.8, people who bend at first were not foreseen.
constexpr double kExpectedArea = 0.5;

double topOf(const PlanView& plan, const Head& head) { return static_cast<double>(plan.cell(head.cell).top); }

Place predicted(const FollowedPerson& person, double t) {
  return person.place + person.speed * std::min(t - person.seen, 0.3);
}

}  // namespace

FollowedPeople::FollowedPeople(const DepthCamera& camera, double keep, double without_head)
    : camera_(camera), keep_(keep), without_head_(without_head) {
  people_.reserve(kMax);
  arrivals_.reserve(kMaxArrivals);
}

void FollowedPeople::expect(std::vector<Arrival> arrivals) {
  expected_ = std::move(arrivals);
  for (const Arrival& arrival : expected_) next_id_ = std::max(next_id_, arrival.id + 1);
}

/// The nearest pair of a head and a person who has none yet, of those who were seen last, or of the others.
FollowedPeople::Match FollowedPeople::nearestHead(double t, const PlanView& plan, std::vector<Head>& heads,
                                                  bool is_absent) {
  Match nearest;
  double best = kInfinity;
  for (FollowedPerson& person : people_) {
    if (person.matched || (t - person.seen > kSureAbsence) != is_absent) continue;
    const double gate = std::min(kGate + kGateGrowth * (t - person.seen), kMaxGate);
    const bool is_compared = is_absent && isAtSide(person.place);
    for (auto head = heads.begin(); head != heads.end(); ++head) {
      if (is_compared && std::abs(topOf(plan, *head) - person.top) > kSameHeight) continue;
      const double distance = (head->place - predicted(person, t)).norm();
      if (distance < std::min(best, gate)) best = distance, nearest = {&person, head};
    }
  }
  return nearest;
}

void FollowedPeople::follow(double t, const PlanView& plan, std::vector<Head>& heads) {
  std::erase_if(people_, [](const FollowedPerson& person) { return !std::isfinite(person.seen); });
  for (FollowedPerson& person : people_) person.here = person.matched = person.suspect = false;
  const auto meet = [&](FollowedPerson& person, const Place& place, bool has_head, double top) {
    const double dt = t - person.seen;
    person.top = std::max(top, person.top - kTopFalls * dt);
    if (dt > 0.0 && dt < 0.5) person.speed = 0.7 * person.speed + 0.3 * (place - person.place) / dt;
    person.suspect = t - person.born < kYoung || (place - person.place).norm() > kJump;
    person.place = place;
    person.seen = t;
    if (has_head) person.head_seen = t, person.low = false;
    person.here = true;
    person.matched = has_head;
  };
  // Heads and persons greedily, nearest pair first, before those who were not seen for a while.
  for (const bool is_absent : {false, true})
    for (Match match = nearestHead(t, plan, heads, is_absent); match.person;
         match = nearestHead(t, plan, heads, is_absent)) {
      meet(*match.person, middleOfBody(plan, match.head->place), true, topOf(plan, *match.head));
      heads.erase(match.head);
    }
  // Persons without a visible head stay with the surface at their last position.
  for (FollowedPerson& person : people_) {
    if (person.matched || t - person.head_seen > without_head_) continue;
    if (t - person.seen > kSureAbsence && isAtSide(person.place)) continue;
    const Place place = middleOfBody(plan, predicted(person, t));
    bool is_free = true;
    for (const FollowedPerson& other : people_)
      is_free = is_free && (!other.here || (other.place - place).norm() > kHeadsApart);
    if (is_free && (place - person.place).norm() < kMaxGate && bodyArea(plan, place, kBodyRadius) >= kMinBody)
      meet(person, place, false, -kInfinity);
  }
  std::erase_if(people_, [&](const FollowedPerson& person) { return t - person.seen > keep_; });
}

/// Whether a person at a place may leave the image to the left or right.
bool FollowedPeople::isAtSide(const Place& place) const {
  const double left = -camera_.cx / camera_.fx * place.y(),
               right = (camera_.width - 1 - camera_.cx) / camera_.fx * place.y();
  return std::min(place.x() - left, right - place.x()) < kAtSide;
}

void FollowedPeople::addExpected(double t, const PlanView& plan) {
  for (const Arrival& arrival : expected_) {
    bool is_new = t < arrival.t && t >= arrival.t - kForesight && !full() &&
                  bodyArea(plan, arrival.place, kBodyRadius) >= kExpectedArea * arrival.area;
    for (const FollowedPerson& person : people_)
      is_new = is_new && person.id != arrival.id &&
               !(person.here && (person.place - arrival.place).norm() < kPeopleApart);
    if (is_new) insert(t, plan, arrival.place, arrival.id).arrives = arrival.t;
  }
  std::erase_if(expected_, [&](const Arrival& arrival) {
    return t >= arrival.t && std::any_of(people_.begin(), people_.end(), [&](const FollowedPerson& person) {
             return person.id == arrival.id;
           });
  });
}

/// The id of who arrives now at a place, who is then expected no more, or a new one.
int FollowedPeople::idAt(double t, const Place& place) {
  const auto distance = [&](const Arrival& arrival) {
    return std::abs(arrival.t - t) <= kSameTime ? (arrival.place - place).norm() : kInfinity;
  };
  const auto nearest =
      std::min_element(expected_.begin(), expected_.end(),
                       [&](const Arrival& a, const Arrival& b) { return distance(a) < distance(b); });
  if (nearest == expected_.end() || distance(*nearest) >= kSameArrival) return next_id_++;
  const int id = nearest->id;
  expected_.erase(nearest);
  // Whoever was foreseen there is not followed any more.
  std::erase_if(people_, [id](const FollowedPerson& person) { return person.id == id; });
  return id;
}

FollowedPerson& FollowedPeople::insert(double t, const PlanView& plan, const Place& place, int id) {
  FollowedPerson person;
  person.id = id;
  if (arrivals_.size() < kMaxArrivals)
    arrivals_.push_back({id, place, bodyArea(plan, place, kBodyRadius), t});
  person.place = place;
  person.born = person.seen = person.head_seen = t;
  person.here = person.suspect = true;
  const auto after = std::find_if(people_.begin(), people_.end(),
                                  [&](const FollowedPerson& other) { return other.id > person.id; });
  return *people_.insert(after, person);
}

void FollowedPeople::add(double t, const PlanView& plan, const Place& place) {
  insert(t, plan, place, idAt(t, place));
}

FollowedPerson* FollowedPeople::keepOrInsert(double t, const PlanView& plan, const Place& place,
                                             double reach) {
  bool is_new = !full();
  for (FollowedPerson& person : people_) {
    if (!person.here || (person.place - place).norm() > reach) continue;
    person.head_seen = t;
    is_new = false;
  }
  return is_new ? &insert(t, plan, place, idAt(t, place)) : nullptr;
}

void FollowedPeople::keepOrAdd(double t, const PlanView& plan, const Place& place, double reach) {
  keepOrInsert(t, plan, place, reach);
}

void FollowedPeople::keepOrAddCrouched(double t, const PlanView& plan, const Place& place, double reach) {
  if (FollowedPerson* person = keepOrInsert(t, plan, place, reach)) person->low = true;
}

bool FollowedPeople::mayDisturb(const Place& place) const {
  for (const FollowedPerson& person : people_) {
    if (person.low) continue;
    if ((person.place - place).norm() < kMovesWithin) return true;
    // The person's shadow at the distance of the place, half of the place's breadth included.
    const double distance = place.norm(), of_person = person.place.norm();
    if (of_person >= distance) continue;
    const double enlarged = distance / std::max(of_person, kBroadestHalf);
    const double aside = std::abs(person.place.x() * place.y() - person.place.y() * place.x()) / distance;
    if (aside * enlarged < kBroadestHalf * (enlarged + 1.0)) return true;
  }
  return false;
}

void FollowedPeople::withdraw(std::size_t k) {
  std::erase_if(arrivals_, [&](const Arrival& arrival) { return arrival.id == people_[k].id; });
  people_[k].here = false;
  people_[k].seen = -kInfinity;  // removed with the next image
}

}  // namespace abstand::tracking
