// The window on a running server: it shows the server's distances, goes back, and says when nothing is known.
#include <gtest/gtest.h>

#include <QAction>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QStatusBar>
#include <QTimer>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/serve/udp_socket.hpp"
#include "app/studio/viewer_review.hpp"
#include "app/viewer/live_record.hpp"
#include "core/base/text_file.hpp"
#include "tests/app/viewer/example_moment.hpp"
#include "tests/ui/studio_window.hpp"
#include "ui/live_commands.hpp"
#include "ui/model/event_text.hpp"
#include "ui/model/pair_level.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/panels/lane_view.hpp"
#include "ui/panels/margin_tools.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/elided_label.hpp"

namespace abstand::studio {
namespace studio_live_test {

using Id = ui::ActionId;
constexpr int kLimitMs = 60000;  // nothing takes so long
// Of the answer: a robot of 32 bytes, a joint of 8 and a link of 48 after 64, then the nearest pair's
// distance.
constexpr std::size_t kDistanceAt = 64 + 32 + 8 + 48 + 16;

/// A ball on a vertical slide over a plate whose top lies at z = 0, moved by packets every 10 ms.
struct StudioLive : StudioWindow {
  StudioLive() {
    folder.write("slide.mech", "chain\n    frame   1   0      0          d    0\nend_chain\n");
    write("scene.yaml", 0.07);
    qputenv("ABSTAND_CACHE", (folder.path() / "cache").c_str());
    QObject::connect(&timer, &QTimer::timeout, [this] { exchange(); });
  }
  ~StudioLive() override {
    timer.stop();
    server.kill();
    server.waitForFinished();
  }
  void write(const char* name, double margin) {
    folder.write(name,
                 "abstand: 1\ndefaults: {voxel: 0.02, point: 0.02}\nmechanisms:\n  - name: slide\n    file: "
                 "slide.mech\n"
                 "    links: [{name: ball, frame: 1, margin: " +
                     std::to_string(margin) +
                     ", shape: {sphere: {radius: 0.1}}}]\nobjects:\n"
                     "  - {name: plate, shape: {cuboid: {size: [1, 1, 0.2]}}, pose: {xyz: [0, 0, -0.1]}}\n");
  }
  /// True when a server listens and has answered a packet.
  bool serve(const QString& port = QStringLiteral("0")) {
    server.start(ABSTAND_PROGRAM, {"serve", in("scene.yaml"), "--bind", "127.0.0.1:" + port, "--nearest", "1",
                                   "--stale", "5", "--resume", "0"});
    QString said;
    const bool listens = QTest::qWaitFor(
        [&] {
          said += QString::fromUtf8(server.readAllStandardError());
          return said.contains(QRegularExpression("listening on 127.0.0.1:\\d+\\n"));
        },
        kLimitMs);
    address = QRegularExpression("127.0.0.1:\\d+").match(said).captured();
    // A window that connects before the first packet records the slide at its zero position, in the plate.
    answered = kNaN;
    timer.start(10);
    return listens && QTest::qWaitFor([&] { return std::isfinite(answered); }, kLimitMs);
  }
  /// Sends the height, and reads answers.
  void exchange() {
    struct {
      char magic[4]{'A', 'B', 'S', 'T'};
      std::uint16_t version{1}, type{1};
      std::uint32_t sequence, index{0xffffffff};
      std::uint64_t time;
      std::uint32_t flags{0}, bytes{40};
      double q;
    } packet;
    packet.sequence = sequence++;
    packet.time = 10000 * packet.sequence;
    packet.q = height;
    socket.send(std::as_bytes(std::span(&packet, 1)), serve::parseAddress(address.toStdString(), "server"));
    std::array<std::byte, 2048> answer;
    serve::Address from;
    while (const auto bytes = socket.receive(answer, from))
      if (*bytes >= kDistanceAt + 8) std::memcpy(&answered, answer.data() + kDistanceAt, sizeof answered);
  }
  bool connects() {
    return opens([this] { studio.connectTo(address, QString()); });
  }
  double shown() const { return window.moment().pairs.at(0).result.distance; }
  /// True when the ball is at `z` (m) in the server's answers and in the window.
  bool shows(double z) {
    height = z;
    // The answer to this height is nearer to it than the bound of the structures, 30 mm at most.
    return QTest::qWaitFor([&] { return std::abs(answered - (z - 0.1)) < 0.03 && shown() == answered; },
                           kLimitMs);
  }
  QString status() { return window.statusBar()->findChild<ui::ElidedLabel*>("live")->text(); }
  bool says(const char* word) {
    return QTest::qWaitFor([&] { return status().contains(QLatin1String(word)); }, kLimitMs);
  }
  QAction& action(Id id) { return *window.actions()[id]; }

  QProcess server;
  QString address;
  serve::UdpSocket socket{serve::parseAddress("127.0.0.1:0", "client")};
  QTimer timer;
  double height{0.4}, answered{kNaN};
  std::uint32_t sequence{0};
};

TEST_F(StudioLive, ShowsGoesBackSavesAndGoesStale) {
  ASSERT_TRUE(serve());
  ASSERT_TRUE(connects()) << problem;
  EXPECT_EQ(work().scene, in("scene.yaml"));
  ASSERT_TRUE(shows(0.4));
  EXPECT_TRUE(says("connected"));
  const double then = window.moment().t, before = shown();
  // The server decides.
  for (const Id id : {Id::kReact, Id::kMargins50, Id::kLinkUp, Id::kReload})
    EXPECT_FALSE(action(id).isEnabled());
  EXPECT_TRUE(action(Id::kReact).toolTip().contains("server"));
  EXPECT_FALSE(window.panels().margin_tools->isEnabled());
  EXPECT_NEAR(window.moment().objects.at(0).margin, 0.07, 1e-12);

  ASSERT_TRUE(shows(0.7));
  EXPECT_GT(window.moment().t, then);
  window.playback().setPlaying(false);
  window.playback().seek(then);
  EXPECT_TRUE(QTest::qWaitFor([&] { return shown() == before; }, kLimitMs));
  EXPECT_TRUE(says("ago"));
  EXPECT_FALSE(window.playback().playing());
  action(Id::kToLive).trigger();
  ASSERT_TRUE(shows(0.7));
  EXPECT_TRUE(says("connected"));

  const QString file = in("live.moments");
  Q_EMIT window.live().saveWanted(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return QFileInfo::exists(file); }, kLimitMs));

  server.kill();
  QElapsedTimer since;
  since.start();
  ASSERT_TRUE(says("stale"));
  // At once, as the system closes the connection; after kStaleAfter in any case. The rest is a busy machine.
  EXPECT_LT(since.elapsed(), 1e3 * viewer::kStaleAfter + 5000);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return window.moment().objects.at(0).pose_state == scene::PoseState::kStale; }, kLimitMs));
  EXPECT_EQ(ui::pairLevel(window.moment(), window.moment().pairs[0], {0, 1}), ui::PairLevel::kLost);

  // The file shows the same, in the window and on the command line.
  ASSERT_TRUE(opens([&] { studio.openMoments(file, QString()); })) << problem;
  window.playback().seek(then);
  EXPECT_TRUE(QTest::qWaitFor([&] { return shown() == before; }, kLimitMs));
  EXPECT_TRUE(says("recorded"));
  EXPECT_FALSE(action(Id::kDisconnect).isEnabled());
  const std::string out = in("run.json").toStdString();
  const std::string command = std::string("'" ABSTAND_PROGRAM "' run '") + in("scene.yaml").toStdString() +
                              "' --poses '" + file.toStdString() + "' --json >'" + out + "' 2>/dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const auto answer = nlohmann::json::parse(readFile(out));
  EXPECT_NEAR(answer["min_distance"]["value"].get<double>(), before,
              window.moment().pairs[0].result.bound + 1e-9);
}

/// A record of moments without a server: the person's torso at a known distance from the robot.
struct ReviewOfMoments : ::testing::Test {
  static constexpr double kPeriod = 0.05;  // s, longer than that of the moments that are kept
  /// Of half floats and steps of the store.
  static constexpr double kStored = 2e-3;  // m

  ReviewOfMoments() {
    for (const char* name : {"arm/link1", "anna/torso", "wall"})
      outline.objects.push_back({name, "", false, true});
    outline.objects[0].group = "arm";
    outline.objects[1].group = "anna";
    outline.objects[1].human = true;
    outline.objects[2].group = "objects";
    outline.pairs = {{0, 1}, {0, 2}, {1, 2}};
    outline.frame_period = kPeriod;
    record->begin(moment::exampleCard(), viewer::LinkState::kConnected, 0.0);
  }
  static double distance(double t) { return 0.3 + 0.2 * std::sin(t); }
  void add(double t, bool seen = true) {
    moment::Moment m = moment::exampleMoment(t, distance(t));
    for (view::ObjectSnapshot& object : m.shown.objects) {
      object.pose_uncertainty = 0.01;
      object.pose_state = seen ? scene::PoseState::kFresh : scene::PoseState::kStale;
    }
    ASSERT_TRUE(record->add(moment::exampleFrame(m), m, t));
  }
  void open() {
    outline.end = record->span().last + 1.0;
    port.emplace(record, outline);
    review.open(&*port, outline, {0.05, 0.05, 0.0});
  }
  /// All moments that are kept are in the review.
  bool caughtUp() {
    return QTest::qWaitFor(
        [&] {
          review.pull();
          return review.store() && !review.store()->empty() &&
                 review.store()->t(review.store()->frames() - 1) == record->span().last;
        },
        kLimitMs);
  }

  std::shared_ptr<viewer::LiveRecord> record = std::make_shared<viewer::LiveRecord>();
  view::SceneOutline outline;
  std::optional<ViewerReview> port;
  ui::RecordingReview review;
};

TEST_F(ReviewOfMoments, LanesHaveEveryMomentAndGrow) {
  for (int i = 0; i < 600; ++i) add(kPeriod * i);
  open();
  ASSERT_TRUE(caughtUp());
  EXPECT_EQ(review.state(), view::AnalysisNews::State::kLive);
  ASSERT_EQ(review.store()->layout().pairs.size(), 1u) << "of people and robots alone";
  EXPECT_EQ(review.store()->layout().parts[0].name, "anna/torso");
  EXPECT_EQ(review.store()->frames(), 600u);
  const auto expectExact = [&] {
    for (std::size_t i = 0; i < review.store()->frames(); ++i) {
      const double t = review.store()->t(i);
      const auto nearest = review.store()->nearest(0, i);
      EXPECT_NEAR(nearest.distance, distance(t), kStored);
      // Certified: bound 1 mm and 10 mm of each pose.
      EXPECT_LE(nearest.clearance, distance(t) - 0.021 + 1e-9);
      EXPECT_NEAR(nearest.clearance, distance(t) - 0.021, kStored);
      EXPECT_FALSE(nearest.unknown);
    }
  };
  expectExact();
  // Below 0.1 m once in each period of the sine.
  long inside = 0;
  for (const auto& event : review.review().events) {
    inside += event.kind == margin::ReviewEvent::Kind::kIntrusion;
    EXPECT_FALSE(event.false_stop || event.missed) << "nothing is known between moments";
  }
  EXPECT_EQ(inside, 5);
  EXPECT_TRUE(ui::whatIfText(review).contains("Moments"));
  for (int i = 600; i < 700; ++i) add(kPeriod * i);
  ASSERT_TRUE(caughtUp());
  EXPECT_EQ(review.store()->frames(), 700u);
  expectExact();
}

TEST_F(ReviewOfMoments, StaleMomentsAreUnknown) {
  for (int i = 0; i < 40; ++i) add(kPeriod * i, i < 20 || i >= 30);
  open();
  ASSERT_TRUE(caughtUp());
  for (std::size_t i = 0; i < 40; ++i)
    EXPECT_EQ(review.store()->nearest(0, i).unknown, i >= 20 && i < 30) << i;
  EXPECT_TRUE(review.store()->look(0, 0, 40).unknown);
  EXPECT_FALSE(review.store()->look(0, 0, 20).unknown);
  ASSERT_FALSE(review.review().events.empty()) << "what is unknown is inside every margin";
}

TEST_F(ReviewOfMoments, KeepsTenMinutes) {
  for (int i = 0; i < 1500; ++i) add(0.5 * i);
  open();
  ASSERT_TRUE(caughtUp());
  const double first = record->span().first;
  EXPECT_GT(first, 0.0);
  for (int i = 1500; i < 2400; ++i) add(0.5 * i);
  ASSERT_TRUE(caughtUp());
  EXPECT_LE(review.store()->t(0), record->span().first);
  // Whole chunks are dropped.
  EXPECT_GT(review.store()->t(0), record->span().first - 0.5 * margin::ClearanceChunk::kFrames);
}

TEST_F(StudioLive, PersonHasALaneWhileConnected) {
  folder.write("scene.yaml",
               "abstand: 1\ndefaults: {voxel: 0.05, point: 0.05}\nmechanisms:\n  - name: slide\n    file: "
               "slide.mech\n    links: [{name: ball, frame: 1, shape: {sphere: {radius: 0.1}}}]\n"
               "humans:\n  - {name: anna}\n");
  ASSERT_TRUE(serve());
  ASSERT_TRUE(connects()) << problem;
  const ui::RecordingReview& review = window.review();
  EXPECT_TRUE(review.available());
  ASSERT_TRUE(QTest::qWaitFor([&] { return review.store() && review.store()->frames() > 10; }, kLimitMs));
  EXPECT_EQ(review.state(), view::AnalysisNews::State::kLive);
  EXPECT_FALSE(review.store()->layout().parts.empty());
  EXPECT_TRUE(window.panels().timeline->laneView()->isVisible());
  const std::size_t before = review.store()->frames();
  EXPECT_TRUE(QTest::qWaitFor([&] { return review.store()->frames() > before; }, kLimitMs)) << "they go on";
  for (std::size_t part = 0; part < review.store()->layout().parts.size(); ++part) {
    // As the window shows the newest moment: the person was never seen, so that nothing is known.
    EXPECT_EQ(review.store()->nearest(part, before - 1).unknown,
              window.moment().objects[review.store()->layout().parts[part].object].pose_state ==
                  scene::PoseState::kStale);
  }
}

TEST_F(StudioLive, FollowsAServerThatStartsAgainAndLetsGo) {
  ASSERT_TRUE(serve());
  ASSERT_TRUE(connects()) << problem;
  ASSERT_TRUE(shows(0.4));
  server.kill();
  server.waitForFinished();
  ASSERT_TRUE(says("stale"));
  const double last = window.moment().t;
  answered = kNaN;
  ASSERT_TRUE(serve(address.section(':', 1)));
  ASSERT_TRUE(shows(0.6));
  EXPECT_GT(window.moment().t, last);
  ASSERT_TRUE(opens([&] { action(Id::kDisconnect).trigger(); })) << problem;
  EXPECT_TRUE(action(Id::kMargins50).isEnabled());
  EXPECT_TRUE(window.panels().margin_tools->isEnabled());
  EXPECT_FALSE(window.statusBar()->findChild<ui::ElidedLabel*>("live")->isVisible());
}

TEST_F(StudioLive, SaysWhatDoesNotFit) {
  ASSERT_TRUE(serve());
  // Another content with the same bodies is shown and named.
  write("other.yaml", 0.02);
  ASSERT_TRUE(opens([&] { studio.connectTo(address, in("other.yaml")); })) << problem;
  EXPECT_TRUE(says("differs"));
  EXPECT_NEAR(window.moment().objects.at(0).margin, 0.07, 1e-12);
  // Other bodies are not.
  folder.write("none.yaml", "abstand: 1\nobjects:\n  - {name: door, shape: {sphere: {radius: 0.1}}}\n");
  EXPECT_FALSE(opens([&] { studio.connectTo(address, in("none.yaml")); }));
  EXPECT_NE(problem.find("bodies"), std::string::npos);
  server.kill();
  server.waitForFinished();
  EXPECT_FALSE(opens([&] { studio.connectTo(address, QString()); }));
  EXPECT_NE(problem.find("No answer"), std::string::npos);
  EXPECT_FALSE(opens([&] { studio.connectTo("nonsense", QString()); }));
  folder.write("bad.moments",
               "this is no recording of moments, but long enough to be one, if one were to count");
  EXPECT_FALSE(opens([&] { studio.openMoments(in("bad.moments"), QString()); }));
}

}  // namespace studio_live_test
}  // namespace abstand::studio
