#include "tracking/tracker/learned_people.hpp"

#include <algorithm>

#include "core/math/quantile.hpp"

namespace abstand::tracking {

LearnedPeople::LearnedPeople(const TrackedPerson::Options& options) : options_{options} {
  options_.compares_measured = true;
}

void LearnedPeople::see(double t, PeopleViews& views) {
  views.each([&](int id, std::size_t, std::span<const PersonImage> images) {
    const auto [it, is_new] = people_.try_emplace(id);
    Person& person = it->second;
    if (is_new) person = {std::make_unique<TrackedPerson>(options_), t + kLearning};
    for (const PersonImage& image : images) person.ids.emplace(image.number, views.idOf(id, image.number));
    person.last = t;
    if (!person.tracker) return;
    person.coming.see(t, images);
    const TrackedBody* body = person.tracker->see(t, images);
    if (body && body->found) person.costs.push_back(body->misfit.cost);
    if (t >= person.end && !person.tracker->comparesFacings()) settle(person);
  });
}

void LearnedPeople::settle(Person& person) {
  if (!person.tracker) return;
  TrackedPerson& tracker = *person.tracker;
  tracker.settle();
  if (tracker.hasBody()) person.body = std::make_shared<KnownBody>(tracker.known());
  person.tracker.reset();
}

void LearnedPeople::settle(const PeopleViews& views) {
  const std::vector<std::vector<Arrival>> arrivals = views.arrivals();
  double moved_at = kInfinity;  // later images do not show what they seem to
  for (std::size_t c = 0; c < views.size(); ++c) moved_at = std::min(moved_at, views.movedAt(c));
  for (auto& [number, person] : people_) {
    settle(person);
    if (!person.body) continue;
    Learned learned{person.body, person.coming.start(moved_at), kInfinity, person.last};
    if (!person.costs.empty()) learned.cost = nearestQuantile(person.costs, 0.5);
    for (const auto& [camera, id] : person.ids) {
      const auto is_it = [id = id](const Arrival& arrival) { return arrival.id == id; };
      if (std::any_of(arrivals[camera].begin(), arrivals[camera].end(), is_it))
        learned_.insert_or_assign({camera, id}, learned);
    }
  }
}

const LearnedPeople::Learned* LearnedPeople::find(std::size_t camera, int id) const {
  const auto it = learned_.find({camera, id});
  return it == learned_.end() ? nullptr : &it->second;
}

}  // namespace abstand::tracking
