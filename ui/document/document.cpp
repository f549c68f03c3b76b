#include "ui/document/document.hpp"

#include <QUndoCommand>

namespace abstand::ui {

namespace {
// A step costs some kilobytes.
constexpr int kMaxSteps = 2000;
constexpr int kStepId = 1;
}  // namespace

/// Both states as a whole: to undo gives exactly what was there before.
class Document::Step : public QUndoCommand {
 public:
  Step(Document& document, const Work& before, const Work& after, const QString& text, const QString& key)
      : document_(document), before_(before), after_(after), key_(key), gesture_(document.gesture_) {
    setText(text);
  }
  void undo() override { document_.take(before_); }
  void redo() override { document_.take(after_); }
  int id() const override { return key_.isEmpty() ? -1 : kStepId; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const Step*>(other);
    if (next->key_ != key_ || next->gesture_ != gesture_) return false;
    after_ = next->after_;
    setText(next->text());
    setObsolete(after_ == before_);
    return true;
  }

 private:
  Document& document_;
  Work before_, after_;
  QString key_;
  long gesture_;
};

Document::Document(QObject* parent) : QObject(parent) {
  steps_.setUndoLimit(kMaxSteps);
  connect(&steps_, &QUndoStack::cleanChanged, this, &Document::titleChanged);
}

void Document::edit(const QString& text, const std::function<void(Work&)>& change, const QString& merge_key) {
  Work after = work_;
  change(after);
  if (after == work_) return;
  steps_.push(new Step(*this, work_, after, text, merge_key));
}

void Document::take(const Work& work) {
  const Work before = work_;
  work_ = work;
  Q_EMIT workChanged(before, work_);
}

void Document::open(const Project& project, const QString& file, bool modified) {
  work_ = project.work;
  viewpoint_ = project.viewpoint;
  file_ = file;
  steps_.clear();
  if (modified) steps_.resetClean();
  endStep();
  Q_EMIT opened();
  Q_EMIT titleChanged();
}

void Document::setSaved(const QString& file) {
  file_ = file;
  steps_.setClean();
  Q_EMIT titleChanged();
}

}  // namespace abstand::ui
