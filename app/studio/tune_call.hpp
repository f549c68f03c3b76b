// The command line of `abstand tune` for what the window shows.
#pragma once

#include <QStringList>
#include <QTemporaryDir>

#include "core/robot_file/mesh_reference.hpp"
#include "ui/document/work.hpp"

namespace abstand::studio {

/// Path of `abstand`: beside this program, otherwise in PATH; empty if it is in neither.
QString commandLineProgram();

/// Scene, recording, reading options and assumptions of a document as options of `abstand tune`. Files that
/// say what no option can are kept in a temporary folder as long as this lives.
class TuneCall {
 public:
  TuneCall(ui::Work work, robot_file::PackagePaths packages);

  /// Without what is asked for. Throws ParseError, UsageError and WriteError.
  QStringList words() const;
  /// The scene; where the user reads its recordings or builds its people otherwise, or has put it together
  /// from several files, one in the temporary folder that says so. Throws ParseError, UsageError and
  /// WriteError.
  QString sceneFile() const;
  /// A file in the temporary folder.
  QString keep(const QString& name, const std::string& text) const;

 private:
  ui::Work work_;
  robot_file::PackagePaths packages_;
  QTemporaryDir folder_;
};

}  // namespace abstand::studio
