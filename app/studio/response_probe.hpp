// Measures how soon the window shows what the user asked for.
#pragma once

#include <QElapsedTimer>
#include <QJsonObject>
#include <QObject>
#include <functional>
#include <vector>

namespace abstand::ui {
class MainWindow;
}

namespace abstand::studio {

/// Seeks over the whole recording, then moves the slider of a margin, as a user would, one after the other.
/// A seek ends when the 3D view has drawn the moment that was asked for; a margin when the lanes that show it
/// are painted. GUI thread only.
class ResponseProbe : public QObject {
 public:
  explicit ResponseProbe(ui::MainWindow& window, QObject* parent = nullptr);

  /// While nothing plays. Hands over the figures; a scene of one moment has no seeks, one
  /// without lanes no margins.
  void start(std::function<void(const QJsonObject&)> done);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Waiting { kNothing, kPicture, kLanes };

  void seek();
  void moveMargin();
  /// What was asked for last is shown.
  void shown();
  void next();
  /// Later, if it is still not shown.
  void giveUp();
  void finish();
  /// Object of the first lane's part; -1: there is none.
  int firstPart() const;

  ui::MainWindow& window_;
  std::function<void(const QJsonObject&)> done_;
  QElapsedTimer since_;
  Waiting waiting_{Waiting::kNothing};
  double wanted_{0.0};                   ///< s
  long revision_{0};                     ///< of the review when the slider was moved
  int asked_{0};                         ///< of the present kind
  long attempt_{0};                      ///< of all
  int not_shown_{0};                     ///< within two seconds
  std::vector<double> seeks_, margins_;  ///< s
};

}  // namespace abstand::studio
