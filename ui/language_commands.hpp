// The choice of the language in the menu View.
#pragma once

class QMainWindow;

namespace abstand::ui {

class Actions;

/// Shows what is chosen, and keeps another choice for the next start.
void connectLanguages(QMainWindow& window, const Actions& actions);

}  // namespace abstand::ui
