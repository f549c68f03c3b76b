// What an empty window offers.
#pragma once

#include <QFrame>

class QVBoxLayout;

namespace abstand::ui {

class Actions;

/// Stands in the middle of its parent while nothing is open: what can be opened, the demonstration, recent
/// files, the tour. GUI thread only.
class StartPage : public QFrame {
  Q_OBJECT

 public:
  /// `demonstration`: a scene; empty: there is none. The actions outlive it.
  StartPage(const Actions& actions, const QString& demonstration, QWidget* parent);

  /// With the recent files as they are now.
  void open(const QStringList& recent);

 Q_SIGNALS:
  void fileWanted(const QString& file);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();

  const Actions& actions_;
  QString demonstration_;
  QVBoxLayout* layout_;
  QVBoxLayout* recent_;
};

}  // namespace abstand::ui
