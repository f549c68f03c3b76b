#include "app/studio/report_job.hpp"

namespace abstand::studio {

namespace {

constexpr int kDone = 0, kPartlyDone = 5;

/// The report's assumptions are those of its dialog.
ui::Work withAssumptions(ui::Work work, const ui::ReportRequest& request) {
  work.what_if = request.what_if;
  return work;
}

}  // namespace

ReportJob::ReportJob(QString program, ui::Work work, ui::ReportRequest request,
                     robot_file::PackagePaths packages, QObject* parent)
    : QObject(parent),
      call_(withAssumptions(std::move(work), request), std::move(packages)),
      request_(std::move(request)),
      process_(std::move(program), {kDone, kPartlyDone}) {
  connect(&process_, &TuneProcess::answered, this, [this] { Q_EMIT done(request_.file); });
  connect(&process_, &TuneProcess::failed, this, &ReportJob::failed);
}

void ReportJob::start() {
  process_.start([this] {
    return call_.words() << QStringLiteral("--margin-set")
                         << call_.keep(QStringLiteral("present_margins.yaml"), request_.margin_set)
                         << QStringLiteral("--report") << request_.file;
  });
}

}  // namespace abstand::studio
