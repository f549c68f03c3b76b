// What a first pass over recordings learns about the people in them.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <utility>

#include "tracking/tracker/coming_into_view.hpp"
#include "tracking/tracker/people_views.hpp"
#include "tracking/tracker/tracked_person.hpp"

namespace abstand::tracking {

/// Measures and fits the body of each person in the first kLearning seconds in view, or as long as facing
/// directions are compared, and finds the image in which a second pass shall search for it. One thread.
/// Allocates.
class LearnedPeople {
 public:
  static constexpr double kLearning = 5.0;  ///< s

  /// For a second pass.
  struct Learned {
    std::shared_ptr<const KnownBody> body;
    double start{0.0};       ///< s, ComingIntoView::start()
    double cost{kInfinity};  ///< median of Misfit::cost; infinite: no body was found
    double last{0.0};        ///< s, of the last image
  };

  explicit LearnedPeople(const TrackedPerson::Options& options);

  /// The people of the moment that `views` saw last. `t` (s) increases.
  void see(double t, PeopleViews& views);
  /// After the last moment: fits the bodies of those who were in view for less.
  void settle(const PeopleViews& views);

  /// A person by the id in the images of one camera, which is that of PeopleViews::expect(); null if there is
  /// no such person, or nothing of the person was measured. Valid after settle().
  const Learned* find(std::size_t camera, int id) const;

 private:
  using Id = std::pair<std::size_t, int>;  // camera, and id in its images
  struct Person {
    std::unique_ptr<TrackedPerson> tracker;  // null at the end
    double end;                              // s
    ComingIntoView coming{};
    std::vector<double> costs{};  // Misfit::cost where the body was found
    double last{0.0};             // s
    std::set<Id> ids{};
    std::shared_ptr<const KnownBody> body{};
  };
  static void settle(Person& person);

  TrackedPerson::Options options_;
  std::map<int, Person> people_;
  std::map<Id, Learned> learned_;
};

}  // namespace abstand::tracking
