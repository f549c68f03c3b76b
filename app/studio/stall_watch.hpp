// How long the GUI thread does not come back to its event loop.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <vector>

namespace abstand::studio {

/// Times between ticks of a 2 ms timer. GUI thread only.
class StallWatch : public QObject {
 public:
  struct Gap {
    double seconds;    ///< wall time
    double processor;  ///< s of processor time of the GUI thread within it
  };

  explicit StallWatch(QObject* parent = nullptr);
  /// Forgets what was measured.
  void restart();
  /// Those of at least 20 ms.
  const std::vector<Gap>& gaps() const { return gaps_; }

 private:
  void tick();

  QTimer timer_;
  QElapsedTimer since_;
  double processor_{0.0};
  std::vector<Gap> gaps_;
};

}  // namespace abstand::studio
