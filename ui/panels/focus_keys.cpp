#include "ui/panels/focus_keys.hpp"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QApplication>
#include <QKeyEvent>
#include <QTreeView>

namespace abstand::ui {

namespace {

bool isMove(int key) {
  switch (key) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      return true;
    default:
      return false;
  }
}

bool wants(const QWidget* widget, const QKeyEvent* event) {
  if ((event->modifiers() & ~Qt::KeypadModifier) != Qt::NoModifier) return false;
  const bool space = event->key() == Qt::Key_Space;
  if (qobject_cast<const QAbstractSlider*>(widget)) return isMove(event->key());
  if (qobject_cast<const QTreeView*>(widget)) return space || isMove(event->key());
  if (qobject_cast<const QAbstractItemView*>(widget)) return isMove(event->key());
  // A click gives no such button the focus, so that Space plays after it.
  return space && qobject_cast<const QAbstractButton*>(widget) && widget->focusPolicy() == Qt::TabFocus;
}

}  // namespace

FocusKeys::FocusKeys(QObject* parent) : QObject(parent) { qApp->installEventFilter(this); }

bool FocusKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride || watched != QApplication::focusWidget()) return false;
  if (!wants(static_cast<QWidget*>(watched), static_cast<QKeyEvent*>(event))) return false;
  event->accept();
  return true;
}

}  // namespace abstand::ui
