#include "abstand/human.hpp"

#include "core/facade/structure_impl.hpp"
#include "humanmodel/facade/skeleton_frame.hpp"
#include "humanmodel/human_model.hpp"
#include "humanmodel/poser.hpp"

namespace abstand {

struct Human::Impl {
  humanmodel::HumanModel model;
  std::vector<HumanPart> parts;
};

struct HumanPoser::Impl {
  Human human;  ///< keeps the model alive
  humanmodel::Poser poser;
  humanmodel::HumanPose pose;
};

static_assert(kJoints == humanmodel::kJointCount);
static_assert(static_cast<int>(Joint::kHipRight) == static_cast<int>(humanmodel::Joint::kHipRight));

std::string jointName(Joint joint) {
  return std::string(humanmodel::jointName(static_cast<humanmodel::Joint>(joint)));
}

std::optional<Joint> findJoint(const std::string& name) {
  const auto joint = humanmodel::parseJoint(name);
  if (!joint) return std::nullopt;
  return static_cast<Joint>(*joint);
}

Human::Human(const HumanOptions& options) {
  humanmodel::HumanOptions o;
  o.height = options.height;
  o.mass = options.mass;
  if (options.sex == HumanOptions::Sex::kFemale) o.sex = humanmodel::Sex::kFemale;
  if (options.sex == HumanOptions::Sex::kMale) o.sex = humanmodel::Sex::kMale;
  if (options.thesis) o.preset = humanmodel::HumanPreset::kThesis;
  auto impl = std::make_shared<Impl>();
  impl->model = humanmodel::makeHuman(o);
  for (const humanmodel::HumanPart& part : impl->model.parts)
    impl->parts.push_back(
        {std::string(humanmodel::partName(part.part)), facade::shapeOf(part.shape), part.mass, part.com});
  impl_ = std::move(impl);
}

double Human::height() const { return impl_->model.height; }
double Human::mass() const { return impl_->model.mass; }
const std::vector<HumanPart>& Human::parts() const { return impl_->parts; }
Skeleton Human::rest() const { return facade::skeletonOf(impl_->model.rest); }

HumanPoser::HumanPoser(const Human& human, bool follow_lengths)
    : impl_(new Impl{human, humanmodel::Poser(human.impl().model, follow_lengths), {}}) {}
HumanPoser::~HumanPoser() = default;
HumanPoser::HumanPoser(HumanPoser&&) noexcept = default;
HumanPoser& HumanPoser::operator=(HumanPoser&&) noexcept = default;

void HumanPoser::calibrate(const std::vector<Skeleton>& recording) {
  std::vector<humanmodel::SkeletonFrame> frames;
  for (const Skeleton& skeleton : recording) frames.push_back(facade::frameOf(skeleton));
  impl_->poser.calibrate(frames);
}

HumanPose HumanPoser::pose(const Skeleton& skeleton) {
  impl_->poser.pose(facade::frameOf(skeleton), impl_->pose);
  HumanPose pose;
  for (std::size_t i = 0; i < humanmodel::kBodyPartCount; ++i) {
    pose.X_WP.emplace_back(impl_->pose.X_WP[i]);
    pose.state.push_back(static_cast<PartState>(impl_->pose.state[i]));
    pose.age.push_back(impl_->pose.age[i]);
  }
  return pose;
}

}  // namespace abstand

namespace abstand::facade {

humanmodel::SkeletonFrame frameOf(const Skeleton& skeleton) {
  humanmodel::SkeletonFrame frame;
  frame.t = skeleton.t;
  for (std::size_t i = 0; i < kJoints; ++i) {
    frame.p[i] = skeleton.p[i];
    frame.state[i] = static_cast<humanmodel::JointState>(skeleton.state[i]);
    frame.spread[i] = skeleton.spread[i];
    if (!skeleton.lateral[i].isZero(0.0f)) frame.lateral[i] = skeleton.lateral[i];
  }
  return frame;
}

Skeleton skeletonOf(const humanmodel::SkeletonFrame& frame) {
  Skeleton skeleton;
  skeleton.t = frame.t;
  for (std::size_t i = 0; i < kJoints; ++i) {
    skeleton.p[i] = frame.p[i];
    skeleton.state[i] = static_cast<JointState>(frame.state[i]);
    skeleton.spread[i] = frame.spread[i];
    skeleton.lateral[i] = frame.lateral[i];
  }
  return skeleton;
}

}  // namespace abstand::facade
