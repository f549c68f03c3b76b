#include "tracking/tracker/kept_images.hpp"

namespace abstand::tracking {

void KeptImages::keepForeseen(std::size_t number, const DepthMoment& moment, PeopleViews& views) {
  views.eachForeseen([&](const PersonImage& image, int id) { add(number, moment, image, id); });
}

void KeptImages::keep(std::size_t number, const DepthMoment& moment, int person,
                      std::span<const PersonImage> images, const PeopleViews& views) {
  for (const PersonImage& image : images) add(number, moment, image, views.idOf(person, image.number));
}

void KeptImages::add(std::size_t number, const DepthMoment& moment, const PersonImage& image, int id) {
  KeptMoment& kept = kept_[{image.number, id}].emplace_back(KeptMoment{number, moment.t, moment.lag});
  std::pair<std::size_t, std::shared_ptr<const DepthFrame>>& last = last_[image.number];
  if (!last.second || last.first != number)
    last = {number, std::make_shared<const DepthFrame>(*moment.frames[image.number])};
  kept.add(image, last.second);
}

std::vector<KeptMoment> KeptImages::take(int person, const PeopleViews& views) {
  std::map<std::size_t, KeptMoment> by_number;
  for (std::size_t c = 0; c < views.size(); ++c) {
    auto node = kept_.extract({c, views.idOf(person, c)});
    if (!node) continue;
    for (KeptMoment& kept : node.mapped()) {
      const auto [it, is_new] = by_number.try_emplace(kept.number, std::move(kept));
      if (!is_new) it->second.images.push_back(std::move(kept.images.front()));
    }
  }
  std::vector<KeptMoment> moments;
  for (auto& [number, moment] : by_number) {
    if (moment.images.size() == 1) moment.lag = 0.0;
    moments.push_back(std::move(moment));
  }
  return moments;
}

}  // namespace abstand::tracking
