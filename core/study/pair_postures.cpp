#include "core/study/pair_postures.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::study {

StudyModel::StudyModel(const std::vector<StudyMechanism>& mechanisms, const std::vector<StudyBody>& bodies)
    : mechanisms_(mechanisms), bodies_(bodies) {
  for (const auto& m : mechanisms_) {
    first_.push_back(ranges_.size());
    const auto ranges = mechanism::jointRanges(*m.mechanism);
    ranges_.insert(ranges_.end(), ranges.begin(), ranges.end());
  }
}

void StudyModel::addDofs(const StudyBody& body, int down_to, std::vector<int>& dofs) const {
  if (body.mechanism < 0) return;
  const auto& frames = mechanism(body.mechanism).mechanism->frames;
  for (int f = body.frame; f != down_to && f >= 0; f = frames[static_cast<std::size_t>(f)].parent)
    if (const int dof = frames[static_cast<std::size_t>(f)].dof; dof >= 0)
      dofs.push_back(static_cast<int>(first(body.mechanism)) + dof);
}

std::vector<int> StudyModel::dofsBetween(int a, int b) const {
  const StudyBody &body_a = body(a), &body_b = body(b);
  int common = -1;
  if (body_a.mechanism >= 0 && body_a.mechanism == body_b.mechanism) {
    // Parents come first, so the larger index cannot be an ancestor of the smaller one.
    const auto& frames = mechanism(body_a.mechanism).mechanism->frames;
    int f = body_a.frame, g = body_b.frame;
    while (f != g) (f > g ? f : g) = frames[static_cast<std::size_t>(std::max(f, g))].parent;
    common = f;
  }
  std::vector<int> dofs;
  addDofs(body_a, common, dofs);
  addDofs(body_b, common, dofs);
  std::sort(dofs.begin(), dofs.end());
  dofs.erase(std::unique(dofs.begin(), dofs.end()), dofs.end());
  return dofs;
}

StudyPosture::StudyPosture(const StudyModel& model)
    : model_(model),
      states_(model.mechanisms()),
      X_WL_(model.bodies().size()),
      centres_W_(model.bodies().size()) {}

void StudyPosture::set(std::span<const double> q) {
  ABSTAND_CHECK(q.size() == model_.dof());
  for (std::size_t m = 0; m < states_.size(); ++m) {
    const mechanism::Mechanism& mechanism = *model_.mechanism(static_cast<int>(m)).mechanism;
    mechanism::forward(mechanism,
                       q.subspan(model_.first(static_cast<int>(m)), static_cast<std::size_t>(mechanism.dof)),
                       states_[m]);
  }
  for (std::size_t i = 0; i < X_WL_.size(); ++i) {
    const StudyBody& body = model_.bodies()[i];
    X_WL_[i] = body.X_FL;
    if (body.mechanism >= 0) {
      const Transform& X_WB = model_.mechanism(body.mechanism).X_WB;
      X_WL_[i] = body.frame < 0 ? X_WB * body.X_FL
                                : X_WB *
                                      states_[static_cast<std::size_t>(body.mechanism)]
                                          .X_BF[static_cast<std::size_t>(body.frame)] *
                                      body.X_FL;
    }
    centres_W_[i] = X_WL_[i] * body.structure->bounding_sphere.centre;
  }
}

double StudyPosture::gap(int a, int b) const {
  return (centres_W_[static_cast<std::size_t>(a)] - centres_W_[static_cast<std::size_t>(b)]).norm() -
         model_.body(a).structure->bounding_sphere.radius - model_.body(b).structure->bounding_sphere.radius;
}

const query::PairResult& StudyPosture::query(int a, int b) {
  query::queryPair({*model_.body(a).structure, X_WL_[static_cast<std::size_t>(a)]},
                   {*model_.body(b).structure, X_WL_[static_cast<std::size_t>(b)]}, {}, scratch_, result_);
  return result_;
}

void StudyPosture::addPointGradient(const StudyBody& body, const Vector3d& p_W, const Vector3d& n_W,
                                    std::span<double> gradient) const {
  if (body.mechanism < 0 || body.frame < 0) return;
  const StudyMechanism& m = model_.mechanism(body.mechanism);
  const Transform X_BW = m.X_WB.inverse();
  mechanism::addJointEfforts(
      *m.mechanism, states_[static_cast<std::size_t>(body.mechanism)], body.frame, X_BW * p_W,
      {X_BW.linear() * n_W, Vector3d::Zero()},
      gradient.subspan(model_.first(body.mechanism), static_cast<std::size_t>(m.mechanism->dof)));
}

bool StudyPosture::addGradient(int a, int b, std::span<double> gradient) const {
  const Vector3d a_to_b = result_.witness_b - result_.witness_a;
  const double length = a_to_b.norm();
  if (!(length > 1e-12)) return false;
  const Vector3d n = (result_.distance < 0.0 ? -1.0 : 1.0) / length * a_to_b;
  addPointGradient(model_.body(b), result_.witness_b, n, gradient);
  addPointGradient(model_.body(a), result_.witness_a, -n, gradient);
  return true;
}

}  // namespace abstand::study
