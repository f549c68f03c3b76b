// Which poses were not known while a scene ran, and when.
#pragma once

#include <string>
#include <vector>

#include "app/run/reservations.hpp"

namespace abstand::run {

/// Looks at the poses of a session cycle by cycle. Bodies that are in no pair do not count: no verdict rests
/// on them. One thread. The session must outlive it.
class PoseWatch {
 public:
  explicit PoseWatch(const session::Session& session);
  /// After each cycle, at its time (s). No allocation, no throw.
  void cycle(double t) noexcept;
  /// Of all cycles so far, those of bodies that shared their fate as one.
  std::vector<Reservation> reservations() const;

 private:
  /// The cycles in which something held.
  struct Spell {
    long cycles{0}, stretches{0};
    double t0{0.0}, t1{0.0};  ///< s, the first and the last
    bool open{false};
    void note(bool holds, double t) noexcept;
    bool operator==(const Spell&) const = default;
  };
  struct Body {
    std::uint32_t object;
    std::string name, group;
    bool unmapped;  ///< no joint of the recording moves it; reservationsOf() says so
    Spell refused, stale, inferred;
  };
  /// Somebody or something that was recorded from `start` to `end` (s) and stands still before and after.
  struct Source {
    std::string name;
    double start, end;
    std::vector<std::uint32_t> objects;  ///< of a person
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
