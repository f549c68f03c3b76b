// Compares several cameras by the people whom they see.
#pragma once

#include "tracking/tracker/apart_spans.hpp"
#include "tracking/tracker/camera_fault.hpp"
#include "tracking/tracker/lone_camera.hpp"
#include "tracking/tracker/through_spans.hpp"

namespace abstand::tracking {

/// Tracks people with each camera alone, and compares the places: those of one person tracked by two
/// calibrated cameras differ by centimetres. A fit to the images of all would lie between them, or follow one
/// of them, and explain both badly, as it does where things hide a person. Where a body is not explained well
/// by one camera, and of errors in height, what one camera measures and the other one sees through tells it
/// (ThroughAt). One thread; allocates.
class CameraAgreement {
 public:
  /// At least two cameras with poses in one world; they must outlive this object.
  CameraAgreement(std::span<const DepthCamera> cameras, const TrackedPerson::Options& options);

  /// Of all moments, before see(): which cameras hang or were moved. Throws UsageError if the first images of
  /// two cameras are the same: it is one recording.
  void note(const DepthMoment& moment, const PeopleViews& views);
  /// Compares the places of people; not all moments need to be compared. `moment.t` (s) increases; `views` of
  /// these cameras has seen the moment.
  void see(const DepthMoment& moment, PeopleViews& views);
  /// Leaves out what was seen before `t` (s) in faults() from now on.
  void forgetBefore(double t);
  /// What the moments so far show, by camera. Two people whom one camera sees each are not compared, unless
  /// both cameras see through the person of the other one.
  std::vector<CameraFault> faults() const;

 private:
  struct Pair {
    std::size_t first, second;
    std::vector<SeenTwice> seen{};
    std::vector<ThroughAt> through{};
    std::size_t same{0};  ///< images from the start that are equal
    bool differs{false};  ///< later ones are not counted
  };
  void refuseSame(const DepthMoment& moment);
  void noteHang(std::size_t camera, double t, double since);
  void compare(double t, Pair& pair) const;
  template <class Seen>
  static std::vector<Seen> usable(const Pair& pair, const std::vector<Seen>& seen,
                                  std::span<const CameraFault> faults);
  void addApart(const std::vector<std::vector<ApartSpan>>& spans, std::vector<CameraFault>& faults) const;
  void addLate(std::vector<CameraFault>& faults) const;
  CameraFault blamed(const Pair& pair, const ApartSpan& span,
                     const std::vector<std::vector<ApartSpan>>& spans) const;

  std::vector<LoneCamera> cameras_;
  std::vector<std::size_t> found_;  // images with a person, by camera
  std::vector<double> moved_;       // s, CameraWatch::movedAt()
  std::vector<CameraFault> hangs_;
  std::vector<Pair> pairs_;
};

}  // namespace abstand::tracking
