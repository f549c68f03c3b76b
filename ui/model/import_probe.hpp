// What a recording looks like when it is read in a certain way.
#pragma once

#include <QMetaType>
#include <QString>
#include <QStringList>
#include <array>
#include <functional>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::ui {

/// How a recording shall be read. Empty words: as the file says or as it is guessed.
struct ImportWish {
  QString units, up, mirror;  ///< words of a scene's recording
  /// For each joint of ImportFound::canonical the name in the file, empty: none; no list: as the program
  /// finds.
  QStringList joints;
  bool operator==(const ImportWish&) const = default;
};

/// What was found. Lengths in m, z up.
struct ImportFound {
  QString problem;  ///< it cannot be read so; empty: it can
  QString format, units, up, sides, joint_map, reason;
  bool units_guessed{false}, up_guessed{false}, map_guessed{false};
  double stature{0.0};   ///< m; 0: not known
  double duration{0.0};  ///< s
  std::size_t frame_count{0};
  QStringList names;      ///< of the file
  QStringList canonical;  ///< joints of the skeleton
  QStringList used;       ///< for each of them the names in the file, joined by " + "; empty: none
  QStringList missing_parts, warnings;
  QString map_text;  ///< of a file that gives these joints again; empty: it has none (markers)

  struct Frame {
    double t{0.0};                 ///< s
    std::vector<Vector3d> joints;  ///< in the order of `canonical`; NaN: not known
  };
  std::vector<Frame> frames;  ///< some hundreds, evenly over the recording
};

/// Reads a file; called on a thread of its own, never two at a time.
using ImportReader = std::function<ImportFound(const QString& file, const ImportWish& wish)>;

}  // namespace abstand::ui

Q_DECLARE_METATYPE(abstand::ui::ImportFound)
