// Compares several live cameras with each other while they track people.
#pragma once

#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "tracking/tracker/camera_agreement.hpp"
#include "tracking/tracker/compare_pace.hpp"

namespace abstand::tracking {

/// CameraAgreement of the last kRemembered seconds, with some of the moments: those of a ComparePace, and
/// none while another one is compared. What is found is known with the delay of its spans, 0.5 s and more,
/// and remembered: a camera that jumped is the one that is wrong until the cameras agree again. One thread,
/// and another one of its own if it compares aside. offer() does not allocate after the first moments, unless
/// it compares inline.
class LiveAgreement {
 public:
  /// At least two cameras with poses in one world. `aside`: compares on a thread of its own.
  LiveAgreement(std::span<const DepthCamera> cameras, const TrackedPerson::Options& options, bool aside);
  ~LiveAgreement();
  LiveAgreement(const LiveAgreement&) = delete;
  LiveAgreement& operator=(const LiveAgreement&) = delete;

  /// `moment.t` (s) increases. `known` (m; 0: none): images of known things, one for each camera, or null.
  /// Throws what CameraAgreement::note() has thrown.
  void offer(const DepthMoment& moment, std::span<const DepthImage* const> known);
  /// Whether a moment is being compared: the next one is not.
  bool isBusy();
  /// Faults so far of the kinds kApart and kLate; those that hold have no end. Ended ones are forgotten after
  /// kRemembered.
  std::span<const CameraFault> faults();

  static constexpr double kJudged = 0.25;      ///< s between two judgements
  static constexpr double kRemembered = 30.0;  ///< s

 private:
  /// A moment, copied.
  struct Work {
    double t{0.0};
    std::vector<DepthFrame> frames;
    std::vector<DepthImage> known;
    std::vector<bool> has_frame, has_known;
  };
  static void copy(const DepthMoment& moment, std::span<const DepthImage* const> known, Work& work);
  void compare(const Work& work);
  void note(const std::vector<CameraFault>& found, double t);
  void run();

  std::vector<DepthCamera> cameras_;
  CameraAgreement agreement_;  // of the thread, if there is one, with views_
  PeopleViews views_;
  ComparePace pace_;
  double next_judged_{-kInfinity};  // s
  Work work_;
  std::vector<CameraFault> found_;  // by compare()

  std::mutex mutex_;
  std::condition_variable came_;
  bool is_ready_{false};  // work_ is to be compared: it is the other thread's
  bool ends_{false}, is_known_{true};
  double judged_at_{0.0};  // s, of found_ unless is_known_
  std::exception_ptr error_;
  std::vector<CameraFault> faults_;  // of the owner's thread
  std::thread thread_;               // last: it uses the others
};

}  // namespace abstand::tracking
