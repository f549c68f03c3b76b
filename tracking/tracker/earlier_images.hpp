// Images of people from before they were found.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "tracking/tracker/people_views.hpp"
#include "tracking/tracker/start_trial.hpp"
#include "tracking/tracker/tracked_person.hpp"

namespace abstand::tracking {

/// Keeps the images of people whose arrival is foreseen (PeopleFinder::expect), and of people who are not yet
/// searched. When the body of one is found, it is tracked backwards through these. One thread. Allocates.
class EarlierImages {
 public:
  /// A body at a moment before.
  struct Tracked {
    std::size_t number;         ///< of the moment
    double lag;                 ///< s, of images that were fitted together; 0 for one
    DepthFrame frame;           ///< of the first camera that sees the person
    const DepthCamera* camera;  ///< of that image
    TrackedBody body;
  };

  /// Keeps those of the last moment, the `number`th, of people whose arrival is foreseen.
  void keepForeseen(std::size_t number, const DepthMoment& moment, PeopleViews& views);
  /// Likewise, of a person who is seen in `images`.
  void keep(std::size_t number, const DepthMoment& moment, int person, std::span<const PersonImage> images,
            const PeopleViews& views);

  /// A person whose body `tracker` found, and tracked through `seen`, whose images were kept: these bodies,
  /// and before them those at the moments that end there without a gap, by increasing time. `views`: at the
  /// last one. Its images are not kept any longer.
  std::vector<Tracked> track(std::span<const StartTrial::Seen> seen, int person, const PeopleViews& views,
                             TrackedPerson& tracker);

 private:
  struct Kept {
    std::size_t number;
    double t, lag;  ///< s, of the moment
    DepthFrame frame;
    const DepthCamera* camera;
    std::vector<std::uint8_t> is_person;
  };
  void add(std::size_t number, const DepthMoment& moment, const PersonImage& image, int id);

  /// By camera and PeopleViews::idOf(); each by increasing number.
  std::map<std::pair<std::size_t, int>, std::vector<Kept>> kept_;
};

}  // namespace abstand::tracking
