// A tour of the window, step by step.
#include "ui/panels/tour.hpp"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace abstand::ui {

namespace {
constexpr int kTourWidth = 400, kTextHeight = 96;  // px
}

Tour::Tour(std::vector<Step> steps, QWidget* parent)
    : QDialog(parent),
      steps_{std::move(steps)},
      title_{new QLabel(this)},
      text_{new QLabel(this)},
      count_{new QLabel(this)},
      back_{new QPushButton(tr("&Back"), this)},
      next_{new QPushButton(this)} {
  setObjectName(QStringLiteral("tour"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Tour"));
  setFixedWidth(kTourWidth);
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  text_->setWordWrap(true);
  text_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  text_->setMinimumHeight(kTextHeight);
  count_->setForegroundRole(QPalette::PlaceholderText);
  auto* end = new QPushButton(tr("&End"), this);
  end->setAutoDefault(false);
  back_->setAutoDefault(false);
  next_->setDefault(true);
  auto* row = new QHBoxLayout;
  row->addWidget(count_, 1);
  row->addWidget(end);
  row->addWidget(back_);
  row->addWidget(next_);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(title_);
  layout->addWidget(text_, 1);
  layout->addLayout(row);
  connect(end, &QPushButton::clicked, this, &QDialog::close);
  connect(back_, &QPushButton::clicked, this, [this] { goTo(step_ - 1); });
  connect(next_, &QPushButton::clicked, this, [this] {
    if (step_ + 1 < static_cast<int>(steps_.size()))
      goTo(step_ + 1);
    else
      close();
  });
  goTo(0);
}

void Tour::goTo(int step) {
  step_ = step;
  const Step& now = steps_[static_cast<std::size_t>(step)];
  if (now.dock) {
    now.dock->show();
    now.dock->raise();
  }
  title_->setText(now.title);
  text_->setText(now.text);
  count_->setText(tr("%1 of %2").arg(step + 1).arg(steps_.size()));
  back_->setEnabled(step > 0);
  next_->setText(step + 1 < static_cast<int>(steps_.size()) ? tr("&Next") : tr("&Done"));
}

}  // namespace abstand::ui
