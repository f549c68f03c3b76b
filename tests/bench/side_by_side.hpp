// The same scenes with every engine that is there, as benchmarks.
#pragma once

#include "tests/bench/ledger.hpp"

namespace abstand::bench {

/// Where the benchmarks below write down what they measure.
Ledger& ledger();

/// Registers sideBySide/SCENE/WORK/ENGINE for all. Before benchmark::Initialize.
void registerSideBySide();

}  // namespace abstand::bench
