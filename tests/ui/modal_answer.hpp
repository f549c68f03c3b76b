// Answers dialogs that wait for the user.
#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QTimer>
#include <functional>

namespace abstand::ui {

/// As long as it lives, waits for the modal dialog of that object name, and treats it once.
class ModalAnswer {
 public:
  ModalAnswer(const QString& dialog, std::function<void(QWidget*)> answer) {
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this, dialog, answer = std::move(answer)] {
      QWidget* modal = QApplication::activeModalWidget();
      if (!modal || modal->objectName() != dialog || !modal->isVisible()) return;
      timer_.stop();
      answered_ = true;
      answer(modal);
    });
    timer_.start(10);
  }
  /// Clicks the button whose text contains `word`.
  static ModalAnswer click(const QString& dialog, const QString& word) {
    return {dialog, [word](QWidget* modal) {
              for (QAbstractButton* button : modal->findChildren<QAbstractButton*>())
                if (button->text().remove('&').contains(word)) return button->click();
            }};
  }
  /// Chooses a file of a file dialog.
  static ModalAnswer choose(const QString& dialog, const QString& file) {
    return {dialog, [file](QWidget* modal) {
              auto* files = static_cast<QFileDialog*>(modal);
              // selectFile() leaves the name alone where its field has the keyboard.
              files->selectFile(file);
              if (auto* name = files->findChild<QLineEdit*>("fileNameEdit")) name->setText(file);
              QMetaObject::invokeMethod(files, "accept");
            }};
  }
  bool answered() const { return answered_; }

 private:
  QTimer timer_;
  bool answered_{false};
};

}  // namespace abstand::ui
