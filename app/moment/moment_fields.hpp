// Order of the numbers of a moment, in one place for writing and reading.
#pragma once

#include <cmath>

#include "app/moment/byte_cursor.hpp"
#include "app/moment/moment_packet.hpp"

namespace abstand::moment {

/// m; as Scene rejects poses beyond.
inline constexpr double kMaxCoordinate = 1e6;
/// Deviation of R^T R from the identity: rounding of a rotation, not of a scaled one.
inline constexpr double kRotationTolerance = 1e-6;

/// Archive that writes.
class PutFields {
 public:
  explicit PutFields(std::span<std::byte> into) : out_(into) {}

  template <class T>
  void same(const T& value) {
    out_.put(value);
  }
  template <class Wire, class T>
  void as(const T& value) {
    out_.put(static_cast<Wire>(value));
  }
  void check(bool) {}
  bool good() const { return out_.good(); }
  std::size_t written() const { return out_.written(); }

 private:
  ByteWriter out_;
};

/// Archive that only counts bytes.
class CountFields {
 public:
  template <class T>
  void same(const T&) {
    bytes_ += sizeof(T);
  }
  template <class Wire, class T>
  void as(const T&) {
    bytes_ += sizeof(Wire);
  }
  void check(bool) {}
  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t bytes_{0};
};

/// Archive that reads and checks.
class GetFields {
 public:
  explicit GetFields(std::span<const std::byte> from) : in_(from) {}

  template <class T>
  void same(T& value) {
    value = in_.get<T>();
  }
  template <class Wire, class T>
  void as(T& value) {
    value = static_cast<T>(in_.get<Wire>());
  }
  void check(bool right) {
    if (!right) in_.fail();
  }
  bool good() const { return in_.good() && in_.left() == 0; }

 private:
  ByteReader in_;
};

/// A pair of which nothing is known has no force either.
inline bool hasForce(const query::PairResult& r) {
  return r.depth != 0.0 || !r.force_a.isZero(0.0) || !r.torque_a.isZero(0.0) || !r.torque_b.isZero(0.0);
}
inline void clearForce(query::PairResult& r) {
  r.depth = 0.0;
  r.force_a = r.torque_a = r.torque_b = Vector3d::Zero();
}

/// An enum of `count` values from 0, as u32.
template <class Archive, class Enum>
void exchangeEnum(Archive& archive, Enum& value, std::size_t count) {
  auto number = static_cast<std::uint32_t>(value);
  archive.same(number);
  archive.check(number < count);
  if constexpr (!std::is_const_v<Enum>) value = static_cast<Enum>(number);
}

/// Wire: type of each component.
template <class Wire, class Archive, class Vector>
void exchangeVector(Archive& archive, Vector& v) {
  for (Eigen::Index k = 0; k < 3; ++k) archive.template as<Wire>(v[k]);
}

/// Row-major 3 x 4.
template <class Archive, class Pose>
void exchangePose(Archive& archive, Pose& X) {
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index c = 0; c < 4; ++c) archive.template as<double>(X.matrix()(r, c));
  // Comparisons with NaN are false.
  archive.check(X.translation().cwiseAbs().maxCoeff() <= kMaxCoordinate);
  const Eigen::Matrix3d R = X.linear();
  archive.check((R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <=
                kRotationTolerance);
  archive.check(R.determinant() > 0.0);
}

template <class Archive, class Robot, class Age>
void exchangeRobot(Archive& archive, Robot& robot, Age& input_age) {
  archive.template as<double>(robot.speed_scale);
  archive.template as<double>(input_age);
  archive.template as<double>(robot.since);
  archive.template as<double>(robot.cause.value);
  archive.template as<double>(robot.cause.limit);
  exchangeEnum(archive, robot.state, safety::kStopStates);
  exchangeEnum(archive, robot.cause.reason, safety::kStopReasons);
  archive.template as<std::int32_t>(robot.cause.pair);
  archive.template as<std::int32_t>(robot.cause.joint);
  archive.check(robot.speed_scale >= 0.0 && robot.speed_scale <= 1.0);
  archive.check(input_age >= 0.0 && std::isfinite(robot.since));
}

template <class Archive, class Object>
void exchangeObject(Archive& archive, Object& object) {
  constexpr std::size_t kPoseStates = 4;
  exchangePose(archive, object.X_WB);
  exchangeVector<double>(archive, object.p_WCom);
  exchangeVector<float>(archive, object.velocity.linear);
  exchangeVector<float>(archive, object.velocity.angular);
  exchangeVector<float>(archive, object.contact.force);
  exchangeVector<float>(archive, object.contact.torque);
  archive.template as<double>(object.margin);
  archive.template as<double>(object.pose_uncertainty);
  exchangeEnum(archive, object.pose_state, kPoseStates);
  archive.template as<std::uint32_t>(object.colliding);
  archive.check(object.p_WCom.cwiseAbs().maxCoeff() <= kMaxCoordinate);
  archive.check(object.velocity.linear.allFinite() && object.velocity.angular.allFinite());
  archive.check(object.contact.force.allFinite() && object.contact.torque.allFinite());
  archive.check(object.margin >= 0.0 && std::isfinite(object.margin));
  archive.check(object.pose_uncertainty >= 0.0);
}

/// Without forces. An unknown distance is NaN; an infinite one is damage, as it would count as safe.
template <class Archive, class Pair, class Group>
void exchangePair(Archive& archive, Pair& pair, Group& group, std::uint8_t& has_force) {
  auto& result = pair.result;
  archive.template as<double>(result.distance);
  archive.template as<double>(result.bound);
  archive.template as<double>(pair.margin);
  exchangeVector<float>(archive, result.witness_a);
  exchangeVector<float>(archive, result.witness_b);
  archive.template as<std::int32_t>(result.contacts);
  archive.template as<std::int16_t>(group);
  archive.template as<std::uint8_t>(pair.paused);
  archive.same(has_force);
  archive.check(!std::isinf(result.distance) && !(result.bound < 0.0));
  archive.check(std::isnan(result.distance) == std::isnan(result.bound));
  archive.check(pair.margin >= 0.0 && std::isfinite(pair.margin));
  archive.check(result.contacts >= 0 && has_force <= 1);
}

template <class Archive, class Result>
void exchangeForce(Archive& archive, Result& result) {
  archive.template as<double>(result.depth);
  exchangeVector<double>(archive, result.force_a);
  exchangeVector<double>(archive, result.torque_a);
  exchangeVector<double>(archive, result.torque_b);
  archive.check(result.depth >= 0.0 && std::isfinite(result.depth));
  archive.check(result.force_a.allFinite() && result.torque_a.allFinite() && result.torque_b.allFinite());
}

template <class Archive, class Shown>
void exchangeJoints(Archive& archive, Shown& shown) {
  for (std::size_t i = 0; i < shown.joint_positions.size(); ++i) {
    auto& torque = shown.joint_torques[i];
    auto& axis = shown.movers.joint_axes[i];
    archive.template as<double>(shown.joint_positions[i]);
    archive.template as<double>(torque.contact);
    archive.template as<double>(torque.reaction);
    exchangeVector<float>(archive, axis.p);
    exchangeVector<float>(archive, axis.direction);
    archive.template as<std::uint32_t>(axis.prismatic);
    archive.check(std::abs(shown.joint_positions[i]) <= kMaxCoordinate);
    archive.check(std::isfinite(torque.contact) && std::isfinite(torque.reaction));
    archive.check(axis.p.allFinite() && axis.direction.allFinite());
  }
}

/// All but the header. M: Moment, or const for an archive that writes.
template <class Archive, class M>
void exchangeMoment(Archive& archive, M& moment) {
  auto& shown = moment.shown;
  archive.template as<double>(shown.t);
  archive.template as<double>(shown.cycle_us);
  archive.check(std::isfinite(shown.t) && shown.t >= 0.0 && std::isfinite(shown.cycle_us));
  for (auto* count :
       {&moment.counts.bad, &moment.counts.late, &moment.counts.lost, &moment.counts.duplicates})
    archive.same(*count);
  archive.template as<std::uint32_t>(shown.torques_on);
  for (auto& age : shown.movers.person_age) {
    archive.template as<double>(age);
    archive.check(age >= 0.0);
  }
  for (std::size_t i = 0; i < shown.robots.size(); ++i)
    exchangeRobot(archive, shown.robots[i], moment.input_age[i]);
  exchangeJoints(archive, shown);
  for (auto& group : shown.groups) {
    constexpr std::size_t kGroupStates = 3;
    exchangeEnum(archive, group.state, kGroupStates);
    archive.template as<std::uint32_t>(group.pairs);
  }
  for (auto& object : shown.objects) exchangeObject(archive, object);
  for (std::size_t i = 0; i < shown.pairs.size(); ++i) {
    std::uint8_t has_force = hasForce(shown.pairs[i].result);
    exchangePair(archive, shown.pairs[i], shown.pair_group[i], has_force);
    archive.check(shown.pair_group[i] >= -1 && shown.pair_group[i] < static_cast<int>(shown.groups.size()));
    // Where nothing follows there is no force.
    if constexpr (!std::is_const_v<M>)
      if (has_force == 0) clearForce(shown.pairs[i].result);
    if (has_force == 1) exchangeForce(archive, shown.pairs[i].result);
  }
}

}  // namespace abstand::moment
