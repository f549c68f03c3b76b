// File > Video: plays a range frame by frame and keeps the pictures.
#pragma once

#include <QObject>
#include <QPointer>
#include <memory>

#include "ui/model/time_range.hpp"
#include "ui/model/video_sink.hpp"

class QProgressDialog;
class QWidget;

namespace abstand::ui {

class Playback;
class Viewport;

/// At the recording's own pace and at most 25 pictures a second, however long a picture takes. Frames are
/// stepped through, so that robots that react do so as in play. Afterwards the time is as before. GUI thread
/// only.
class VideoRecorder : public QObject {
  Q_OBJECT

 public:
  static constexpr double kMaxRate = 25.0;  ///< pictures a second

  /// All outlive it; the dialog belongs to `window`.
  VideoRecorder(Playback& playback, Viewport& viewport, QWidget* window);

  /// Without one nothing can be recorded.
  void setMaker(VideoMaker maker) { make_ = std::move(maker); }
  /// Pictures of [range.from, range.to] go to `file`. done() or failed() follows, unless it is cancelled.
  void start(const QString& file, TimeRange range);
  /// Nothing is left of the file.
  void cancel();
  bool canRecord() const { return static_cast<bool>(make_); }
  bool recording() const { return sink_ != nullptr; }
  /// The window shows the moment at `t` (s).
  void onMoment(double t);

 Q_SIGNALS:
  void done(const QString& file);
  void failed(const QString& title, const QString& problem);

 private:
  void takePicture();
  void end();

  Playback& playback_;
  Viewport& viewport_;
  QWidget* window_;
  VideoMaker make_;
  std::unique_ptr<VideoSink> sink_;
  QPointer<QProgressDialog> wait_;
  QString file_;
  double time_before_{0.0};  // s
  long first_{0}, frame_{0}, last_{0};
  int step_{1};         // frames from picture to picture
  bool is_due_{false};  // takePicture() will be called
};

}  // namespace abstand::ui
