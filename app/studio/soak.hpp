// Memory over hours of work in the window.
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

/// Plays in a loop, and carries out a command each second as a user would: seeks, margins and their undo,
/// views, layouts, themes, now and then the scene anew. Measures memory meanwhile. GUI thread only.
class Soak : public QObject {
 public:
  Soak(ui::MainWindow& window, double seconds, QObject* parent = nullptr);

  /// When the scene is open. Hands over the figures after the given time: memory over time, and its growth in
  /// MB an hour after the first ten minutes, or after the first tenth of less than twenty (caches fill up in
  /// it).
  void start(std::function<void(const QJsonObject&)> done);

 private:
  struct Sample {
    double t;          ///< s since the start
    double resident;   ///< MB
    double allocated;  ///< MB that the process holds of the heap
  };

  void act();
  void measure();
  QJsonObject result() const;

  ui::MainWindow& window_;
  const double seconds_;
  std::function<void(const QJsonObject&)> done_;
  QElapsedTimer wall_;
  std::vector<Sample> samples_;
  long pictures_{0}, acted_{0}, opened_{0};
};

}  // namespace abstand::studio
