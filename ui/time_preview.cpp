#include "ui/time_preview.hpp"

#include <QBuffer>
#include <QImage>

#include "ui/model/recording_review.hpp"
#include "ui/style/format.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

namespace {

QString elementOf(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return QStringLiteral("<img src=\"data:image/png;base64,%1\" width=\"%2\" height=\"%3\">")
      .arg(QString::fromLatin1(bytes.toBase64()))
      .arg(image.width())
      .arg(image.height());
}

}  // namespace

QString TimePreview::tip(double t, const QString& text) {
  const view::MomentPoses* poses = review_.posesNear(t);
  if (!poses) return text;
  const CameraView camera = viewport_.cameraView();
  if (picture_.isEmpty() || t_ != poses->t || opened_ != review_.opened() || !(camera_ == camera)) {
    const QImage image = viewport_.preview(*poses, kWidth);
    if (image.isNull()) return text;
    picture_ = elementOf(image);
    t_ = poses->t;
    opened_ = review_.opened();
    camera_ = camera;
  }
  return picture_ + QStringLiteral("<br>") + tr("Picture: %1").arg(secondsWithUnit(poses->t)) +
         QStringLiteral("<br>") + text.toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br>"));
}

}  // namespace abstand::ui
