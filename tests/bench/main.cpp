// abstand_bench: Google Benchmark's command line, and --table=FILE for the tables of what ran side by side.
#include <benchmark/benchmark.h>

#include <fstream>
#include <iostream>
#include <string_view>

#include "tests/bench/side_by_side.hpp"

namespace {

constexpr std::string_view kTable = "--table=";

}  // namespace

int main(int argc, char** argv) {
  std::string table;
  int kept = 0;
  for (int i = 0; i < argc; ++i) {
    const std::string_view arg = argv[i];
    if (arg.starts_with(kTable))
      table = arg.substr(kTable.size());
    else
      argv[kept++] = argv[i];
  }
  abstand::bench::registerSideBySide();
  benchmark::Initialize(&kept, argv);
  if (benchmark::ReportUnrecognizedArguments(kept, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  const auto& ledger = abstand::bench::ledger();
  if (ledger.empty()) return 0;
  std::cout << "\nMicroseconds a frame, median / p99, one thread\n\n";
  ledger.print(std::cout);
  if (table.empty()) return 0;
  std::ofstream out(table);
  ledger.print(out);
  if (out.flush()) return 0;
  std::cerr << table << ": error: cannot be written\n";
  return 2;
}
