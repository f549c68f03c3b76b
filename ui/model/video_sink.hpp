// Where the pictures of a video go.
#pragma once

#include <QImage>
#include <QSize>
#include <QString>
#include <functional>
#include <memory>

namespace abstand::ui {

/// A video file that is being written. It appears at finish(), and not at all without it. One thread.
class VideoSink {
 public:
  virtual ~VideoSink() = default;
  /// The next picture, scaled to the size of the video. Throws WriteError.
  virtual void add(const QImage& picture) = 0;
  /// Throws WriteError.
  virtual void finish() = 0;
};

/// Begins a video with `rate` pictures a second. Throws UsageError for a name whose ending stands for no kind
/// of video that can be written here, and WriteError.
using VideoMaker = std::function<std::unique_ptr<VideoSink>(const QString& file, double rate, QSize size)>;

}  // namespace abstand::ui
