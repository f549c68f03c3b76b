// A stretch of a recording as a recording of its own.
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <memory>
#include <thread>

#include "core/robot_file/mesh_reference.hpp"
#include "ui/document/work.hpp"

namespace abstand::studio {

/// Reads the recording that moves `person` in the scene of `work`, as the window reads it, and writes its
/// frames in the range to `file`, with their times. Throws ParseError, UsageError (nobody is moved by a file
/// of joints, or no frame is in the range) and WriteError.
void writeRange(const ui::Work& work, const robot_file::PackagePaths& packages, const std::string& person,
                const ui::TimeRange& range, const QString& file);

/// The same on a thread of its own, one at a time. GUI thread only.
class RangeJob : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  ~RangeJob() override;

  /// done() or failed() follows.
  void start(const ui::Work& work, const robot_file::PackagePaths& packages, const std::string& person,
             const ui::TimeRange& range, const QString& file);

 Q_SIGNALS:
  void done(const QString& file);
  void failed(const QString& problem);

 private:
  std::jthread thread_;
};

}  // namespace abstand::studio
