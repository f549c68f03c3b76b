// What a robot does for a reason to stop: a choice, and the way back to the scene file.
#pragma once

#include <QWidget>

#include "core/control/reaction_change.hpp"

class QComboBox;
class QLabel;

namespace abstand::ui {

class BackButton;

/// GUI thread only.
class ResponseRow : public QWidget {
  Q_OBJECT

 public:
  explicit ResponseRow(const control::StopChoice& choice, QWidget* parent = nullptr);

  /// As the document has it; without a signal.
  void show(const control::StopChoice& choice);
  safety::StopReason reason() const { return choice_.reason; }
  safety::StopResponse scene() const { return choice_.scene; }
  QComboBox* box() const { return box_; }

 Q_SIGNALS:
  /// The user has chosen another response, or wants that of the scene file.
  void edited(abstand::safety::StopResponse response);

 private:
  control::StopChoice choice_;
  QLabel* name_;
  QComboBox* box_;
  BackButton* back_;
};

}  // namespace abstand::ui
