// What the public types of the engine hold.
#pragma once

#include "abstand/query.hpp"
#include "abstand/structure.hpp"
#include "core/query/pair_query.hpp"

namespace abstand {

struct Structure::Impl {
  std::shared_ptr<const structure::HapticStructure> made;
};

struct PairState::Impl {
  query::PairMemory memory;
};

}  // namespace abstand

namespace abstand::facade {

/// Of the five; valid.
geometry::Shape shapeOf(const Shape& shape);
/// The other way round.
Shape shapeOf(const geometry::Shape& shape);
/// As it stands in the library.
Mesh meshOf(geometry::TriangleMesh mesh);
/// Takes results as the engine gives them.
PairResult resultOf(const query::PairResult& result);
/// Throws UsageError for a margin or stiffness that is negative or not finite.
query::PairOptions pairOptions(const QueryOptions& options);
/// Throws UsageError for what is no pose.
Transform checkedPose(const Pose& pose);

}  // namespace abstand::facade
