// Pictures of the window, of the 3D view and of the plots, and videos.
#pragma once

#include <QObject>

namespace abstand::ui {

class Actions;
class MainWindow;
class PlotPanel;
class TimeAxis;
class VideoRecorder;
class Viewport;

/// Asks where to save, and saves. GUI thread only.
class PictureCommands : public QObject {
  Q_OBJECT

 public:
  struct Sources {
    Viewport& viewport;
    PlotPanel& plots;
    VideoRecorder& videos;
    const TimeAxis& axis;  ///< a video shows what is between IN and OUT
  };

  /// All outlive it; dialogs belong to `window`.
  PictureCommands(const Actions& actions, const Sources& sources, MainWindow* window);

 Q_SIGNALS:
  /// For the status bar.
  void said(const QString& text);
  void failed(const QString& title, const QString& problem);

 private:
  void copyPicture();
  void saveScreenshot();
  void savePlotsAs();
  void saveVideo();

  Sources from_;
  MainWindow* window_;
};

}  // namespace abstand::ui
