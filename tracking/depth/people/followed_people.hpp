// People who are followed from image to image.
#pragma once

#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/people/heads.hpp"

namespace abstand::tracking {

inline constexpr double kPeopleApart = 0.4;  ///< m; a new person is at least this far from others

/// Where and when a person was first found.
struct Arrival {
  int id{-1};
  PlanView::Place place{PlanView::Place::Zero()};  ///< m, in the plan view of the camera
  double area{0.0};                                ///< m^2 of visible surface around it
  double t{0.0};                                   ///< s
};

struct FollowedPerson {
  int id{-1};
  PlanView::Place place{PlanView::Place::Zero()}, speed{PlanView::Place::Zero()};  ///< m, m/s
  double born{0.0}, seen{0.0}, head_seen{0.0};  ///< s, first seen, last seen, last seen with a head
  double arrives{-kInfinity};                   ///< s; foreseen before
  double top{-kInfinity};                       ///< m, height of the head, of the last second
  bool here{false};                             ///< seen in this image
  bool matched{false};                          ///< matched to a head of this image
  bool low{false};                              ///< found crouched, and not yet with a head
  bool suspect{false};  ///< younger than a second, or at a place where it was not before
};

/// Follows people by their heads, and without visible heads by the surface at their places. Not shared
/// between threads; does not throw, and after the first image it does not allocate.
class FollowedPeople {
 public:
  static constexpr int kMax = 64;  ///< at once
  static constexpr std::size_t kMaxArrivals = 1024;
  /// s, see addExpected(). A second pass copies the images of that time: 150 MB at 640 x 480.
  static constexpr double kForesight = 4.0;

  /// Times (s) for which an unseen person keeps the id, and for which one is followed without a head.
  FollowedPeople(const DepthCamera& camera, double keep, double without_head);

  /// Arrivals that another look at the same images has found: these people get the same ids.
  void expect(std::vector<Arrival> arrivals);
  /// Of all people so far, at most kMaxArrivals.
  const std::vector<Arrival>& arrivals() const { return arrivals_; }

  /// By increasing id.
  const std::vector<FollowedPerson>& all() const { return people_; }
  bool full() const { return people_.size() >= static_cast<std::size_t>(kMax); }

  /// Finds known people again in an image, and removes their heads from `heads`.
  void follow(double t, const PlanView& plan, std::vector<Head>& heads);
  /// A new person, or one who is expected there and then. Not if full().
  void add(double t, const PlanView& plan, const PlanView::Place& place);
  /// Somebody without a visible head: the person who is here within `reach` (m), or a new one.
  void keepOrAdd(double t, const PlanView& plan, const PlanView::Place& place, double reach);
  /// Likewise somebody who crouches.
  void keepOrAddCrouched(double t, const PlanView& plan, const PlanView::Place& place, double reach);
  /// Whether somebody who was found with a head is or was near a place, or may hide it from the camera.
  bool mayDisturb(const PlanView::Place& place) const;
  /// Adds people who arrive within kForesight, and of whom half as much surface is already at the place: who
  /// bends, or is partly hidden, shows less than at the arrival. Who is lost before arriving may be added
  /// again.
  void addExpected(double t, const PlanView& plan);
  /// Forgets who was nobody, with the arrival; the entry remains until the next image.
  void withdraw(std::size_t k);

 private:
  /// `person` is null if there is none.
  struct Match {
    FollowedPerson* person{nullptr};
    std::vector<Head>::iterator head{};
  };
  Match nearestHead(double t, const PlanView& plan, std::vector<Head>& heads, bool is_absent);
  bool isAtSide(const PlanView::Place& place) const;
  int idAt(double t, const PlanView::Place& place);
  /// The new person of keepOrAdd(), null if there is none.
  FollowedPerson* keepOrInsert(double t, const PlanView& plan, const PlanView::Place& place, double reach);
  FollowedPerson& insert(double t, const PlanView& plan, const PlanView::Place& place, int id);

  DepthCamera camera_;
  double keep_, without_head_;  // s
  std::vector<FollowedPerson> people_;
  std::vector<Arrival> arrivals_, expected_;
  int next_id_{1};
};

}  // namespace abstand::tracking
