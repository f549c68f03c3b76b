#include "ui/video_recorder.hpp"

#include <QProgressDialog>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/model/playback.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

VideoRecorder::VideoRecorder(Playback& playback, Viewport& viewport, QWidget* window)
    : QObject(window), playback_(playback), viewport_(viewport), window_(window) {}

void VideoRecorder::start(const QString& file, TimeRange range) {
  cancel();
  const double period = playback_.framePeriod();
  step_ = std::max(1, static_cast<int>(std::lround(1.0 / (kMaxRate * period))));
  const auto frameAt = [&](double t) { return std::lround((t - playback_.start()) / period); };
  first_ = frame_ = std::clamp(frameAt(range.from), 0L, playback_.frameCount() - 1);
  last_ = std::clamp(frameAt(range.to), first_, playback_.frameCount() - 1);
  try {
    sink_ = make_(file, 1.0 / (step_ * period), viewport_.picture().size());
  } catch (const std::exception& e) {
    Q_EMIT failed(tr("No video"), QString::fromUtf8(e.what()));
    return;
  }
  file_ = file;
  time_before_ = playback_.time();
  wait_ = new QProgressDialog(tr("Making the video…"), tr("Cancel"), 0, static_cast<int>(last_ - first_) + 1,
                              window_);
  wait_->setObjectName(QStringLiteral("video_wait"));
  wait_->setWindowTitle(tr("Video"));
  // What the window shows must not be changed meanwhile.
  wait_->setWindowModality(Qt::WindowModal);
  wait_->setMinimumDuration(0);
  wait_->setAutoClose(false);
  wait_->setAutoReset(false);
  connect(wait_, &QProgressDialog::canceled, this, &VideoRecorder::cancel);
  wait_->show();
  playback_.setPlaying(false);
  playback_.seek(playback_.start() + static_cast<double>(first_) * period);
}

void VideoRecorder::onMoment(double t) {
  const double wanted = playback_.start() + static_cast<double>(frame_) * playback_.framePeriod();
  if (!sink_ || is_due_ || std::abs(t - wanted) > 0.5 * playback_.framePeriod()) return;
  // Later: whoever shows the moment has more to show.
  is_due_ = true;
  QTimer::singleShot(0, this, &VideoRecorder::takePicture);
}

void VideoRecorder::takePicture() {
  is_due_ = false;
  if (!sink_) return;
  try {
    sink_->add(viewport_.picture());
    const long taken = std::exchange(frame_, frame_ + step_);
    // Handles events, a click on Cancel among them.
    wait_->setValue(static_cast<int>(taken - first_) + 1);
    if (!sink_) return;
    if (frame_ <= last_) return playback_.stepFrames(step_);
    sink_->finish();
  } catch (const std::exception& e) {
    end();
    Q_EMIT failed(tr("No video"), QString::fromUtf8(e.what()));
    return;
  }
  end();
  Q_EMIT done(file_);
}

void VideoRecorder::cancel() {
  if (sink_) end();
}

void VideoRecorder::end() {
  sink_.reset();
  if (wait_) wait_->deleteLater();
  wait_.clear();
  playback_.seek(time_before_);
}

}  // namespace abstand::ui
