// Plots as files.
#include "ui/plots/plot_export.hpp"

#include <gtest/gtest.h>

#include <QImage>
#include <QXmlStreamReader>
#include <sstream>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "ui/plots/strip_chart.hpp"

namespace abstand::ui {
namespace plot_export_test {

struct PlotExport : ::testing::Test {
  PlotExport() {
    for (int i = 0; i <= 10; ++i)
      if (i != 4) distance.add(0.1 * i, 0.5 - 0.01 * i);
    for (int i = 0; i <= 5; ++i) gravity.add(0.2 * i, i);
    torques.setLines({{"contact", Qt::red}, {"gravity", Qt::blue, Qt::DashLine}});
    near.setSeries(&distance);
    torques.setSeries(&gravity, 1);
    for (StripChart* chart : charts) {
      chart->resize(360, 160);
      chart->setWindow(0.0, 1.0);
    }
  }
  QString in(const char* name) const { return QString::fromStdString((folder.path() / name).string()); }

  FrameSeries distance{0.0, 1.0, 0.1, Keep::kSmallest}, gravity{0.0, 1.0, 0.2, Keep::kLargest};
  StripChart near{{"Distance", "mm", 1e3, 1, false}, Qt::black},
      torques{{"Torque", "N·m", 1.0, 1, true}, Qt::black};
  std::vector<StripChart*> charts{&near, &torques};
  testing::ScratchFolder folder;
};

TEST_F(PlotExport, CsvHasEveryKnownValue) {
  std::istringstream in(plotsAsCsv(charts));
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "t [s],\"Distance [mm]\",\"Torque: gravity [N·m]\"");
  int rows = 0;
  while (std::getline(in, line)) {
    std::istringstream row(line);
    double t = -1.0;
    row >> t;
    const int i = static_cast<int>(std::lround(10.0 * t));
    std::string mm;
    row.ignore();
    std::getline(row, mm, ',');
    if (i == 4)
      EXPECT_EQ(mm, "") << "not known";
    else
      EXPECT_NEAR(std::stod(mm), 500.0 - 10.0 * i, 1e-9);
    ++rows;
  }
  EXPECT_EQ(rows, 11);
  EXPECT_EQ(plotsAsCsv({}), "t [s]\n");
}

TEST_F(PlotExport, SvgIsDrawingWithNames) {
  savePlots(charts, in("plots.svg"));
  const std::string text = readFile(in("plots.svg").toStdString(), 1 << 26, true);
  QXmlStreamReader xml(QByteArray::fromStdString(text));
  QString words;
  int lines = 0, images = 0;
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.isCharacters()) words += xml.text();
    lines += xml.isStartElement() &&
             (xml.name() == QLatin1String("polyline") || xml.name() == QLatin1String("path"));
    images += xml.isStartElement() && xml.name() == QLatin1String("image");
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  EXPECT_TRUE(words.contains(QLatin1String("Distance [mm]")));
  EXPECT_TRUE(words.contains(QLatin1String("gravity")));
  EXPECT_TRUE(words.contains(QLatin1String("Time [s]")));
  EXPECT_GT(lines, 3);
  EXPECT_EQ(images, 0);
}

TEST_F(PlotExport, PngShowsLines) {
  savePlots(charts, in("plots.png"));
  const QImage picture(in("plots.png"));
  ASSERT_EQ(picture.width(), 720);
  EXPECT_GT(picture.height(), 640);
  int blue = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor pixel = picture.pixelColor(x, y);
      blue += pixel.blue() > 200 && pixel.red() < 80 && pixel.green() < 80;
    }
  EXPECT_GT(blue, 100) << "the line of gravity";
}

TEST_F(PlotExport, RejectsOtherFormatsAndMissingFolders) {
  EXPECT_THROW(savePlots(charts, in("plots.gif")), UsageError);
  EXPECT_THROW(savePlots(charts, in("nowhere/plots.csv")), std::exception);
}

}  // namespace plot_export_test
}  // namespace abstand::ui
