// Plots as files: CSV, SVG, PNG.
#pragma once

#include <QString>
#include <vector>

namespace abstand::ui {

class StripChart;

/// Writes the file whole or not at all, by its ending:
/// - .csv: all known values of all series, a row a frame of the finest series; s and the units of the charts;
///   a value that is not known is empty;
/// - .svg, .png: the charts below each other as they are shown, PNG with two pixels for each of the screen.
/// GUI thread only. Throws UsageError for another ending, and WriteError.
void savePlots(const std::vector<StripChart*>& charts, const QString& file);

/// The text of the CSV file.
std::string plotsAsCsv(const std::vector<StripChart*>& charts);

}  // namespace abstand::ui
