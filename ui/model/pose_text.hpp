// The joints of a robot as text, for other programs.
#pragma once

#include <QString>
#include <QStringList>
#include <QVector>

namespace abstand::ui {

enum class PoseFormat { kJson, kYaml, kCpp };

/// rad and m, with all digits, in the C locale. JSON: an object of names; YAML: the key `q` of a scene; C++:
/// a braced list.
QString poseText(PoseFormat format, const QStringList& names, const QVector<double>& values);

}  // namespace abstand::ui
