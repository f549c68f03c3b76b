// Measures how smoothly the window plays.
#pragma once

#include <QElapsedTimer>
#include <QJsonObject>
#include <QObject>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/studio/stall_watch.hpp"

namespace abstand::ui {
class MainWindow;
}

namespace abstand::studio {

/// Plays what the window shows and counts pictures, stalls and processor time. GUI thread only.
class Probe : public QObject {
 public:
  /// Stalls count from here on as those of opening.
  Probe(ui::MainWindow& window, double seconds, QObject* parent = nullptr);

  /// When the scene is open: plays until its analysis is complete, a second longer, and then for the given
  /// time, which is measured; then measures responses (ResponseProbe), and hands over the figures.
  void start(std::function<void(const QJsonObject&)> done);

 private:
  void watchAnalysis();
  void waitForAnalysis(int waited_ms);
  void begin();
  void count();
  QJsonObject result() const;
  QJsonObject analysisFigures() const;
  void finish();

  ui::MainWindow& window_;
  const double seconds_;
  std::function<void(const QJsonObject&)> done_;
  StallWatch stalls_;
  std::vector<StallWatch::Gap> opening_;
  bool measuring_{false};
  QElapsedTimer wall_, analysis_;  ///< the second since the analysis began
  double first_picture_{0.0};      ///< s since the program was started
  double analysis_s_{0.0};         ///< s, of the whole analysis; 0: not known
  double scene_s_{0.0}, last_t_{0.0};
  double resident_{0.0};
  std::map<std::string, double> processor_;
  std::vector<double> renders_, intervals_, cycles_;  // s, s, us
  double last_picture_{0.0};                          // s
  long pictures_{0}, last_step_{-1};
};

}  // namespace abstand::studio
