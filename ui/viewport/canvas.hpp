// Where VTK draws: a picture in memory, painted like any other widget. VTK: .cpp files only.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QWidget>
#include <vector>

namespace abstand::ui {

/// A QOpenGLWidget would let OpenGL put the whole window together for every picture; where the processor
/// draws, that costs more than the scene. Here OpenGL draws the scene only, and the window stays a raster
/// window. GUI thread only. Needs OpenGL.
class Canvas : public QWidget {
 public:
  explicit Canvas(QWidget* parent);
  ~Canvas() override;

  vtkGenericOpenGLRenderWindow* window() const { return window_; }
  /// Draws the renderers of window() at the widget's size and resolution, and shows that, over the backdrop
  /// where there is one.
  void render();
  /// What stands behind all pictures from here on: what the renderers draw now. Their later pictures must be
  /// transparent.
  void keepBackdrop();
  void dropBackdrop() { backdrop_ = {}; }
  bool hasBackdrop() const { return backdrop_.size() == pixels(); }
  /// As it is shown.
  QImage image() const;
  /// What the renderers draw now at this size (physical pixels), without changing what is shown.
  QImage drawn(const QSize& size);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  bool isCurrent() const;
  QSize pixels() const;
  void draw(QImage& picture, QImage::Format format, const QSize& size);

  QOffscreenSurface surface_;
  QOpenGLContext context_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  std::vector<unsigned char> read_;
  QImage image_, backdrop_;
};

}  // namespace abstand::ui
