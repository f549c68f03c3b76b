#include "abstand/pair_set.hpp"

#include "core/base/error.hpp"
#include "core/facade/structure_impl.hpp"
#include "core/query/pair_set.hpp"

namespace abstand {
namespace {

std::vector<const structure::HapticStructure*> madeOf(const std::vector<Structure>& bodies) {
  std::vector<const structure::HapticStructure*> made;
  for (const Structure& body : bodies) made.push_back(body.impl().made.get());
  return made;
}

std::vector<query::PairSet::Bodies> checkedPairs(const std::vector<PairSet::Bodies>& pairs,
                                                 std::size_t bodies) {
  if (pairs.empty()) throw UsageError("found no pair, expected at least one");
  std::vector<query::PairSet::Bodies> checked;
  for (const PairSet::Bodies& pair : pairs) {
    if (std::max(pair.a, pair.b) >= bodies)
      throw UsageError("found a pair of the bodies " + std::to_string(pair.a) + " and " +
                       std::to_string(pair.b) + ", expected numbers below " + std::to_string(bodies));
    checked.push_back({static_cast<std::uint32_t>(pair.a), static_cast<std::uint32_t>(pair.b)});
  }
  return checked;
}

}  // namespace

struct PairSet::Impl {
  Impl(std::vector<Structure> all, const std::vector<Bodies>& pairs)
      : bodies(std::move(all)),
        poses(bodies.size()),
        set(madeOf(bodies), checkedPairs(pairs, bodies.size())) {}

  std::span<const Transform> place(std::span<const Pose> X_WB) {
    if (X_WB.size() != poses.size())
      throw UsageError("found " + std::to_string(X_WB.size()) + " poses, expected " +
                       std::to_string(poses.size()) + ", one for each body");
    for (std::size_t i = 0; i < poses.size(); ++i) poses[i] = facade::checkedPose(X_WB[i]);
    return poses;
  }

  std::vector<Structure> bodies;  ///< keeps the structures of the set alive
  std::vector<Transform> poses;
  query::PairSet set;
  std::vector<query::PairResult> results;
  std::vector<Contact> contacts;
};

PairSet::PairSet(std::vector<Structure> bodies, const std::vector<Bodies>& pairs)
    : impl_(std::make_unique<Impl>(std::move(bodies), pairs)) {}
PairSet::~PairSet() = default;
PairSet::PairSet(PairSet&&) noexcept = default;
PairSet& PairSet::operator=(PairSet&&) noexcept = default;

std::size_t PairSet::size() const { return impl_->set.size(); }

void PairSet::distances(std::span<const Pose> X_WB, const QueryOptions& options,
                        std::span<PairResult> results) {
  if (results.size() != size())
    throw UsageError("found room for " + std::to_string(results.size()) + " results, expected " +
                     std::to_string(size()));
  const query::PairOptions pair_options = facade::warmOptions(options);
  impl_->results.resize(size());
  impl_->set.distances(impl_->place(X_WB), pair_options, impl_->results);
  for (std::size_t i = 0; i < results.size(); ++i) results[i] = facade::resultOf(impl_->results[i]);
}

std::span<const PairSet::Contact> PairSet::contacts(std::span<const Pose> X_WB, const QueryOptions& options) {
  const query::PairOptions pair_options = facade::warmOptions(options);
  impl_->contacts.clear();
  for (const auto& [pair, penalty] : impl_->set.contacts(impl_->place(X_WB), pair_options))
    impl_->contacts.push_back(
        {pair, penalty.depth, penalty.force_a, penalty.torque_a, penalty.torque_b, penalty.contacts});
  return impl_->contacts;
}

PairSet::Nearest PairSet::nearest(std::span<const Pose> X_WB, const QueryOptions& options) {
  const query::PairOptions pair_options = facade::warmOptions(options);
  const query::PairSet::Nearest& nearest = impl_->set.nearest(impl_->place(X_WB), pair_options);
  return {nearest.pair, facade::resultOf(nearest.result)};
}

}  // namespace abstand
