// The depth image of the moment with the fitted body.
#pragma once

#include <QWidget>

#include "core/view/snapshot.hpp"
#include "ui/model/depth_port.hpp"

class QAction;
class QComboBox;
class QLabel;
class QTimer;

namespace abstand::ui {

class DepthView;

/// Asks for an image only while it is in front, and shows it when it has been read; while the clock runs it
/// may be that of a moment before, and then says so. GUI thread only.
class DepthPanel : public QWidget {
  Q_OBJECT

 public:
  /// `body`: whether the fitted body is drawn; its button stands below.
  explicit DepthPanel(QAction* body, QWidget* parent = nullptr);

  /// Null: no recording has depth images.
  void open(DepthPort* port);
  void setInFront(bool in_front) { in_front_ = in_front; }
  void refresh(const view::SceneSnapshot& snapshot);
  const DepthView& view() const { return *view_; }
  QComboBox* personBox() const { return person_; }
  QLabel* caption() const { return caption_; }
  QLabel* legend() const { return legend_; }
  /// The image shown is that of the moment.
  bool isOfMoment() const;

 private:
  void choose(int person);
  void poll();
  void showState();
  void showCaption();
  void showLegend();

  DepthPort* port_{nullptr};
  bool in_front_{false};
  DepthView* view_;
  QComboBox* person_;
  QLabel *caption_, *legend_;
  QTimer* timer_;  ///< runs while an image is awaited
  double t_{0.0};  ///< s, of the moment
  struct {
    int person{-1};
    std::size_t image{0};
  } wanted_;
};

}  // namespace abstand::ui
