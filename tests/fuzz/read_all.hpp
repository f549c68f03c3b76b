// What every reader of recordings must keep to, whatever it is given.
#pragma once

#include <memory>

#include "core/base/error.hpp"
#include "tracking/recording/point_reader.hpp"

namespace abstand::testing {

/// Makes a reader and reads to the end: only ParseError may come out, and only places that are finite.
template <typename Make>
void readAll(Make make) {
  try {
    auto reader = make();
    const std::size_t points = reader.names().size();
    for (const auto& p : reader.rest()) ABSTAND_CHECK(p.allFinite());
    double last = -kInfinity;
    for (tracking::PointFrame f; reader.next(f);) {
      ABSTAND_CHECK(f.p.size() == points && f.state.size() == points && f.t > last);
      last = f.t;
      for (std::size_t i = 0; i < points; ++i)
        ABSTAND_CHECK(f.state[i] == humanmodel::JointState::kMissing || f.p[i].allFinite());
    }
    ABSTAND_CHECK(!reader.next(*std::make_unique<tracking::PointFrame>()));
    reader.warnings();
  } catch (const ParseError&) {
  }
}

}  // namespace abstand::testing
