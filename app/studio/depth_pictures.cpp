#include "app/studio/depth_pictures.hpp"

#include <algorithm>

#include "tracking/tracker/track_picture.hpp"

namespace abstand::studio {

namespace {

using humanmodel::JointState;

QImage imageOf(const tracking::ColourImage& picture) {
  static_assert(sizeof(picture.pixels[0]) == 3);
  const auto* bytes = reinterpret_cast<const uchar*>(picture.pixels.data());
  return QImage(bytes, picture.width, picture.height, 3 * picture.width, QImage::Format_RGB888).copy();
}

std::vector<ui::DepthJoint> jointsOf(const humanmodel::SkeletonFrame& frame,
                                     const tracking::DepthCamera& camera) {
  const Transform X_CW = camera.X_WC.inverse();
  std::vector<ui::DepthJoint> joints;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const std::string_view name = humanmodel::jointName(static_cast<humanmodel::Joint>(j));
    ui::DepthJoint joint;
    joint.name = QString::fromUtf8(name.data(), static_cast<int>(name.size()));
    const Vector3d p_C = X_CW * frame.p[j];
    if (frame.state[j] != JointState::kMissing && p_C.z() > 0.0) {
      const Eigen::Vector2d pixel = camera.pixelOf(p_C);
      joint.look = jointLook(frame.state[j]);
      // The centre of pixel (0, 0) is half a pixel from the image's corner.
      joint.at = {pixel.x() + 0.5, pixel.y() + 0.5};
      joint.spread = frame.spread[j];
    }
    joints.push_back(joint);
  }
  return joints;
}

ui::DepthSummary summaryOf(const DepthPerson& person) {
  const tracking::FittedClip& clip = *person.clip;
  ui::DepthSummary summary;
  summary.person = QString::fromStdString(person.name);
  summary.camera = QStringLiteral("%1 × %2").arg(clip.camera.width).arg(clip.camera.height);
  summary.reason = QString::fromStdString(clip.camera_reason + "\n" + clip.world);
  summary.images = clip.images.size();
  summary.found = static_cast<std::size_t>(
      std::count_if(clip.images.begin(), clip.images.end(), [](const auto& image) { return image.found; }));
  return summary;
}

/// Session time of an image, and the other way round: the recording begins when it does, at its own speed.
double sessionTime(const DepthPerson& person, double t) {
  return person.clip->first_t + (t - person.clip->first_t) / person.speed;
}
double recordingTime(const DepthPerson& person, double t) {
  return person.clip->first_t + (t - person.clip->first_t) * person.speed;
}

}  // namespace

ui::JointLook jointLook(JointState state) {
  switch (state) {
    case JointState::kTracked:
      return ui::JointLook::kTracked;
    case JointState::kInferred:
      return ui::JointLook::kInferred;
    case JointState::kMissing:
      break;
  }
  return ui::JointLook::kUnknown;
}

std::size_t imageOfMoment(const DepthPerson& person, double t) {
  // The time of an image survives both conversions only to rounding.
  constexpr double kRounding = 1e-9;  // s
  return person.clip->imageAt(recordingTime(person, t) + kRounding);
}

std::vector<DepthPerson> depthPeople(const session::Session& session) {
  std::vector<DepthPerson> people;
  for (std::size_t i = 0; i < session.humans().size(); ++i) {
    const auto& clip = session.humans()[i]->fitted();
    const scene_file::HumanDescription& description = session.description().humans[i];
    const auto& place = description.recording;
    if (clip)
      people.push_back({description.name, clip, place.speed,
                        fromXyzRpy(place.place_xyz, Vector3d(0, 0, place.place_yaw))});
  }
  return people;
}

ui::DepthPicture depthPicture(const DepthPerson& person, tracking::DepthStream& stream, std::size_t image) {
  const tracking::FittedClip& clip = *person.clip;
  ui::DepthPicture shown;
  shown.image = image;
  shown.t = sessionTime(person, clip.times[image]);
  const tracking::FittedImage& fitted = clip.images[image];
  shown.found = fitted.found;
  shown.joints = jointsOf(fitted.joints, clip.camera);
  tracking::DepthFrame frame;
  stream.seek(image);
  if (!stream.next(frame)) return shown;
  tracking::ColourImage picture(frame.image.width, frame.image.height);
  tracking::drawDepth(frame.image, 0, picture);
  shown.plain = imageOf(picture);
  if (fitted.found) {
    tracking::RigPlacement X_WS;
    tracking::place(*fitted.rig, fitted.pose, X_WS);
    tracking::drawBody(frame.image, clip.camera, *fitted.rig, X_WS, 0, picture);
  }
  shown.body = imageOf(picture);
  return shown;
}

DepthPictures::DepthPictures(std::vector<DepthPerson> people)
    : people_(std::move(people)),
      streams_(people_.size()),
      reader_([this](const Wanted& wanted) { return read(wanted); }) {
  for (const DepthPerson& person : people_) summaries_.push_back(summaryOf(person));
}

std::size_t DepthPictures::imageAt(int person, double t) const {
  return imageOfMoment(people_.at(static_cast<std::size_t>(person)), t);
}

ui::DepthPicture DepthPictures::read(const Wanted& wanted) {
  const auto i = static_cast<std::size_t>(wanted.person);
  ui::DepthPicture picture;
  try {
    if (!streams_[i])
      streams_[i] = tracking::openDepthStream(people_[i].clip->path, people_[i].clip->options);
    picture = depthPicture(people_[i], *streams_[i], wanted.image);
  } catch (const std::exception& e) {
    // The file may have gone since it was tracked.
    picture = {};
    picture.image = wanted.image;
    picture.t = sessionTime(people_[i], people_[i].clip->times[wanted.image]);
    picture.problem = QString::fromUtf8(e.what());
    streams_[i].reset();
  }
  picture.person = wanted.person;
  return picture;
}

}  // namespace abstand::studio
