// Bookmarks: moments with a camera and a note.
#pragma once

#include <QObject>
#include <optional>

class QWidget;

namespace abstand::ui {

class Document;
class Playback;
class Viewport;
struct Bookmark;

/// Adds, removes and visits the bookmarks of a document; each change is an undo step. GUI thread only.
class BookmarkCommands : public QObject {
  Q_OBJECT

 public:
  BookmarkCommands(Document& document, Playback& playback, Viewport& viewport, QWidget* window);

 public Q_SLOTS:
  /// Asks for a note. One that is there already gets the new note and camera.
  void add();
  /// The one at the present frame.
  void removeHere();
  /// By its index in the document.
  void goTo(int index);
  void remove(int index);
  void setNote(int index, const QString& note);
  void goToNext();
  void goToPrevious();

 Q_SIGNALS:
  /// For the status bar.
  void said(const QString& text);

 private:
  bool isHere(const Bookmark& mark) const;
  void show(const Bookmark& mark);

  Document& document_;
  Playback& playback_;
  Viewport& viewport_;
  QWidget* window_;
};

}  // namespace abstand::ui
