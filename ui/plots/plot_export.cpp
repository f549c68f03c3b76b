#include "ui/plots/plot_export.hpp"

#include <QBuffer>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QSvgGenerator>
#include <QWidget>
#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"
#include "ui/plots/strip_chart.hpp"
#include "ui/style/picture_file.hpp"

namespace abstand::ui {

namespace {

constexpr int kGap = 8;            // px between charts
constexpr double kPngScale = 2.0;  // pixels for each of the screen

QSize sizeOf(const std::vector<StripChart*>& charts) {
  QSize size(0, 0);
  for (const StripChart* chart : charts)
    size = {std::max(size.width(), chart->width()), size.height() + chart->height() + kGap};
  return size;
}

void paintAll(QPainter& painter, const std::vector<StripChart*>& charts, const QSize& size) {
  painter.fillRect(QRect(QPoint(0, 0), size), charts.front()->palette().color(QPalette::Window));
  double top = 0.0;
  for (StripChart* chart : charts) {
    chart->paint(painter, QRectF(0.0, top, size.width(), chart->height()));
    top += chart->height() + kGap;
  }
}

void saveSvg(const std::vector<StripChart*>& charts, const QString& file) {
  const QSize size = sizeOf(charts);
  QBuffer bytes;
  QSvgGenerator generator;
  generator.setOutputDevice(&bytes);
  generator.setSize(size);
  generator.setViewBox(QRect(QPoint(0, 0), size));
  QPainter painter(&generator);
  paintAll(painter, charts, size);
  painter.end();
  writeFile(QFile::encodeName(file).toStdString(), bytes.data().toStdString());
}

void savePng(const std::vector<StripChart*>& charts, const QString& file) {
  const QSize size = sizeOf(charts);
  QImage image(size * kPngScale, QImage::Format_RGB32);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(kPngScale, kPngScale);
  paintAll(painter, charts, size);
  painter.end();
  savePicture(image, file);
}

/// A column of the CSV file.
struct Column {
  std::string name;
  const FrameSeries* series;
  double factor;
};

std::vector<Column> columnsOf(const std::vector<StripChart*>& charts) {
  std::vector<Column> columns;
  for (const StripChart* chart : charts)
    for (std::size_t line = 0; line < chart->lines(); ++line)
      if (const FrameSeries* series = chart->series(line))
        columns.push_back({chart->lineName(line).toStdString(), series, chart->factor()});
  return columns;
}

}  // namespace

std::string plotsAsCsv(const std::vector<StripChart*>& charts) {
  const std::vector<Column> columns = columnsOf(charts);
  std::string text = "t [s]";
  const FrameSeries* finest = nullptr;
  for (const Column& column : columns) {
    text += ",\"" + column.name + '"';
    if (!finest || column.series->period() < finest->period()) finest = column.series;
  }
  text += '\n';
  for (std::size_t i = 0; finest && i < finest->size(); ++i) {
    const double t = finest->time(i);
    std::string row = formatDouble(t);
    bool known = false;
    for (const Column& column : columns) {
      const double value = column.series->at(t) * column.factor;
      known |= std::isfinite(value);
      row += std::isfinite(value) ? ',' + formatDouble(value) : ",";
    }
    if (known) text += row + '\n';
  }
  return text;
}

void savePlots(const std::vector<StripChart*>& charts, const QString& file) {
  const QString ending = QFileInfo(file).suffix().toLower();
  if (ending == QLatin1String("csv"))
    return writeFile(QFile::encodeName(file).toStdString(), plotsAsCsv(charts));
  if (ending == QLatin1String("svg")) return saveSvg(charts, file);
  if (ending == QLatin1String("png")) return savePng(charts, file);
  throw UsageError(file.toStdString() + ": found a name that ends in ." + ending.toStdString() +
                   ", expected .csv, .svg or .png");
}

}  // namespace abstand::ui
