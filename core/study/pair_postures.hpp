// Poses and distances of a pair study's bodies in one posture; internal to it.
#pragma once

#include <span>

#include "core/query/pair_query.hpp"
#include "core/study/pair_study.hpp"

namespace abstand::study {

/// Constant; shared by the threads of a study.
class StudyModel {
 public:
  StudyModel(const std::vector<StudyMechanism>& mechanisms, const std::vector<StudyBody>& bodies);

  std::size_t dof() const { return ranges_.size(); }
  const std::vector<mechanism::JointRange>& ranges() const { return ranges_; }
  const std::vector<StudyBody>& bodies() const { return bodies_; }
  const StudyBody& body(int i) const { return bodies_[static_cast<std::size_t>(i)]; }
  const StudyMechanism& mechanism(int i) const { return mechanisms_[static_cast<std::size_t>(i)]; }
  std::size_t mechanisms() const { return mechanisms_.size(); }
  /// Index in q of a mechanism's first value.
  std::size_t first(int mechanism) const { return first_[static_cast<std::size_t>(mechanism)]; }
  /// The dofs, as indices of the study's q, that move the two bodies relative to each other.
  std::vector<int> dofsBetween(int a, int b) const;

 private:
  void addDofs(const StudyBody& body, int down_to, std::vector<int>& dofs) const;

  const std::vector<StudyMechanism>& mechanisms_;
  const std::vector<StudyBody>& bodies_;
  std::vector<mechanism::JointRange> ranges_;
  std::vector<std::size_t> first_;
};

/// One posture with its poses; one for each thread.
class StudyPosture {
 public:
  explicit StudyPosture(const StudyModel& model);

  void set(std::span<const double> q);
  /// Lower bound (m) of the distance, from the bounding spheres.
  double gap(int a, int b) const;
  const query::PairResult& query(int a, int b);
  /// Adds the derivative with respect to q of the distance of the last query(a, b). False if the witness
  /// points coincide.
  bool addGradient(int a, int b, std::span<double> gradient) const;

 private:
  void addPointGradient(const StudyBody& body, const Vector3d& p_W, const Vector3d& n_W,
                        std::span<double> gradient) const;

  const StudyModel& model_;
  std::vector<mechanism::MechanismState> states_;
  std::vector<Transform> X_WL_;
  std::vector<Vector3d> centres_W_;
  kernels::PairScratch scratch_;
  query::PairResult result_;
};

}  // namespace abstand::study
