// Images of people whose first body is not chosen yet.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "tracking/tracker/kept_moment.hpp"
#include "tracking/tracker/people_views.hpp"

namespace abstand::tracking {

/// Keeps the images of people whose arrival is foreseen (PeopleFinder::expect), and of people whose first
/// body is not chosen yet. One thread. Allocates.
class KeptImages {
 public:
  /// Keeps those of the last moment, the `number`th, of people whose arrival is foreseen.
  void keepForeseen(std::size_t number, const DepthMoment& moment, PeopleViews& views);
  /// Likewise, of a person who is seen in `images`.
  void keep(std::size_t number, const DepthMoment& moment, int person, std::span<const PersonImage> images,
            const PeopleViews& views);

  /// Those of a person of the last moment, to which `views` belongs, by increasing time. They are not kept
  /// any longer.
  std::vector<KeptMoment> take(int person, const PeopleViews& views);

 private:
  void add(std::size_t number, const DepthMoment& moment, const PersonImage& image, int id);

  /// Of one camera each, by its number and PeopleViews::idOf(); by increasing number of the moment.
  std::map<std::pair<std::size_t, int>, std::vector<KeptMoment>> kept_;
  /// By camera: number of the last moment of which an image was kept, and the image.
  std::map<std::size_t, std::pair<std::size_t, std::shared_ptr<const DepthFrame>>> last_;
};

}  // namespace abstand::tracking
