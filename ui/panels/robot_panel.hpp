// The robots that react: state, reason, speed, and what led to it.
#pragma once

#include <QWidget>
#include <set>
#include <vector>

#include "core/view/snapshot.hpp"

class QLabel;
class QPlainTextEdit;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace abstand::ui {

/// A card for each robot of SceneOutline::reacting, and under them a line for each change of a state and for
/// each limit that a joint broke, the newest last. A new beginning of the closed loop empties the log. GUI
/// thread only.
class RobotPanel : public QWidget {
  Q_OBJECT

 public:
  /// Lines that the log keeps.
  static constexpr int kMaxLines = 2000;

  explicit RobotPanel(QWidget* parent = nullptr);

  void open(const view::SceneOutline& outline);
  void refresh(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot);
  /// Whether a reset reaches the robots that are shown; at first: it does.
  void allowReset(bool allowed) { can_reset_ = allowed; }
  const QPlainTextEdit* log() const { return log_; }

 Q_SIGNALS:
  /// The user lets go on what waits for it.
  void resetRequested();
  /// The user wants to see the pair (index of the outline) that holds a robot.
  void pairPicked(int pair);

 private:
  struct Card {
    QLabel *state, *reason;
    QToolButton* select;  ///< of the pair that is the reason
    int pair{-1};         ///< index of the outline; -1: the reason is no pair
  };
  void addCard(const QString& name);
  void showCause(Card& card, int pair);
  void addEntries(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot);

  QLabel* head_;
  QPushButton* reset_;
  bool can_reset_{true};
  QVBoxLayout* cards_layout_;
  std::vector<Card> cards_;
  QPlainTextEdit* log_;
  long loops_{-1};                   ///< SceneSnapshot::loops that the log belongs to
  std::vector<std::size_t> in_log_;  ///< entries of each robot's log that were there already
  std::vector<long> refused_;        ///< resets of each robot that the log tells of
  std::vector<std::set<std::pair<int, mechanism::LimitKind>>>
      broken_;  ///< limits of each robot's joints, likewise
};

}  // namespace abstand::ui
