// The window on a running server: it shows the server's distances, goes back, and says when nothing is known.
#include <gtest/gtest.h>

#include <QAction>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QStatusBar>
#include <QTimer>
#include <nlohmann/json.hpp>

#include "app/serve/udp_socket.hpp"
#include "app/viewer/live_record.hpp"
#include "core/base/text_file.hpp"
#include "tests/ui/studio_window.hpp"
#include "ui/live_commands.hpp"
#include "ui/model/pair_level.hpp"
#include "ui/model/playback.hpp"
#include "ui/panels/margin_tools.hpp"
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
    timer.start(10);
    return listens;
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
