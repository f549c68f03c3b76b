#include "app/studio/live_opening.hpp"

#include <QFile>
#include <QFileInfo>
#include <QMetaObject>

#include "app/moment/moment_file.hpp"

namespace abstand::studio {
namespace {

constexpr int kLookEveryMs = 30;
constexpr double kAnswerWithin = 5.0;  // s

}  // namespace

LiveOpening::~LiveOpening() { abandon(); }

void LiveOpening::abandon() {
  timer_.stop();
  source_.reset();
  if (current_) *current_ = false;
  current_.reset();
}

void LiveOpening::connectTo(const QString& address, const QString& scene) {
  abandon();
  try {
    QString numeric = address;
    numeric.replace(QStringLiteral("localhost"), QStringLiteral("127.0.0.1"));
    source_ = std::make_shared<LiveSource>();
    source_->name = address;
    source_->record = std::make_shared<viewer::LiveRecord>();
    source_->link = std::make_unique<viewer::ViewerLink>(
        serve::parseAddress(numeric.toStdString(), tr("Address").toStdString()), source_->record);
  } catch (const std::exception& e) {
    source_.reset();
    Q_EMIT failed(QString::fromUtf8(e.what()));
    return;
  }
  scene_ = scene;
  until_ = viewer::steadySeconds() + kAnswerWithin;
  timer_.disconnect();
  connect(&timer_, &QTimer::timeout, this, &LiveOpening::look);
  timer_.start(kLookEveryMs);
}

void LiveOpening::look() {
  if (source_->record->span().kept > 0) return finish();
  if (viewer::steadySeconds() < until_) return;
  const QString name = source_->name;
  const bool damaged = source_->record->status(viewer::steadySeconds()).damaged > 0;
  abandon();
  Q_EMIT failed(damaged
                    ? tr("What answers at %1 is no abstand serve of this version.").arg(name)
                    : tr("No answer from %1.\n\nIs abstand serve running there, and does it have a viewer "
                         "to spare (--viewers)?")
                          .arg(name));
}

/// The scene of the source where the user has given none.
void LiveOpening::finish() {
  timer_.stop();
  const auto source = std::exchange(source_, nullptr);
  QString scene = scene_;
  if (scene.isEmpty()) scene = QString::fromStdString(source->record->card()->file);
  if (!QFileInfo::exists(scene)) {
    Q_EMIT failed(tr("%1 is of the scene %2, which is not here. Give the file of the scene, too.")
                      .arg(source->name, scene));
    return;
  }
  Q_EMIT found(source, scene);
}

void LiveOpening::readFile(const QString& file, const QString& scene) {
  abandon();
  scene_ = scene;
  current_ = std::make_shared<std::atomic<bool>>(true);
  auto source = std::make_shared<LiveSource>();
  source->name = file;
  // Whatever is in the file is shown.
  source->record = std::make_shared<viewer::LiveRecord>(viewer::RingLimits{kInfinity, std::size_t{2} << 30});
  // Waits for an older one, which ends soon.
  reading_ = std::jthread([this, source, counts = current_] {
    QString problem;
    try {
      moment::readMomentFile(
          QFile::encodeName(source->name).toStdString(),
          [&](const moment::SceneCard& card) { source->record->begin(card, viewer::LinkState::kFile, 0.0); },
          [&](std::span<const std::byte> frame, const moment::Moment& m) {
            source->record->add(frame, m, 0.0);
          });
    } catch (const std::exception& e) {
      problem = QString::fromUtf8(e.what());
    }
    const auto tell = [this, source, counts, problem] {
      if (!*counts) return;
      source_ = source;
      if (problem.isEmpty()) return finish();
      abandon();
      Q_EMIT failed(problem);
    };
    QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
  });
}

void MomentSaving::start(std::shared_ptr<viewer::LiveRecord> record, const QString& file) {
  if (std::exchange(busy_, true)) return;
  thread_ = std::jthread([this, record = std::move(record), file] {
    QString problem;
    try {
      std::vector<std::byte> bytes;
      std::size_t number = 0;
      moment::writeMomentFile(QFile::encodeName(file).toStdString(), *record->card(), [&] {
        bytes.clear();
        number = record->copyFrames(number, bytes);
        return std::span<const std::byte>(bytes);
      });
    } catch (const std::exception& e) {
      problem = QString::fromUtf8(e.what());
    }
    const auto tell = [this, file, problem] {
      busy_ = false;
      if (problem.isEmpty())
        Q_EMIT done(file);
      else
        Q_EMIT failed(problem);
    };
    QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
  });
}

}  // namespace abstand::studio
