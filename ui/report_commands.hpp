// File > Report: the question, the wait and the answer.
#pragma once

#include <QObject>
#include <QPointer>

#include "ui/model/report_request.hpp"

class QProgressDialog;
class QWidget;

namespace abstand::ui {

/// Somebody else makes the report: of wanted() until done(), failed() or cancelled(). One at a time. Dialogs
/// belong to `window`. GUI thread only.
class ReportCommands : public QObject {
  Q_OBJECT

 public:
  explicit ReportCommands(QWidget* window);

  /// Asks for the rest of the request, beginning with the assumptions of the window.
  void ask(const std::string& margin_set, const QString& scene_name, const WhatIfSettings& what_if);
  /// The page was written.
  void done(const QString& file);
  /// It was not; nothing was written.
  void fail(const QString& problem);
  bool waiting() const { return !wait_.isNull(); }

 Q_SIGNALS:
  void wanted(const abstand::ui::ReportRequest& request);
  void cancelled();
  void failed(const QString& title, const QString& problem);

 private:
  void endWait();

  QWidget* window_;
  ReportRequest last_;
  QPointer<QProgressDialog> wait_;
};

}  // namespace abstand::ui
