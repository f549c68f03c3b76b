// Classes of pairs: whom a distance is about.
#pragma once

#include <QString>

#include "core/view/snapshot.hpp"

namespace abstand::ui {

using view::PairClass;
using view::pairClassOf;
inline constexpr int kPairClasses = static_cast<int>(view::kPairClasses);

/// "person_robot": in files; empty for kOther.
QString pairClassKey(PairClass pair_class);
/// "Person – robot".
QString pairClassName(PairClass pair_class);
/// "person – robot", within a sentence.
QString pairClassInSentence(PairClass pair_class);

}  // namespace abstand::ui
