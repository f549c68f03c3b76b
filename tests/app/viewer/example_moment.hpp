// A small scene and a moment of it, with different numbers everywhere.
#pragma once

#include "app/moment/moment_packet.hpp"

namespace abstand::moment {

inline SceneCard exampleCard(std::uint64_t server = 7) {
  SceneCard card;
  card.server = server;
  card.scene = {11, 13};
  card.file = "/scenes/example.yaml";
  card.objects = {"arm/link1", "anna/torso", "wall"};
  card.people = {"anna"};
  card.groups = {"g", "rest"};
  card.robots = {{"arm", 2}};
  card.pairs = {{0, 1}, {0, 2}, {1, 2}};
  return card;
}

/// `t`: s; the distance of pair 0 is `distance` (m).
inline Moment exampleMoment(double t, double distance = 0.25) {
  Moment m = makeMoment(exampleCard());
  view::SceneSnapshot& s = m.shown;
  s.t = t;
  s.cycle_us = 140.5;
  for (std::size_t i = 0; i < s.objects.size(); ++i) {
    view::ObjectSnapshot& o = s.objects[i];
    const auto x = static_cast<double>(i);
    o.X_WB = Eigen::Translation3d(x, 0.1 * x, 1.0 / 3.0) *
             Eigen::AngleAxisd(0.3 + x, Vector3d(1, 2, 3).normalized());
    o.p_WCom = Vector3d(x, 1.0, 0.7);
    o.velocity.linear = Vector3d(0.5, -0.25, x);
    o.margin = 0.05 * x;
    o.pose_uncertainty = i == 1 ? kInfinity : 0.01;
    o.pose_state = i == 1 ? scene::PoseState::kStale : scene::PoseState::kFresh;
  }
  s.pairs[0].result.distance = distance;
  s.pairs[0].result.bound = 0.001;
  s.pairs[0].margin = 0.05;
  s.pairs[0].result.witness_a = Vector3d(0.5, 1.5, 2.5);
  s.pairs[0].result.witness_b = Vector3d(0.5, 1.5, 2.75);
  s.pairs[1].result.distance = -0.01;
  s.pairs[1].result.bound = 0.002;
  s.pairs[1].result.contacts = 3;
  s.pairs[1].result.depth = 0.01;
  s.pairs[1].result.force_a = Vector3d(1.1, 2.2, 3.3);
  s.pairs[1].result.torque_b = Vector3d(0.1, 0.2, 0.3);
  s.objects[0].colliding = s.objects[2].colliding = true;
  s.pairs[2].paused = true;  // its distance is not known
  s.pair_group = {0, 1, -1};
  s.groups[0] = {view::PairGroupState::kPaused, 1};
  s.groups[1] = {view::PairGroupState::kRunning, 1};
  s.torques_on = false;
  s.joint_positions = {0.1, -0.2};
  s.joint_torques[1].contact = 4.5;
  s.movers.person_age = {0.02};
  s.robots[0].state = safety::StopState::kProtectiveStop;
  s.robots[0].cause = {safety::StopReason::kDistance, 0.04, 0.05, 1, -1};
  s.robots[0].since = 0.5 * t;
  s.robots[0].speed_scale = 0.0;
  m.input_age = {0.003};
  m.counts = {1, 2, 3, 4};
  return m;
}

inline std::vector<std::byte> exampleFrame(const Moment& moment, std::uint32_t sequence = 1) {
  std::vector<std::byte> frame(maxMomentBytes(exampleCard()));
  FrameHeader header;
  header.sequence = sequence;
  frame.resize(writeMoment(header, moment, frame));
  return frame;
}

}  // namespace abstand::moment
