// What a user makes of a scene, as values.
#pragma once

#include <QByteArray>
#include <QMap>
#include <QMetaType>
#include <QPair>
#include <QSet>
#include <QString>
#include <QStringList>
#include <QVector>
#include <optional>

#include "core/control/reaction_change.hpp"
#include "core/view/snapshot.hpp"
#include "ui/document/camera_view.hpp"
#include "ui/document/placement.hpp"
#include "ui/document/sensor_plan.hpp"
#include "ui/document/view_options.hpp"
#include "ui/model/separation_settings.hpp"
#include "ui/model/time_range.hpp"
#include "ui/model/what_if_settings.hpp"

namespace abstand::ui {

/// A moment to come back to.
struct Bookmark {
  double t{0.0};  ///< s
  QString note;   ///< one line; may be empty
  std::optional<CameraView> camera;
  bool operator==(const Bookmark&) const = default;
};

/// How a recording is understood that replaces those of the scene.
struct ReadingOptions {
  QString units;           ///< as `units` of a scene's recording ("cm"); empty: as the scene says
  QString up;              ///< as `up` of a scene's recording ("y"); empty: as the scene says
  QString mirror;          ///< as `mirror` of a scene's recording ("sides"); empty: as the scene says
  QString joint_map;       ///< absolute path of a joint map; empty: as the scene says
  double speed{1.0};       ///< 2: people move twice as fast as recorded; greater than 0
  bool cut_things{false};  ///< robots and objects of the scene are cut out of depth images
  bool operator==(const ReadingOptions&) const = default;
};

/// What replaces the scene's description of a person. What is not set is as in the scene.
struct PersonOptions {
  std::optional<double> stature;     ///< m
  std::optional<double> percentile;  ///< per cent, of girths, breadths and depths
  std::optional<double> mass;        ///< kg
  QString sex;                       ///< "f", "m"; empty: as in the scene
  bool operator==(const PersonOptions&) const = default;
};

/// Margin of all pairs of a class, which replaces the sums of the objects' margins.
struct ClassMargin {
  double metres{0.0};
  bool locked{false};  ///< stays as it is
  bool operator==(const ClassMargin&) const = default;
};

/// Everything that can be undone. Objects, groups and pairs go by their names, so that they outlive another
/// recording and a scene that was edited. What is not named here is as the scene file says.
struct Work {
  QString scene;            ///< absolute path; empty: none
  QString recording;        ///< absolute path; empty: those of the scene
  QStringList recordings;   ///< absolute paths of those to choose from; empty: nothing to choose
  QStringList added_files;  ///< absolute paths of robots and meshes that the scene does not name
  ReadingOptions reading;
  QMap<QString, PersonOptions> people;   ///< those that differ from the scene
  QMap<QString, Placement> placed;       ///< of people (their recordings) and robots (their bases), by name
  QMap<QString, Placement> things;       ///< of objects of the room, by name
  QMap<QString, QVector<double>> posed;  ///< rad or m, all joints of each robot that is posed by hand
  QMap<QString, control::ReactionChange> reactions;  ///< of robots with a reaction that differ from the scene
  QMap<QString, double> margins;                     ///< m, by object
  QMap<QString, ClassMargin> classes;                ///< by a name of view::kPairClassNames
  QSet<QString> locked;                              ///< objects whose margin stays as it is
  std::optional<QMap<QString, double>> compared;     ///< m, by object: what the margins are compared with
  QMap<QString, view::PairGroupState> groups;        ///< by name of a pair group
  QMap<QPair<QString, QString>, QString> moved;      ///< pair -> group that it was moved to; empty: none
  QSet<QPair<QString, QString>> added;               ///< pairs that the scene leaves out and that are checked
  QSet<QString> hidden;                              ///< objects that the 3D view leaves out
  QVector<Bookmark> bookmarks;                       ///< in order of time
  std::optional<TimeRange> range;  ///< between the marks IN and OUT; none: the whole recording
  SeparationSettings separation;
  WhatIfSettings what_if;
  std::optional<SensorPlan> sensor;  ///< planned depth camera; none: there is none
  ViewOptions view;

  /// There is nothing to load.
  bool showsNothing() const { return scene.isEmpty() && recording.isEmpty() && added_files.isEmpty(); }
  bool operator==(const Work&) const = default;
};

/// What goes into a project file but is not undone: where the user was.
struct Viewpoint {
  std::optional<CameraView> camera;  ///< none: the whole scene from a corner
  double t{0.0};                     ///< s
  QByteArray layout{};               ///< of the panels, as QMainWindow::saveState() gives it; empty: any
  bool operator==(const Viewpoint&) const = default;
};

/// The content of a project file.
struct Project {
  Work work;
  Viewpoint viewpoint;
  bool operator==(const Project&) const = default;
};

}  // namespace abstand::ui

Q_DECLARE_METATYPE(abstand::ui::Project)
Q_DECLARE_METATYPE(abstand::ui::PersonOptions)
