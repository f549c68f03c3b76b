// Records which poses were unknown during a run, and when.
#pragma once

#include <string>
#include <vector>

#include "app/run/reservations.hpp"

namespace abstand::run {

/// Checks the poses of a session in each cycle. Bodies without pairs are ignored, as no verdict depends on
/// them. One thread. The session must outlive this object.
class PoseWatch {
 public:
  explicit PoseWatch(const session::Session& session);
  /// Call after each cycle, at its time (s). No allocation, no throw.
  void cycle(double t) noexcept;
  /// Reservations about all cycles so far; bodies with the same history are merged.
  std::vector<Reservation> reservations() const;

 private:
  /// Cycles in which a condition held.
  struct Spell {
    long cycles{0}, stretches{0};
    double t0{0.0}, t1{0.0};  ///< s, first and last
    bool open{false};
    void note(bool holds, double t) noexcept;
    bool operator==(const Spell&) const = default;
  };
  struct Body {
    std::uint32_t object;
    std::string name, group;
    bool unmapped;  ///< no joint of the recording moves it; reported by reservationsOf()
    Spell refused, stale, inferred;
  };
  /// Something recorded from `start` to `end` (s), which stands still before and after.
  struct Source {
    std::string name;
    double start, end;
    std::vector<std::uint32_t> objects;  ///< objects of a person
    Spell absent, outside;
  };
  void add(std::vector<Reservation>& out, const char* kind, const std::string& what, const Spell& spell,
           scene::Severity fails) const;
  void addBodies(std::vector<Reservation>& out, const char* kind, const char* what, Spell Body::*spell,
                 scene::Severity fails) const;
  bool wasAbsent(const Body& body, const Spell& spell) const;

  const session::Session& session_;
  std::vector<Body> bodies_;
  std::vector<Source> sources_;
  long cycles_{0};
};

}  // namespace abstand::run
