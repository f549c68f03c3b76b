// What the commands of the margin workbench do to the document.
#include "ui/margin_commands.hpp"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"
#include "ui/document/document.hpp"
#include "ui/document/session_follower.hpp"
#include "ui/model/margin_set.hpp"
#include "ui/model/pair_class.hpp"
#include "ui/model/proposed_rows.hpp"
#include "ui/model/recent_folder.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/proposal_dialog.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {

namespace {

constexpr std::uintmax_t kMaxSetBytes = 1 << 20;
constexpr ActionId kMarginActions[] = {
    ActionId::kResetMargins, ActionId::kNoMargins,      ActionId::kMargins50,      ActionId::kMargins100,
    ActionId::kMargins200,   ActionId::kCopyMargins,    ActionId::kPasteMargins,   ActionId::kOpenMargins,
    ActionId::kSaveMargins,  ActionId::kProposeMargins, ActionId::kCompareMargins, ActionId::kProposeSpeeds,
    ActionId::kWhatIf};

/// Those that are not locked: what is set for all bodies is to have an effect.
void dropClasses(Work& work) {
  for (const QString& key : work.classes.keys())
    if (!work.classes[key].locked) work.classes.remove(key);
}

}  // namespace

MarginCommands::MarginCommands(Document& document, const SessionFollower& follower, RecordingReview& review,
                               MarginPanel& panel, const Actions& actions, QWidget* window)
    : QObject(window),
      document_(document),
      follower_(follower),
      review_(review),
      panel_(panel),
      actions_(actions),
      window_(window) {
  connectPanel();
  connectClasses();
  connectActions();
  connect(&document_, &Document::workChanged, this, [this](const Work& before, const Work& after) {
    if (before.locked != after.locked) showLocks();
    if (before.classes != after.classes) showClasses();
    if (before.compared != after.compared) showCompared();
  });
}

void MarginCommands::connectPanel() {
  connect(&panel_, &MarginPanel::marginsChanged, this, [this](const QMap<int, double>& margins) {
    if (!outline_) return;
    set(margins.size() == 1 ? tr("margin of %1").arg(name(margins.firstKey()))
                            : tr("margins of %n objects", nullptr, margins.size()),
        margins, QStringLiteral("margins"));
  });
  connect(&panel_, &MarginPanel::editFinished, &document_, &Document::endStep);
  connect(&panel_, &MarginPanel::lockWanted, this, &MarginCommands::lock);
}

void MarginCommands::connectActions() {
  const auto on = [&](ActionId id, auto&& command) {
    connect(actions_[id], &QAction::triggered, this, command);
  };
  on(ActionId::kResetMargins, [this] { reset(); });
  on(ActionId::kNoMargins, [this] { setAll(0.0); });
  on(ActionId::kMargins50, [this] { setAll(0.05); });
  on(ActionId::kMargins100, [this] { setAll(0.1); });
  on(ActionId::kMargins200, [this] { setAll(0.2); });
  on(ActionId::kCopyMargins, [this] { copy(); });
  on(ActionId::kPasteMargins, [this] { paste(); });
  on(ActionId::kOpenMargins, [this] { openSet(); });
  on(ActionId::kSaveMargins, [this] { saveSet(); });
  on(ActionId::kProposeMargins, [this] { propose(); });
  connect(actions_[ActionId::kCompareMargins], &QAction::triggered, this, &MarginCommands::compare);
}

void MarginCommands::open(const view::SceneOutline* outline) {
  outline_ = outline;
  for (const ActionId id : kMarginActions) actions_[id]->setEnabled(outline != nullptr);
  showLocks();
  showClasses();
  showCompared();
}

QString MarginCommands::name(int object) const {
  return QString::fromStdString(outline_->objects[static_cast<std::size_t>(object)].name);
}

bool MarginCommands::locked(int object) const { return document_.work().locked.contains(name(object)); }

std::vector<double> MarginCommands::margins() const { return follower_.margins(document_.work()); }

void MarginCommands::set(const QString& text, const QMap<int, double>& margins, const QString& merge_key,
                         const std::function<void(Work&)>& also) {
  int stayed = 0;
  document_.edit(
      text,
      [&](Work& work) {
        if (also) also(work);
        for (auto it = margins.begin(); it != margins.end(); ++it)
          if (locked(it.key()))
            stayed += follower_.margin(work, it.key()) != it.value();
          else if (follower_.margin(work, it.key()) != it.value())
            work.margins[name(it.key())] = it.value();
      },
      merge_key);
  if (stayed > 0) Q_EMIT said(tr("%n locked margins stay as they are", nullptr, stayed));
}

void MarginCommands::connectClasses() {
  connect(&panel_, &MarginPanel::classTicked, this, &MarginCommands::tickClass);
  connect(&panel_, &MarginPanel::classLockWanted, this, &MarginCommands::lockClass);
  connect(&panel_, &MarginPanel::classMarginChanged, this,
          [this](PairClass pair_class, double metres) { setClass(pair_class, metres); });
}

void MarginCommands::setClass(PairClass pair_class, std::optional<double> metres) {
  const QString key = pairClassKey(pair_class);
  if (!outline_ || document_.work().classes.value(key).locked) return;
  document_.edit(
      tr("margin of the pairs %1").arg(pairClassInSentence(pair_class)),
      [&](Work& work) {
        if (metres)
          work.classes[key].metres = *metres;
        else
          work.classes.remove(key);
      },
      QStringLiteral("class margin/") + key);
}

/// A class begins with the largest margin that one of its pairs has, so that no margin becomes smaller.
void MarginCommands::tickClass(PairClass pair_class, bool on) {
  document_.endStep();
  const double largest = std::min(panel_.largestSum(pair_class), MarginRow::kLimit);
  setClass(pair_class, on ? std::optional(largest) : std::nullopt);
  document_.endStep();
}

void MarginCommands::lockClass(PairClass pair_class, bool locked) {
  const QString key = pairClassKey(pair_class);
  if (!document_.work().classes.contains(key)) return;
  const QString what = tr("margin of the pairs %1").arg(pairClassInSentence(pair_class));
  document_.edit(locked ? tr("lock %1").arg(what) : tr("unlock %1").arg(what),
                 [&](Work& work) { work.classes[key].locked = locked; });
}

void MarginCommands::showClasses() {
  if (!outline_) return;
  const auto& classes = document_.work().classes;
  for (std::size_t c = 0; c < view::kPairClassNames.size(); ++c) {
    const auto pair_class = static_cast<PairClass>(c);
    panel_.showClass(pair_class, SessionFollower::classMargin(document_.work(), pair_class),
                     classes.value(pairClassKey(pair_class)).locked);
  }
}

/// Those of a set. One without a margin for all pairs of people and robots says the margins of each of them;
/// of other pairs it need not say anything.
void MarginCommands::takeClasses(const std::map<std::string, double>& classes, Work& work) const {
  const QString people = pairClassKey(PairClass::kPersonRobot);
  if (!work.classes.value(people).locked && classes.count(people.toStdString()) == 0)
    work.classes.remove(people);
  for (const auto& [name, metres] : classes) {
    const QString key = QString::fromStdString(name);
    if (!work.classes.value(key).locked) work.classes[key].metres = metres;
  }
}

void MarginCommands::setAll(double metres) {
  if (!outline_) return;
  QMap<int, double> all;
  for (int i = 0; i < static_cast<int>(outline_->objects.size()); ++i) all[i] = metres;
  set(metres > 0.0 ? tr("all margins %1 mm").arg(1e3 * metres) : tr("no margins"), all, {}, dropClasses);
}

void MarginCommands::reset() {
  if (!outline_) return;
  document_.edit(tr("reset margins"), [](Work& work) {
    QMap<QString, double> kept;
    for (auto it = work.margins.begin(); it != work.margins.end(); ++it)
      if (work.locked.contains(it.key())) kept[it.key()] = it.value();
    work.margins = kept;
    dropClasses(work);
  });
}

void MarginCommands::lock(const std::vector<int>& objects, bool locked) {
  if (!outline_ || objects.empty()) return;
  const QString what = objects.size() == 1 ? tr("margin of %1").arg(name(objects.front()))
                                           : tr("%n margins", nullptr, static_cast<int>(objects.size()));
  document_.edit(locked ? tr("lock %1").arg(what) : tr("unlock %1").arg(what), [&](Work& work) {
    for (const int object : objects)
      if (locked)
        work.locked.insert(name(object));
      else
        work.locked.remove(name(object));
  });
}

void MarginCommands::showLocks() {
  if (!outline_) return;
  std::vector<bool> all;
  for (int i = 0; i < static_cast<int>(outline_->objects.size()); ++i) all.push_back(locked(i));
  panel_.showLocked(all);
}

std::string MarginCommands::presentSet() {
  const MarginSet set(*outline_);
  if (set.empty()) {
    Q_EMIT failed(tr("Margins"),
                  tr("A set of margins is for pairs of a person and a robot, and the scene has none."));
    return {};
  }
  const std::vector<double> all = margins();
  if (set.differs(all)) Q_EMIT said(tr("Of several people the set has the largest margin of each part"));
  margin::MarginRules rules = set.rules(all);
  const auto& classes = document_.work().classes;
  for (auto it = classes.begin(); it != classes.end(); ++it)
    rules.classes[it.key().toStdString()] = it->metres;
  return margin::marginRulesText(rules);
}

void MarginCommands::takeSet(const std::string& text, const QString& from, const QString& step) {
  const MarginSet names(*outline_);
  try {
    const margin::MarginRules rules = margin::parseMarginRules(text, from.toStdString(), names.partNames());
    set(step, names.margins(rules), {}, [&](Work& work) { takeClasses(rules.classes, work); });
  } catch (const std::exception& e) {
    Q_EMIT failed(tr("No set of margins for this scene"), QString::fromUtf8(e.what()));
  }
}

void MarginCommands::copy() {
  const std::string text = presentSet();
  if (text.empty()) return;
  QApplication::clipboard()->setText(QString::fromStdString(text));
  Q_EMIT said(tr("The margins of people and robots are on the clipboard"));
}

void MarginCommands::paste() {
  takeSet(QApplication::clipboard()->text().toStdString(), tr("clipboard"), tr("paste margins"));
}

void MarginCommands::openSet() {
  QFileDialog dialog(window_, tr("Open margins"), recentFolder(), tr("Sets of margins (*.yaml *.yml)"));
  dialog.setObjectName(QStringLiteral("open_margins"));
  dialog.setFileMode(QFileDialog::ExistingFile);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  rememberFolder(dialog.selectedFiles().constFirst());
  openFile(dialog.selectedFiles().constFirst());
}

void MarginCommands::openFile(const QString& file) {
  try {
    if (!outline_) throw UsageError("found no scene, expected one that the margins are for");
    takeSet(readFile(QFile::encodeName(file).toStdString(), kMaxSetBytes), file,
            tr("margins of %1").arg(QFileInfo(file).fileName()));
  } catch (const std::exception& e) {
    Q_EMIT failed(tr("Cannot open the margins"), QString::fromUtf8(e.what()));
  }
}

void MarginCommands::saveSet() {
  const std::string text = presentSet();
  if (text.empty()) return;
  QFileDialog dialog(window_, tr("Save margins"), recentFolder(), tr("Sets of margins (*.yaml)"));
  dialog.setObjectName(QStringLiteral("save_margins"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("yaml"));
  dialog.selectFile(QStringLiteral("margins.yaml"));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  const QString file = dialog.selectedFiles().constFirst();
  rememberFolder(file);
  try {
    writeFile(QFile::encodeName(file).toStdString(), text);
    Q_EMIT said(tr("Saved %1").arg(file));
  } catch (const std::exception& e) {
    Q_EMIT failed(tr("Cannot save the margins"), QString::fromUtf8(e.what()));
  }
}

void MarginCommands::compare(bool on) {
  if (!outline_) return;
  document_.edit(on ? tr("compare margins") : tr("compare margins no longer"), [&](Work& work) {
    work.compared.reset();
    if (!on) return;
    const std::vector<double> present = follower_.reviewMargins(work);
    work.compared.emplace();
    for (int i = 0; i < static_cast<int>(present.size()); ++i)
      (*work.compared)[name(i)] = present[static_cast<std::size_t>(i)];
  });
}

void MarginCommands::showCompared() {
  const auto& kept = document_.work().compared;
  actions_[ActionId::kCompareMargins]->setChecked(kept.has_value());
  Work work;
  if (kept) work.margins = *kept;
  Q_EMIT compared(outline_ && kept ? follower_.margins(work) : std::vector<double>());
}

void MarginCommands::propose() {
  if (!outline_) return;
  const QString problem = proposalProblem(review_);
  if (!problem.isEmpty()) {
    Q_EMIT failed(tr("Propose margins"), problem);
    return;
  }
  const QString key = pairClassKey(PairClass::kPersonRobot);
  if (document_.work().classes.value(key).locked) {
    Q_EMIT failed(
        tr("Propose margins"),
        tr("The margin of all pairs of people and robots is locked. Proposed margins are for single "
           "parts and would have no effect."));
    return;
  }
  std::vector<bool> all_locked;
  for (int i = 0; i < static_cast<int>(outline_->objects.size()); ++i) all_locked.push_back(locked(i));
  const std::vector<ProposedRow> rows =
      proposedRows(*review_.store(), margins(), all_locked, review_.options());
  auto* dialog = new ProposalDialog(rows, window_);
  connect(dialog, &ProposalDialog::picked, this, &MarginCommands::picked);
  connect(dialog, &QDialog::accepted, this, [this, rows, key, outline = outline_] {
    if (outline_ != outline) return;
    QMap<int, double> margins;
    for (const ProposedRow& row : rows)
      if (row.metres) margins[row.object] = *row.metres;
    set(tr("proposed margins"), margins, {}, [key](Work& work) { work.classes.remove(key); });
  });
  dialog->open();
}

}  // namespace abstand::ui
