#include "ui/model/pose_text.hpp"

#include "core/base/number.hpp"

namespace abstand::ui {

namespace {

QString inJson(QString name) {
  name.replace(QLatin1Char('\\'), QLatin1String("\\\\")).replace(QLatin1Char('"'), QLatin1String("\\\""));
  return QLatin1Char('"') + name + QLatin1Char('"');
}

}  // namespace

QString poseText(PoseFormat format, const QStringList& names, const QVector<double>& values) {
  QStringList parts;
  for (int i = 0; i < values.size(); ++i) {
    const QString number = QString::fromStdString(formatDouble(values[i]));
    parts << (format == PoseFormat::kJson ? inJson(names.value(i)) + QStringLiteral(": ") + number : number);
  }
  const QString list = parts.join(QStringLiteral(", "));
  switch (format) {
    case PoseFormat::kJson:
      return QLatin1Char('{') + list + QLatin1Char('}');
    case PoseFormat::kYaml:
      return QStringLiteral("q: [") + list + QLatin1Char(']');
    case PoseFormat::kCpp:
      return QLatin1Char('{') + list + QLatin1Char('}');
  }
  return {};
}

}  // namespace abstand::ui
