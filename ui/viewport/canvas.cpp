// Where VTK draws.
#include "ui/viewport/canvas.hpp"

#include <vtkCommand.h>
#include <vtkOpenGLFramebufferObject.h>

#include <QOpenGLFunctions>
#include <QPaintEvent>
#include <QPainter>
#include <cstring>

namespace abstand::ui {

namespace {

/// Calls a member without arguments when VTK asks for something.
template <class Call>
class AnswerCommand : public vtkCommand {
 public:
  static AnswerCommand* make(Call call) {
    auto* made = new AnswerCommand;
    made->call_ = new Call(std::move(call));
    return made;
  }
  void Execute(vtkObject*, unsigned long, void*) override { (*call_)(); }

 private:
  AnswerCommand() = default;
  ~AnswerCommand() override { delete call_; }
  Call* call_{nullptr};
};

template <class Call>
void answer(vtkObject* asker, unsigned long event, Call call) {
  auto* command = AnswerCommand<Call>::make(std::move(call));
  asker->AddObserver(event, command);
  command->Delete();
}

}  // namespace

Canvas::Canvas(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  const QSurfaceFormat format = QSurfaceFormat::defaultFormat();
  surface_.setFormat(format);
  surface_.create();
  context_.setFormat(format);
  context_.create();
  context_.makeCurrent(&surface_);
  answer(window_, vtkCommand::WindowMakeCurrentEvent, [this] {
    if (!isCurrent()) context_.makeCurrent(&surface_);
  });
  answer(window_, vtkCommand::WindowIsCurrentEvent, [this] { window_->SetIsCurrent(isCurrent()); });
  window_->SetReadyForRendering(true);
  window_->SetOwnContext(0);
  window_->SetMapped(1);
  window_->SetIsDirect(1);
  window_->SetSupportsOpenGL(1);
  window_->SetFrameBlitModeToNoBlit();
  window_->OpenGLInit();
}

Canvas::~Canvas() {
  context_.makeCurrent(&surface_);
  window_->Finalize();
  context_.doneCurrent();
}

bool Canvas::isCurrent() const { return QOpenGLContext::currentContext() == &context_; }

QSize Canvas::pixels() const {
  return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo(QSize(1, 1));
}

void Canvas::draw(QImage& picture, QImage::Format format, const QSize& size) {
  if (!isCurrent()) context_.makeCurrent(&surface_);
  window_->SetSize(size.width(), size.height());
  window_->Render();
  if (picture.size() != size || picture.format() != format) picture = QImage(size, format);
  picture.setDevicePixelRatio(devicePixelRatioF());
  read_.resize(static_cast<std::size_t>(picture.sizeInBytes()));
  vtkOpenGLFramebufferObject* drawn = window_->GetDisplayFramebuffer();
  drawn->Bind(GL_READ_FRAMEBUFFER);
  drawn->ActivateReadBuffer(0);
  QOpenGLFunctions* gl = context_.functions();
  gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl->glReadPixels(0, 0, size.width(), size.height(), GL_BGRA, GL_UNSIGNED_BYTE, read_.data());
  // OpenGL counts rows from below.
  const auto row = static_cast<std::size_t>(picture.bytesPerLine());
  for (int y = 0; y < size.height(); ++y)
    std::memcpy(picture.scanLine(size.height() - 1 - y), read_.data() + static_cast<std::size_t>(y) * row,
                row);
}

void Canvas::render() {
  draw(image_, backdrop_.isNull() ? QImage::Format_RGB32 : QImage::Format_ARGB32_Premultiplied, pixels());
  update();
}

void Canvas::keepBackdrop() { draw(backdrop_, QImage::Format_RGB32, pixels()); }

QImage Canvas::drawn(const QSize& size) {
  QImage picture;
  draw(picture, QImage::Format_RGB32, size);
  picture.setDevicePixelRatio(1.0);
  return picture;
}

QImage Canvas::image() const {
  if (backdrop_.isNull()) return image_.copy();
  QImage both = backdrop_.copy();
  QPainter(&both).drawImage(QPointF(), image_);
  return both;
}

void Canvas::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.setClipRegion(event->region());
  if (image_.isNull()) {
    painter.fillRect(event->rect(), palette().window());
    return;
  }
  painter.setCompositionMode(QPainter::CompositionMode_Source);
  painter.drawImage(QPointF(), backdrop_.isNull() ? image_ : backdrop_);
  if (backdrop_.isNull()) return;
  painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
  painter.drawImage(QPointF(), image_);
}

}  // namespace abstand::ui
