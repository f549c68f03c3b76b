// The distance pass of `abstand tune` over the boxer beside HUG: processor time of one core.
#include <benchmark/benchmark.h>

#include <ctime>

#include "app/scene_file/scene_description.hpp"
#include "app/session/session.hpp"
#include "app/tune/result_file.hpp"
#include "core/base/data_folder.hpp"
#include "core/base/temporary_folder.hpp"
#include "core/contact/contact_limits_reader.hpp"
#include "humanmodel/body_part.hpp"

namespace abstand::bench {
namespace {

/// s, of all threads of the process.
double processorTime() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// What a pass makes besides distances, closest points, speeds, uncertainties and braking.
enum class Output { kNone, kContacts, kResultFile };

session::Session openScene() {
  session::SessionOptions options;
  options.threads = 1;
  options.remember = true;
  return session::Session(scene_file::loadScene(dataFolder() / "scenes" / "hug_boxing.yaml"), options);
}

/// From the open session to the complete result; structures and recording are loaded before.
void distancePass(benchmark::State& state, Output output) {
  const TemporaryFolder folder;
  tune::TuneOptions options;
  if (output != Output::kNone)
    options.pass.contact = std::make_shared<const contact::ContactLimits>(
        contact::loadContactLimits(contact::defaultContactLimits(), humanmodel::partNames()));
  options.pass.keep_frames = output != Output::kResultFile;
  double recorded = 0.0, worked = 0.0;
  try {
    for (auto _ : state) {
      session::Session session = openScene();
      const double begin = processorTime();
      std::optional<tune::ResultWriter> writer;
      tune::TuneOptions pass = options;
      if (output == Output::kResultFile) {
        writer.emplace(folder.path() / "result.h5", ContentKey{});
        pass.pass.on_frame = [&](const tune::SettledFrame& frame, const tune::PassResult& result) {
          writer->frame(frame, result);
        };
      }
      const tune::TunedRecording tuned = tune::tuneRecording(session, pass, {}, "boxer");
      if (writer) writer->commit(tuned, pass);
      const double spent = processorTime() - begin;
      state.SetIterationTime(spent);
      worked += spent;
      recorded += tuned.seconds();
    }
  } catch (const std::exception& e) {
    state.SkipWithError(e.what());
  }
  state.counters["times_real_time"] = recorded / worked;
}
BENCHMARK_CAPTURE(distancePass, distances, Output::kNone)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(distancePass, with_contacts, Output::kContacts)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(distancePass, with_result_file, Output::kResultFile)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace abstand::bench
