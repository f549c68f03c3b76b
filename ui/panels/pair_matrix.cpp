#include "ui/panels/pair_matrix.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/model/selection.hpp"

namespace abstand::ui {

namespace {
const view::SceneOutline kNoPairs;
constexpr int kCellWidth = 74, kRowHeight = 24;  // px
}  // namespace

PairMatrix::PairMatrix(Selection& selection, QWidget* parent)
    : QWidget(parent),
      selection_{selection},
      outline_{&kNoPairs},
      model_{new PairMatrixModel(this)},
      table_{new QTableView(this)},
      bodies_{new QComboBox(this)},
      counts_{new QLabel(this)} {
  bodies_->addItem(tr("People and robots"));
  bodies_->addItem(tr("All bodies"));
  bodies_->setAccessibleName(tr("Bodies of the matrix"));
  counts_->setObjectName(QStringLiteral("matrix_counts"));
  table_->setModel(model_);
  table_->setAccessibleName(tr("Matrix of the pairs"));
  table_->setFrameShape(QFrame::NoFrame);
  table_->horizontalHeader()->setDefaultSectionSize(kCellWidth);
  table_->verticalHeader()->setDefaultSectionSize(kRowHeight);
  table_->setToolTip(tr("Ticked: checked, with the distance; hatched: not checked"));
  auto* head = new QHBoxLayout;
  head->setContentsMargins(6, 4, 6, 4);
  head->addWidget(bodies_);
  head->addWidget(counts_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(head);
  layout->addWidget(table_, 1);
  connect(bodies_, qOverload<int>(&QComboBox::currentIndexChanged), this, &PairMatrix::openModel);
  connect(model_, &PairMatrixModel::checkWanted, this, &PairMatrix::checkWanted);
  connect(table_, &QTableView::clicked, this, [this](const QModelIndex& index) {
    const int pair = model_->pairAt(index);
    const auto [a, b] = std::minmax({model_->bodyOfRow(index.row()), model_->bodyOfColumn(index.column())});
    if (pair >= 0)
      selection_.setPair(pair, a, b);
    else if (a != b)
      selection_.setObjects({a, b});
  });
}

void PairMatrix::open(const view::SceneOutline& outline) {
  outline_ = &outline;
  openModel();
}

void PairMatrix::openModel() {
  model_->open(*outline_, bodies_->currentIndex() == 1);
  counts_->clear();
}

void PairMatrix::refresh(const view::SceneSnapshot& snapshot) {
  if (!in_front_ || snapshot.pairs.size() != outline_->pairs.size()) return;
  model_->refresh(snapshot);
  model_->announce();
  const auto paused = std::count_if(snapshot.pairs.begin(), snapshot.pairs.end(),
                                    [](const auto& pair) { return pair.paused; });
  counts_->setText(tr("%1 checked, %2 not")
                       .arg(snapshot.pairs.size() - static_cast<std::size_t>(paused))
                       .arg(outline_->unchecked.size() + static_cast<std::size_t>(paused)));
}

}  // namespace abstand::ui
