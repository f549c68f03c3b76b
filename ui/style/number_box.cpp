#include "ui/style/number_box.hpp"

namespace abstand::ui {

QValidator::State NumberBox::validate(QString& text, int& position) const {
  const QChar sign = locale().decimalPoint();
  if (sign != QLatin1Char('.')) {
    const int end = text.endsWith(suffix()) ? text.size() - suffix().size() : text.size();
    for (int i = prefix().size(); i < end; ++i)
      if (text[i] == QLatin1Char('.')) text[i] = sign;
  }
  return QDoubleSpinBox::validate(text, position);
}

}  // namespace abstand::ui
