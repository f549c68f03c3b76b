// The page of shortcuts and the about box.
#pragma once

#include <QString>

class QWidget;

namespace abstand::ui {

class Actions;

/// The page as rich text, made from the actions.
QString shortcutPage(const Actions& actions);
void showShortcuts(const Actions& actions, QWidget* parent);
void showAbout(QWidget* parent);

}  // namespace abstand::ui
