// What is being opened.
#pragma once

#include <QFileInfo>
#include <QStringList>
#include <memory>

#include "app/studio/live_opening.hpp"
#include "app/studio/studio.hpp"

namespace abstand::studio {

/// What becomes of the document when the load has succeeded.
struct Studio::Request {
  enum class Kind {
    kNew,        ///< `project` takes its place
    kRecording,  ///< an edit: the recording of `project`
    kPerson,     ///< an edit: `person` as in `project`
    kFiles,      ///< an edit: scene, added files and recording of `project`
    kFollow      ///< nothing: it is as it should be
  };
  Kind kind{Kind::kFollow};
  ui::Project project;
  QString file;
  bool modified{false};
  QString person{};
  std::shared_ptr<LiveSource> live{};  ///< moments of a server in this scene
  ui::Work before{};                   ///< of the document when the request was made
  bool lenient{false};                 ///< files that cannot be read are left out
  bool places{false};                  ///< people stand in front of robots where no file says where they do
  QStringList changed{};               ///< files that were written anew: nobody asked for this load
};

/// Both are shown by the same session.
bool isLoadedAlike(const ui::Work& a, const ui::Work& b);

inline QString absolutePath(const QString& path) {
  return path.isEmpty() ? path : QFileInfo(path).absoluteFilePath();
}

}  // namespace abstand::studio
