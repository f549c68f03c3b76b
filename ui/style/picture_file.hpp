// Pictures as files.
#pragma once

#include <QImage>
#include <QString>

namespace abstand::ui {

/// Writes a picture whole or not at all (core/base/output_file.hpp), in the format of the name's ending; PNG
/// where it has none. Throws UsageError and WriteError.
void savePicture(const QImage& picture, const QString& file);

}  // namespace abstand::ui
