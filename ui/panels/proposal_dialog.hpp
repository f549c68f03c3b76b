// Proposed margins, a sentence a body part, to look at before they are taken.
#pragma once

#include <QDialog>
#include <vector>

#include "ui/model/proposed_rows.hpp"

class QTextBrowser;

namespace abstand::ui {

/// Does not block the window; deletes itself when it is closed. accepted(): the margins shall be taken.
class ProposalDialog : public QDialog {
  Q_OBJECT

 public:
  ProposalDialog(const std::vector<ProposedRow>& rows, QWidget* parent);

  QTextBrowser* sentences() const { return text_; }

 Q_SIGNALS:
  /// The moment that decides a margin (s); indices of the store.
  void picked(double t, int part, int link);

 private:
  void follow(int row);

  std::vector<ProposedRow> rows_;
  QTextBrowser* text_;
};

}  // namespace abstand::ui
