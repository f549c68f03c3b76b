// Files for other programs: a stretch of a recording, and the pairs of a robot as SRDF.
#pragma once

#include <QObject>
#include <optional>

#include "core/view/snapshot.hpp"
#include "ui/model/time_range.hpp"

class QWidget;

namespace abstand::ui {

class Actions;
class Selection;
class TimeAxis;

/// Asks what and where; somebody else reads and writes. GUI thread only.
class ExchangeCommands : public QObject {
  Q_OBJECT

 public:
  /// All outlive it; dialogs belong to `window`.
  ExchangeCommands(const Actions& actions, const Selection& selection, const TimeAxis& axis, QWidget* window);

  /// Of the scene that is open; null: none. It must live until the next call.
  void open(const view::SceneOutline* outline);

 Q_SIGNALS:
  /// The recording of a person between IN and OUT.
  void rangeWanted(const QString& person, const abstand::ui::TimeRange& range, const QString& file);
  void pairsWanted(const QString& robot, const QString& file);
  void savePairsWanted(const QString& robot, const QString& file);

 private:
  void saveRange();
  void openPairs();
  void savePairs();
  std::optional<QString> chosen(const QStringList& names, const QString& question);
  QStringList robots() const;
  QString fileToSave(const QString& title, const QString& name, const QString& filter, const QString& suffix,
                     const QString& object);

  const Actions& actions_;
  const Selection& selection_;
  const TimeAxis& axis_;
  QWidget* window_;
  const view::SceneOutline* outline_{nullptr};
};

}  // namespace abstand::ui
