// How well the engine computes on this machine, as `abstand verify` finds it.
#pragma once

#include <QMetaType>
#include <QString>
#include <QStringList>
#include <vector>

namespace abstand::ui {

/// What is asked for.
struct VerificationRequest {
  bool quick{true};  ///< 3,000 poses instead of 100,000; limits are the same
  QString family;    ///< of checks; empty: all
};

/// One check: numbers are of `quantity`, one for each pose. NaN: not known.
struct VerificationRow {
  QString name;      ///< "bound.mixed"
  QString what;      ///< what is tested, a sentence
  QString quantity;  ///< what the numbers are, with unit
  QString reason;    ///< of the limit
  qulonglong poses{0}, breaches{0};
  double p50{0.0}, p99{0.0}, worst{0.0}, limit{0.0};
  bool passed{false};
};

/// What is new since the last time.
struct VerificationNews {
  QString family;     ///< the family of checks that runs now
  double share{0.0};  ///< of all families, 0 to 1
  std::vector<VerificationRow> rows;
  bool ended{false};
  bool passed{false};  ///< all checks, once it has ended
};

}  // namespace abstand::ui

Q_DECLARE_METATYPE(abstand::ui::VerificationRequest)
Q_DECLARE_METATYPE(abstand::ui::VerificationNews)
