// A project in which everything is set.
#pragma once

#include "ui/document/work.hpp"

namespace abstand::ui {

inline Project sampleProject() {
  Project project;
  Work& work = project.work;
  work.scene = "/cell/scenes/hug \"one\".yaml";
  work.recording = "/recordings/Bücher/walk.bvh";
  work.added_files = QStringList{"/cell/arm.urdf", "/cell/table \"old\".stl"};
  work.reading = {"cm", "-y", "sides", "/recordings/own.map", 1.5, true};
  work.what_if = {0.05, 0.25, 1.0 / 3.0, 2.0, 0.003, 0.04};
  work.separation.options.reaction_time = 0.25;
  work.separation.options.person_acceleration = 9.0;
  work.separation.robot_mass = 1.0 / 3.0;
  work.separation.clamped = true;
  work.view.min_force = 1.0 / 3.0;
  work.view.metres_per_newton = 0.004;
  work.people = {{"operator", {1.0 / 0.6, 95.0, 81.5, "f"}},
                 {"visitor", {std::nullopt, 5.0, std::nullopt, ""}}};
  work.recordings = QStringList{"/recordings/Bücher/walk.bvh", "/recordings/turn.csv"};
  work.placed = {{"operator", {{1.0 / 3.0, -2.0, 0.0}, {0.0, 0.0, 1.0 / 7.0}}},
                 {"arm", {{0.0, 0.0, 0.8}, {3.0, -0.1, 0.2}}}};
  work.things = {{"table \"old\"", {{0.1, 1e-9, 0.7}, {0.0, 0.5, -1.5}}}};
  work.posed = {{"arm", {0.1, -1.0 / 3.0, 0.0}}};
  control::ReactionChange change;
  change.laws = {{"repulsion", false}, {"speed", true}};
  change.numbers = {{"torque.gain", {1.0 / 3.0}},
                    {"torque.limit", {20.0, kInfinity, 0.1}},
                    {"stop.distance", {-kInfinity}},
                    {"stop.resume_after", {kInfinity}}};
  change.responses = {{"lost_person", safety::StopResponse::kEmergency},
                      {"torque", safety::StopResponse::kSlow}};
  work.reactions = {{"arm", change}};
  work.margins = {{"operator/hand_left", 0.1}, {"arm/link1", 1.0 / 3.0}};
  work.classes = {{"robot_robot", {0.01, true}}, {"person_robot", {1.0 / 3.0, false}}};
  work.locked = {"operator/hand_left", "table"};
  work.compared = QMap<QString, double>{{"operator/head", 0.07}};
  work.groups = {{"people", view::PairGroupState::kPaused}, {"things", view::PairGroupState::kStopped}};
  work.moved = {{{"arm/link1", "table"}, "people"}, {{"arm/link2", "table"}, ""}};
  work.added = {{"operator/head", "operator/foot_left"}, {"arm/link1", "arm/link2"}};
  work.hidden = {"table", "ball", "arm/link0"};
  work.bookmarks = {{0.1, "first \\ \"contact\"", std::nullopt},
                    {2.5, "", CameraView{{0.1, -0.2, 1e-9}, 2.0, -3.1, 0.7}}};
  work.range = TimeRange{0.3, 11.7};
  work.view.forces = false;
  work.view.velocities = true;
  work.view.human_opacity = 0.35;
  project.viewpoint = {CameraView{{1.0 / 7.0, 2.0, 0.9}, 5.5, 0.25, -0.125}, 6.02,
                       QByteArray("\0\xff layout", 9)};
  return project;
}

}  // namespace abstand::ui
