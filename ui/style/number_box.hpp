// A field for a number that understands both decimal signs.
#pragma once

#include <QDoubleSpinBox>

namespace abstand::ui {

/// In a language with a decimal comma, a typed point becomes a comma; QDoubleSpinBox would take it for a
/// separator of groups of digits, and 12.5 for 125.
class NumberBox : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;

  QValidator::State validate(QString& text, int& position) const override;
};

}  // namespace abstand::ui
