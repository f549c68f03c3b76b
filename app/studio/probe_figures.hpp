// Figures of the probes as JSON.
#pragma once

#include <QJsonObject>
#include <vector>

namespace abstand::studio {

/// To this number of decimals.
double rounded(double value, int decimals = 2);

/// Median, 99th percentile and maximum of the values times `factor`; null of nothing.
QJsonObject spread(const std::vector<double>& values, double factor);

}  // namespace abstand::studio
