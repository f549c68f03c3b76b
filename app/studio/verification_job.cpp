#include "app/studio/verification_job.hpp"

#include <QCoreApplication>
#include <QFile>
#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

#include "app/report/report.hpp"
#include "core/base/background_thread.hpp"
#include "core/base/error.hpp"
#include "core/verify/suite.hpp"

namespace abstand::studio {

/// What the two threads share.
struct VerificationJob::Run {
  void work();

  std::string family;  // empty: all
  verify::VerifyOptions options;
  std::atomic<bool> cancelled{false}, ended{false};

  std::mutex mutex;           // of the rest
  ui::VerificationNews news;  // since the last poll
  bool is_new{false};
  std::vector<verify::CheckResult> results;  // all
  QString problem;

 private:
  template <class Change>
  void tell(Change change) {
    const std::lock_guard lock(mutex);
    change();
    is_new = true;
  }
  void check(const verify::CheckFamily& of, double begin, double share);
};

namespace {

constexpr int kVerificationPollMs = 100;

QString familyName(const verify::CheckFamily& family) {
  return QString::fromUtf8(family.name.data(), static_cast<int>(family.name.size()));
}

ui::VerificationRow checkRow(const verify::CheckResult& result) {
  return {QString::fromStdString(result.name),
          QString::fromStdString(result.what),
          QString::fromStdString(result.quantity),
          QString::fromStdString(result.reason),
          result.poses,
          result.breaches,
          result.p50,
          result.p99,
          result.worst,
          result.limit,
          result.passed};
}

}  // namespace

/// A family of checks, which takes this share of the whole.
void VerificationJob::Run::check(const verify::CheckFamily& of, double begin, double share) {
  verify::VerifyOptions watched = options;
  watched.interrupted = [this] { return cancelled.load(std::memory_order_relaxed); };
  watched.progress = [&](std::size_t done, std::size_t all) {
    const double part = all > 0 ? static_cast<double>(done) / static_cast<double>(all) : 0.0;
    tell([&] {
      news.family = familyName(of);
      news.share = begin + part * share;
    });
  };
  watched.progress(0, 1);
  std::vector<verify::CheckResult> found = of.run(watched);
  tell([&] {
    for (verify::CheckResult& result : found) {
      news.rows.push_back(checkRow(result));
      results.push_back(std::move(result));
    }
    news.share = begin + share;
  });
}

void VerificationJob::Run::work() {
  beBackgroundThread("verification");
  std::vector<verify::CheckFamily> all = verify::checkFamilies();
  std::erase_if(all, [this](const auto& each) { return !family.empty() && each.name != family; });
  const double share = 1.0 / static_cast<double>(std::max<std::size_t>(1, all.size()));
  try {
    for (std::size_t i = 0; i < all.size() && !cancelled; ++i)
      check(all[i], static_cast<double>(i) * share, share);
    tell([&] {
      news.ended = !cancelled;
      news.passed = !cancelled && std::ranges::all_of(results, &verify::CheckResult::passed);
    });
  } catch (const std::exception& e) {
    tell([&] { problem = QString::fromUtf8(e.what()); });
  }
  ended = true;
}

QStringList VerificationJob::families() {
  QStringList names;
  for (const verify::CheckFamily& family : verify::checkFamilies()) names << familyName(family);
  return names;
}

VerificationJob::VerificationJob() {
  poll_.setInterval(kVerificationPollMs);
  connect(&poll_, &QTimer::timeout, this, &VerificationJob::poll);
}

VerificationJob::~VerificationJob() { cancel(); }

void VerificationJob::start(const ui::VerificationRequest& request) {
  cancel();
  run_ = std::make_shared<Run>();
  run_->family = request.family.toStdString();
  run_->options.quick = request.quick;
  if (request.quick) run_->options.poses = verify::kQuickPoses;
  run_->options.threads = 1;
  threads_.start([run = run_] { run->work(); });
  poll_.start();
}

void VerificationJob::cancel() {
  poll_.stop();
  if (run_) run_->cancelled = true;
  run_.reset();
}

void VerificationJob::poll() {
  ui::VerificationNews found;
  QString problem;
  {
    const std::lock_guard lock(run_->mutex);
    if (!std::exchange(run_->is_new, false)) return;
    found = run_->news;
    run_->news.rows.clear();
    problem = run_->problem;
  }
  if (found.ended || !problem.isEmpty()) poll_.stop();
  if (problem.isEmpty())
    Q_EMIT news(found);
  else
    Q_EMIT failed(problem);
}

void VerificationJob::savePage(const QString& file) const {
  if (!run_ || !run_->ended) throw UsageError("found no complete checks of the engine, expected some");
  report::writeReport(run_->results, run_->options, QCoreApplication::applicationVersion().toStdString(),
                      QFile::encodeName(file).toStdString());
}

}  // namespace abstand::studio
