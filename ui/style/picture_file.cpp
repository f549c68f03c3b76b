// Pictures as files.
#include "ui/style/picture_file.hpp"

#include <QBuffer>
#include <QFile>
#include <QFileInfo>

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"

namespace abstand::ui {

void savePicture(const QImage& picture, const QString& file) {
  const QString ending = QFileInfo(file).suffix();
  const QByteArray format = ending.isEmpty() ? QByteArray("png") : ending.toLatin1().toLower();
  QBuffer bytes;
  if (!bytes.open(QIODevice::WriteOnly) || !picture.save(&bytes, format.constData()))
    throw UsageError(file.toStdString() + ": found a name that ends in ." + ending.toStdString() +
                     ", expected .png");
  OutputFile out(QFile::encodeName(file).toStdString());
  out.stream().write(bytes.data().constData(), bytes.data().size());
  out.commit();
}

}  // namespace abstand::ui
