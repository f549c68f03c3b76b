// Reads depth images and draws the fitted body over them, on a thread of its own.
#pragma once

#include <memory>

#include "app/session/session.hpp"
#include "app/studio/latest_request.hpp"
#include "tracking/tracker/fitted_clip.hpp"
#include "ui/model/depth_port.hpp"

namespace abstand::studio {

/// One person of a depth recording.
struct DepthPerson {
  std::string name;
  std::shared_ptr<const tracking::FittedClip> clip;
  double speed{1.0};                      ///< factor of the recorded speed
  Transform X_WR{Transform::Identity()};  ///< world of the clip's camera in that of the scene
};

/// The people of a session whose fits were kept (SessionOptions::keep_fits).
std::vector<DepthPerson> depthPeople(const session::Session& session);

/// Index of the image that a person's pose at `t` (s, of the session) comes from.
std::size_t imageOfMoment(const DepthPerson& person, double t);
ui::JointLook jointLook(humanmodel::JointState state);

/// Image `image` of a person. `stream` is that of the clip. Throws ParseError.
ui::DepthPicture depthPicture(const DepthPerson& person, tracking::DepthStream& stream, std::size_t image);

/// Reads the image that was asked for last.
class DepthPictures final : public ui::DepthPort {
 public:
  explicit DepthPictures(std::vector<DepthPerson> people);

  const std::vector<ui::DepthSummary>& people() const override { return summaries_; }
  std::size_t imageAt(int person, double t) const override;
  void ask(int person, std::size_t image) override { reader_.ask({person, image}); }
  bool take(ui::DepthPicture& out) override { return reader_.take(out); }

 private:
  struct Wanted {
    int person;
    std::size_t image;
  };
  ui::DepthPicture read(const Wanted& wanted);

  const std::vector<DepthPerson> people_;
  std::vector<ui::DepthSummary> summaries_;
  std::vector<std::unique_ptr<tracking::DepthStream>> streams_;  // of the thread of reader_
  LatestRequest<Wanted, ui::DepthPicture> reader_;               // last member: uses the others
};

}  // namespace abstand::studio
