// In which units lengths and angles are shown.
#pragma once

#include <QObject>

namespace abstand::ui {

enum class LengthUnit { kMillimetre, kMetre };
enum class AngleUnit { kDegree, kRadian };

/// Of the whole program: texts, tables, plots and fields. Files and the clipboard keep theirs. GUI thread
/// only.
class Units : public QObject {
  Q_OBJECT

 public:
  static Units& shown();

  LengthUnit length() const { return length_; }
  AngleUnit angle() const { return angle_; }
  void setLength(LengthUnit unit);
  void setAngle(AngleUnit unit);

 Q_SIGNALS:
  void changed();

 private:
  Units() = default;

  LengthUnit length_{LengthUnit::kMillimetre};
  AngleUnit angle_{AngleUnit::kDegree};
};

}  // namespace abstand::ui
