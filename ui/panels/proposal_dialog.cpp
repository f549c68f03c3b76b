// Proposed margins, a sentence a body part.
#include "ui/panels/proposal_dialog.hpp"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/style/format.hpp"

namespace abstand::ui {

namespace {

QString sentenceOf(const ProposedRow& row, int index) {
  QString text = QStringLiteral("<b>%1</b>: %2").arg(row.name.toHtmlEscaped(), row.sentence.toHtmlEscaped());
  const auto& decided = row.proposal.decided_by;
  if (!decided)
    return row.proposal.judged ? text + ProposalDialog::tr(" No stop was ever needed.").toHtmlEscaped()
                               : text;
  return text + ProposalDialog::tr(
                    " Decided at <a href=\"%1\">%2</a> by %3. Of it: error of the distance %4, pose %5, "
                    "motion in one frame %6.")
                    .arg(index)
                    .arg(secondsWithUnit(decided->t), row.link.toHtmlEscaped(), lengthText(decided->bound),
                         lengthText(decided->pose), lengthText(decided->sampling));
}

}  // namespace

ProposalDialog::ProposalDialog(const std::vector<ProposedRow>& rows, QWidget* parent)
    : QDialog(parent), rows_(rows), text_{new QTextBrowser(this)} {
  setObjectName(QStringLiteral("proposal"));
  setWindowTitle(tr("Proposed margins"));
  setAttribute(Qt::WA_DeleteOnClose);
  setModal(false);
  resize(560, 460);
  auto* head = new QLabel(
      tr("The smallest margin of each body part without a missed stop in this recording, as \"abstand tune\" "
         "proposes it. It holds for this recording alone and replaces no risk assessment."),
      this);
  head->setWordWrap(true);
  QString html;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    html += QStringLiteral("<p>%1</p>").arg(sentenceOf(rows_[i], static_cast<int>(i)));
  text_->setOpenLinks(false);
  text_->setHtml(html);
  text_->setAccessibleName(tr("Proposed margins"));
  connect(text_, &QTextBrowser::anchorClicked, this,
          [this](const QUrl& url) { follow(url.toString().toInt()); });
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  auto* apply = buttons->addButton(tr("&Apply to unlocked rows"), QDialogButtonBox::AcceptRole);
  apply->setEnabled(
      std::any_of(rows_.begin(), rows_.end(), [](const auto& row) { return row.metres.has_value(); }));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(head);
  layout->addWidget(text_, 1);
  layout->addWidget(buttons);
}

void ProposalDialog::follow(int row) {
  if (row < 0 || row >= static_cast<int>(rows_.size())) return;
  const auto& decided = rows_[static_cast<std::size_t>(row)].proposal.decided_by;
  if (decided) Q_EMIT picked(decided->t, static_cast<int>(decided->part), decided->link);
}

}  // namespace abstand::ui
