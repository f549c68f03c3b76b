// The margin panel with its search field and menus.
#pragma once

#include <QWidget>

class QLineEdit;

namespace abstand::ui {

class Actions;
class MarginPanel;

/// GUI thread only.
class MarginTools : public QWidget {
  Q_OBJECT

 public:
  /// Takes the panel over; the actions outlive it.
  MarginTools(MarginPanel* panel, const Actions& actions, QWidget* parent = nullptr);

  QLineEdit* search() const { return search_; }

 private:
  QLineEdit* search_;
};

}  // namespace abstand::ui
