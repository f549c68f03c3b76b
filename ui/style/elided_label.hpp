// A line of text that gives way.
#pragma once

#include <QLabel>

namespace abstand::ui {

/// Asks for the widest of its texts so far, so that what stands beside it keeps its place, but may be made
/// narrower, unless it keeps its texts whole: then the end of the text is left out. GUI thread only.
class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  using QLabel::QLabel;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  /// Its neighbours give way instead.
  void keepWhole() { whole_ = true; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  mutable int widest_{0};  // px
  bool whole_{false};
};

}  // namespace abstand::ui
