#include "ui/panels/back_button.hpp"

namespace abstand::ui {

BackButton::BackButton(const QWidget* field, const QString& name, QWidget* parent) : QToolButton(parent) {
  setObjectName(QStringLiteral("back ") + field->objectName());
  setText(QStringLiteral("↺"));
  setAutoRaise(true);
  setFixedSize(20, 22);
  setFocusPolicy(Qt::TabFocus);
  setAccessibleName(tr("%1: back to the scene file").arg(name));
  QSizePolicy kept = sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  setSizePolicy(kept);
}

void BackButton::show(bool differs, const QString& scene) {
  setVisible(differs);
  setToolTip(tr("Back to the scene file: %1").arg(scene));
}

}  // namespace abstand::ui
