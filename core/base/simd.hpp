// Choice between code for AVX2 and code for any machine.
#pragma once

namespace abstand {

/// Whether loops that exist for AVX2, too, run it: if this CPU has it and the environment does not contain
/// ABSTAND_SIMD=off. The same during the whole run. Both kinds of loops give the same bits. Thread-safe; no
/// throw.
bool usesAvx2();

}  // namespace abstand
