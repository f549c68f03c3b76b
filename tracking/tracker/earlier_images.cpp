#include "tracking/tracker/earlier_images.hpp"

#include <algorithm>

namespace abstand::tracking {

void EarlierImages::keepForeseen(std::size_t number, const DepthMoment& moment, PeopleViews& views) {
  views.eachForeseen([&](const PersonImage& image, int id) { add(number, moment, image, id); });
}

void EarlierImages::keep(std::size_t number, const DepthMoment& moment, int person,
                         std::span<const PersonImage> images, const PeopleViews& views) {
  for (const PersonImage& image : images) add(number, moment, image, views.idOf(person, image.number));
}

void EarlierImages::add(std::size_t number, const DepthMoment& moment, const PersonImage& image, int id) {
  kept_[{image.number, id}].push_back({number,
                                       moment.t,
                                       moment.lag,
                                       *moment.frames[image.number],
                                       image.camera,
                                       {image.is_person.begin(), image.is_person.end()}});
}

std::vector<EarlierImages::Tracked> EarlierImages::track(std::span<const StartTrial::Seen> seen, int person,
                                                         const PeopleViews& views, TrackedPerson& tracker) {
  std::vector<std::pair<std::size_t, std::vector<Kept>>> cameras;
  for (std::size_t c = 0; c < views.size(); ++c)
    if (auto node = kept_.extract({c, views.idOf(person, c)}))
      cameras.emplace_back(c, std::move(node.mapped()));
  std::vector<Tracked> out;
  if (seen.empty()) return out;
  const StartTrial::Seen& start = seen.front();
  std::vector<PersonImage> images;
  for (std::size_t number = seen.back().number + 1; number-- > 0;) {
    images.clear();
    Kept* first = nullptr;
    for (auto& [c, kept] : cameras) {
      const auto it =
          std::find_if(kept.begin(), kept.end(), [&](const Kept& k) { return k.number == number; });
      if (it == kept.end()) continue;
      images.push_back({&it->frame.image, it->camera, it->is_person, c});
      if (!first) first = &*it;
    }
    if (!first && number >= start.number) continue;
    if (!first) break;
    TrackedBody body;
    if (number >= start.number) {
      body = seen.back().body;
      seen = seen.first(seen.size() - 1);
    } else {
      body = tracker.seeBefore(first->t, images, start.body);
      if (!body.found) break;
    }
    out.push_back({number, images.size() > 1 ? first->lag : 0.0, std::move(first->frame), first->camera,
                   std::move(body)});
  }
  std::reverse(out.begin(), out.end());
  return out;
}

}  // namespace abstand::tracking
