// What the user has chosen; tree, viewport and tables share it.
#pragma once

#include <QObject>
#include <algorithm>
#include <vector>

namespace abstand::ui {

/// Objects by their index in the outline, and the pair when it was chosen as a pair. GUI thread only.
class Selection : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  const std::vector<int>& objects() const { return objects_; }
  /// Index of the outline's pairs; -1 when objects were chosen rather than a pair.
  int pair() const { return pair_; }
  bool contains(int object) const { return std::binary_search(objects_.begin(), objects_.end(), object); }

  void setObjects(std::vector<int> objects) { set(std::move(objects), -1); }
  void setPair(int pair, int a, int b) { set({a, b}, pair); }
  void clear() { set({}, -1); }

 Q_SIGNALS:
  void changed();

 private:
  void set(std::vector<int> objects, int pair) {
    std::sort(objects.begin(), objects.end());
    if (objects == objects_ && pair == pair_) return;
    objects_ = std::move(objects);
    pair_ = pair;
    Q_EMIT changed();
  }

  std::vector<int> objects_;
  int pair_{-1};
};

}  // namespace abstand::ui
