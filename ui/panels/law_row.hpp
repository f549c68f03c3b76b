// A number of a law: field, unit, what is wrong with it, and the way back to the scene file.
#pragma once

#include <QWidget>

#include "core/control/reaction_change.hpp"

class QLabel;
class QLineEdit;

namespace abstand::ui {

class BackButton;

/// The owner decides whether typed numbers are valid, and answers with show() or refuse(). GUI thread only.
class LawRow : public QWidget {
  Q_OBJECT

 public:
  /// `joints`: of the robot.
  LawRow(const control::LawNumber& number, int joints, QWidget* parent = nullptr);

  /// As the document has it. What the user is typing stays, unless `overwrite`.
  void show(const control::LawNumber& number, bool overwrite = false);
  /// States below the field why its text has no effect.
  void refuse(const QString& why);
  const std::string& key() const { return number_.key; }
  const config::JointNumbers& scene() const { return number_.scene; }
  QLineEdit* field() const { return field_; }
  /// Why the text of the field has no effect; empty: it has.
  QString refusal() const;

 Q_SIGNALS:
  /// The user has typed other numbers.
  void edited(const abstand::config::JointNumbers& numbers);
  /// The user wants the number of the scene file.
  void backWanted();
  /// The user has left the field.
  void left();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void take();
  void step(int steps);

  control::LawNumber number_;
  int joints_;
  QLabel* name_;
  QLineEdit* field_;
  BackButton* back_;
  QLabel* refusal_;
};

}  // namespace abstand::ui
