#include "ui/bookmark_commands.hpp"

#include <QInputDialog>
#include <algorithm>
#include <cmath>

#include "ui/document/document.hpp"
#include "ui/model/playback.hpp"
#include "ui/style/format.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

namespace {
constexpr int kMaxNote = 500;  // characters
}

BookmarkCommands::BookmarkCommands(Document& document, Playback& playback, Viewport& viewport,
                                   QWidget* window)
    : QObject(window), document_(document), playback_(playback), viewport_(viewport), window_(window) {}

bool BookmarkCommands::isHere(const Bookmark& mark) const {
  return std::abs(mark.t - playback_.time()) < 0.5 * playback_.framePeriod();
}

void BookmarkCommands::add() {
  const auto& marks = document_.work().bookmarks;
  const auto present = std::find_if(marks.begin(), marks.end(), [&](const Bookmark& m) { return isHere(m); });
  QInputDialog dialog(window_);
  dialog.setObjectName(QStringLiteral("bookmark_note"));
  dialog.setWindowTitle(tr("Bookmark"));
  dialog.setLabelText(tr("Note for the bookmark at %1:").arg(secondsWithUnit(playback_.time())));
  if (present != marks.end()) dialog.setTextValue(present->note);
  if (dialog.exec() != QDialog::Accepted) return;
  const Bookmark mark{playback_.time(), dialog.textValue().simplified().left(kMaxNote),
                      viewport_.cameraView()};
  document_.edit(tr("bookmark at %1").arg(secondsWithUnit(mark.t)), [&](Work& work) {
    auto& all = work.bookmarks;
    all.erase(std::remove_if(all.begin(), all.end(), [&](const Bookmark& m) { return isHere(m); }),
              all.end());
    const auto later = [](double t, const Bookmark& m) { return t < m.t; };
    all.insert(std::upper_bound(all.begin(), all.end(), mark.t, later), mark);
  });
}

void BookmarkCommands::removeHere() {
  const int before = document_.work().bookmarks.size();
  document_.edit(tr("remove bookmark"), [&](Work& work) {
    auto& all = work.bookmarks;
    all.erase(std::remove_if(all.begin(), all.end(), [&](const Bookmark& m) { return isHere(m); }),
              all.end());
  });
  if (document_.work().bookmarks.size() == before) Q_EMIT said(tr("No bookmark at this frame"));
}

void BookmarkCommands::goTo(int index) {
  const auto& marks = document_.work().bookmarks;
  if (index >= 0 && index < marks.size()) show(marks[index]);
}

void BookmarkCommands::remove(int index) {
  if (index < 0 || index >= document_.work().bookmarks.size()) return;
  document_.edit(tr("remove bookmark"), [index](Work& work) { work.bookmarks.removeAt(index); });
}

void BookmarkCommands::setNote(int index, const QString& note) {
  if (index < 0 || index >= document_.work().bookmarks.size()) return;
  document_.edit(tr("note of a bookmark"),
                 [&](Work& work) { work.bookmarks[index].note = note.simplified().left(kMaxNote); });
}

void BookmarkCommands::goToNext() {
  for (const Bookmark& mark : document_.work().bookmarks)
    if (mark.t > playback_.time() && !isHere(mark)) return show(mark);
  Q_EMIT said(tr("No later bookmark"));
}

void BookmarkCommands::goToPrevious() {
  const auto& marks = document_.work().bookmarks;
  for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark)
    if (mark->t < playback_.time() && !isHere(*mark)) return show(*mark);
  Q_EMIT said(tr("No earlier bookmark"));
}

void BookmarkCommands::show(const Bookmark& mark) {
  playback_.seek(mark.t);
  if (mark.camera) {
    viewport_.setCameraView(*mark.camera);
    document_.setViewpoint({mark.camera, mark.t});
  }
  Q_EMIT said(mark.note.isEmpty() ? tr("Bookmark at %1").arg(secondsWithUnit(mark.t))
                                  : tr("Bookmark at %1: %2").arg(secondsWithUnit(mark.t), mark.note));
}

}  // namespace abstand::ui
