// The events of a recording under the present margins.
#include "ui/model/event_table_model.hpp"

#include <QColor>
#include <cmath>

#include "ui/model/event_text.hpp"
#include "ui/style/format.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/theme.hpp"
#include "ui/style/units.hpp"

namespace abstand::ui {

EventTableModel::EventTableModel(const RecordingReview& review, QObject* parent)
    : QAbstractTableModel(parent), review_(review) {
  connect(&Units::shown(), &Units::changed, this, [this] {
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
  });
}

void EventTableModel::refresh() {
  beginResetModel();
  events_ = review_.events();
  endResetModel();
}

int EventTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(events_.size());
}

int EventTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant EventTableModel::text(const RecordingEvent& event, int column) const {
  switch (column) {
    case kTime:
      return secondsWithUnit(event.t0);
    case kDuration:
      return secondsWithUnit(event.t1 - event.t0);
    case kKind:
      return kindText(event.kind);
    case kPart:
      return subjectText(review_, event);
    case kStop:
      return stopText(event);
    default:
      break;
  }
  if (event.part < 0) return {};
  const margin::ClearanceStore& store = *review_.store();
  const margin::ClearanceChunk::Nearest nearest =
      store.nearest(static_cast<std::size_t>(event.part), event.frame);
  switch (column) {
    case kLink:
      return linkText(store, static_cast<std::size_t>(event.link));
    case kClearance:
      return std::isinf(event.min_clearance) ? tr("not known") : lengthText(event.min_clearance);
    case kError:
      return std::isinf(nearest.clearance) ? tr("not seen")
                                           : lengthText(nearest.distance - nearest.clearance);
    case kClosing:
      return std::isfinite(nearest.closing) ? tr("%1 m/s").arg(fixed(nearest.closing, 2)) : QString();
    default:
      return {};
  }
}

QVariant EventTableModel::key(const RecordingEvent& event, int column) const {
  switch (column) {
    case kTime:
      return event.t0;
    case kDuration:
      return event.t1 - event.t0;
    case kKind:
      return -static_cast<int>(event.kind);
    default:
      break;
  }
  // Stops of robots have no clearance: last.
  const bool of_part = event.part >= 0 && review_.store();
  const auto nearest = of_part ? review_.store()->nearest(static_cast<std::size_t>(event.part), event.frame)
                               : margin::ClearanceChunk::Nearest{};
  switch (column) {
    case kClearance:
      return of_part ? event.min_clearance : kInfinity;
    case kError:
      return of_part ? nearest.distance - nearest.clearance : kInfinity;
    case kClosing:
      return of_part ? nearest.closing : -kInfinity;
    default:
      return text(event, column);
  }
}

QVariant EventTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const RecordingEvent& event = at(index.row());
  // Of another recording, until refresh().
  if (event.part >= 0 && (!review_.store() || event.frame >= review_.store()->frames())) return {};
  const bool number = index.column() != kKind && index.column() != kPart && index.column() != kLink &&
                      index.column() != kStop;
  switch (role) {
    case Qt::DisplayRole:
      return text(event, index.column());
    case kSortRole:
      return key(event, index.column());
    case Qt::DecorationRole:
      return index.column() == kKind ? QVariant(swatch(kindColour(event.kind))) : QVariant();
    case Qt::TextAlignmentRole:
      return static_cast<int>((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::ForegroundRole:
      if (index.column() == kStop && event.missed) return QColor(kVermillion);
      return {};
    case Qt::ToolTipRole:
      return eventText(review_, event);
    default:
      return {};
  }
}

QVariant EventTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  struct Head {
    const char *name, *tip;
  };
  static constexpr Head kHeads[kColumns] = {
      {QT_TR_NOOP("Time"), QT_TR_NOOP("When it begins")},
      {QT_TR_NOOP("Duration"), QT_TR_NOOP("How long it lasts")},
      {QT_TR_NOOP("Event"),
       QT_TR_NOOP("Touching: it is not certain that the surfaces are apart; inside margin: "
                  "nothing touches;\ntouch between frames: two frames outside of the "
                  "margin between which a touch is not excluded;\nnear miss: nearer "
                  "than twice the margin, never inside;\nrobot stopped: as it was played; "
                  "tracking lost: body parts that are not seen or whose poses are old")},
      {QT_TR_NOOP("Part"), QT_TR_NOOP("The part of the person, or the robot that stopped")},
      {QT_TR_NOOP("Link"), QT_TR_NOOP("The nearest link of a robot")},
      {QT_TR_NOOP("Smallest clearance"),
       QT_TR_NOOP("Certified: the true distance was never below it, had the robot not stopped")},
      {QT_TR_NOOP("Error"),
       QT_TR_NOOP("By how much the measured distance may be too large: engine and pose")},
      {QT_TR_NOOP("Closing"), QT_TR_NOOP("Speed of the nearest points towards each other at the smallest "
                                         "clearance; negative: they move apart")},
      {QT_TR_NOOP("Stop"),
       QT_TR_NOOP("Outcome of a stop at the beginning. Missed: too late, or not triggered;\n"
                  "false: not needed; empty: needed and in time")}};
  if (role == Qt::DisplayRole) return tr(kHeads[section].name);
  if (role == Qt::ToolTipRole) return tr(kHeads[section].tip);
  return {};
}

}  // namespace abstand::ui
