// abstand-studio: the desktop program.
#include <QApplication>
#include <QCommandLineParser>
#include <QFile>
#include <QJsonDocument>
#include <QSettings>
#include <QTextStream>
#include <QTimer>
#include <algorithm>
#include <csignal>
#include <functional>
#include <optional>
#include <string_view>

#include "app/cli/version.hpp"
#include "app/studio/heap_care.hpp"
#include "app/studio/probe.hpp"
#include "app/studio/soak.hpp"
#include "app/studio/studio.hpp"
#include "core/base/error.hpp"
#include "core/base/input_log.hpp"
#include "core/base/number.hpp"
#include "core/base/output_place.hpp"
#include "ui/document/autosave.hpp"
#include "ui/file_commands.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/project_commands.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/file_kinds.hpp"
#include "ui/style/language.hpp"
#include "ui/style/picture_file.hpp"
#include "ui/style/theme.hpp"
#include "ui/viewport/opengl.hpp"
#include "ui/window_grab.hpp"

namespace {

using namespace abstand;

constexpr int kWrongUsage = 2, kBadInput = 3, kNotWritten = 4;
constexpr int kSettleMs = 700;         // until the first snapshots are drawn
constexpr int kLongestWaitMs = 20000;  // for the analysis of a recording that shall be in a picture
const QSize kUnattendedSize(1500, 950);

int fail(int code, const QString& text) {
  QTextStream(stderr) << text << "\n";
  return code;
}

struct Arguments {
  QStringList files;
  QString recording, server, screenshot;
  robot_file::PackagePaths packages;
  bool react{true};
  std::optional<QSize> size;
  ui::Language language{ui::Language::kSystem};
  double at{0.0};
  double play_s{0.0};
  double probe_s{0.0};
  double soak_s{0.0};

  bool measures() const { return probe_s > 0.0 || soak_s > 0.0; }
};

/// A picture and a figure depend on the command line alone.
bool isUnattended(const QStringList& arguments) {
  return std::any_of(arguments.begin(), arguments.end(), [](const QString& a) {
    return a.startsWith("--screenshot") || a.startsWith("--probe") || a.startsWith("--soak");
  });
}

/// That of --language, else what was chosen in the window. Read before the other options, whose help is in
/// this language, too.
ui::Language languageFor(const QStringList& arguments) {
  ui::Language language = isUnattended(arguments) ? ui::Language::kEnglish : ui::chosenLanguage();
  for (int i = 1; i < arguments.size(); ++i) {
    QString word = arguments[i];
    if (word == "--language")
      word = arguments.value(i + 1);
    else if (word.startsWith("--language="))
      word = word.section('=', 1);
    else
      continue;
    language = ui::languageOf(word).value_or(language);
  }
  return language;
}

void describeOptions(QCommandLineParser& parser) {
  parser.setApplicationDescription(QCoreApplication::translate(
      "main",
      "Shows how close people come to robots. An analysis tool, not a safety function.\n"
      "Example: abstand-studio data/scenes/hug_boxing.yaml --at 5"));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(
      "file",
      QCoreApplication::translate(
          "main", "projects, scenes, robots, meshes and recordings; several are shown together"),
      "[FILE...]");
  parser.addOption({"recording",
                    QCoreApplication::translate("main", "recording that replaces those of the scene"),
                    "FILE"});
  parser.addOption(
      {"connect",
       QCoreApplication::translate("main", "show what a running abstand serve computes at this address"),
       "HOST:PORT"});
  parser.addOption(
      {"package-path",
       QCoreApplication::translate("main", "folder that holds ROS packages; may be given several times"),
       "FOLDER"});
  parser.addOption({"at", QCoreApplication::translate("main", "start at this time"), "SECONDS"});
  parser.addOption(
      {"react",
       QCoreApplication::translate("main", "off: robots follow their planned motion regardless of people"),
       "on|off", "on"});
  parser.addOption({"screenshot", QCoreApplication::translate("main", "save a picture of the window and end"),
                    "FILE.png"});
  parser.addOption({"size", QCoreApplication::translate("main", "size of the window"), "WxH"});
  parser.addOption({"play", QCoreApplication::translate("main", "play this long first"), "SECONDS"});
  parser.addOption(
      {"probe",
       QCoreApplication::translate(
           "main", "play this long, print frame rate, stalls and processor time as JSON, and end"),
       "SECONDS"});
  parser.addOption({"soak",
                    QCoreApplication::translate(
                        "main", "work this long on the scene, print memory over time as JSON, and end"),
                    "SECONDS"});
  parser.addOption(
      {"language", QCoreApplication::translate("main", "language of texts and numbers"), "system|en|de"});
}

/// False, with a sentence on stderr, for wrong usage.
bool parse(const QStringList& arguments, Arguments& args) {
  QCommandLineParser parser;
  describeOptions(parser);
  if (!parser.parse(arguments)) {
    fail(kWrongUsage, "abstand-studio: error: " + parser.errorText());
    return false;
  }
  if (parser.isSet("help")) parser.showHelp();
  if (parser.isSet("version")) parser.showVersion();
  const auto number = [&](const char* option, double& into) {
    if (!parser.isSet(option)) return true;
    const auto v = parseDouble(parser.value(option).toStdString());
    if (v && *v >= 0.0)
      into = *v;
    else
      fail(kWrongUsage, QString("abstand-studio: error: --%1: found '%2', expected seconds")
                            .arg(option, parser.value(option)));
    return v && *v >= 0.0;
  };
  if (!number("at", args.at) || !number("play", args.play_s) || !number("probe", args.probe_s) ||
      !number("soak", args.soak_s))
    return false;
  if (parser.isSet("size")) {
    const QStringList wh = parser.value("size").split('x');
    if (wh.size() == 2) args.size = QSize(wh[0].toInt(), wh[1].toInt());
    if (wh.size() != 2 || args.size->width() < 200 || args.size->height() < 200) {
      fail(kWrongUsage, "abstand-studio: error: --size: expected WxH, at least 200x200");
      return false;
    }
  }
  const QString react = parser.value("react");
  if (react != "on" && react != "off") {
    fail(kWrongUsage, QString("abstand-studio: error: --react: found '%1', expected on or off").arg(react));
    return false;
  }
  args.react = react == "on";
  if (parser.isSet("language") && !ui::languageOf(parser.value("language"))) {
    fail(kWrongUsage, QString("abstand-studio: error: --language: found '%1', expected system, en or de")
                          .arg(parser.value("language")));
    return false;
  }
  args.language = languageFor(arguments);
  args.files = parser.positionalArguments();
  args.recording = parser.value("recording");
  args.server = parser.value("connect");
  args.screenshot = parser.value("screenshot");
  for (const QString& folder : parser.values("package-path"))
    args.packages.folders.emplace_back(QFile::encodeName(folder).toStdString());
  if (args.measures() && args.files.isEmpty() && args.recording.isEmpty()) {
    fail(kWrongUsage, QString("abstand-studio: error: --%1: found nothing to play, expected a FILE")
                          .arg(args.probe_s > 0.0 ? "probe" : "soak"));
    return false;
  }
  if (args.files.size() > 1 && !args.server.isEmpty()) {
    fail(kWrongUsage, "abstand-studio: error: --connect: found several files, expected one scene");
    return false;
  }
  return true;
}

/// Exit code for work that writes or checks an output.
int written(const std::function<void()>& work) {
  try {
    work();
    return 0;
  } catch (const UsageError& e) {
    return fail(kWrongUsage, QString("abstand-studio: error: ") + QString::fromUtf8(e.what()));
  } catch (const std::exception& e) {
    return fail(kNotWritten, QString("abstand-studio: error: ") + QString::fromUtf8(e.what()));
  }
}

/// Waits until the analysis of the recording has ended, but not for ever, and then until the moment is drawn;
/// saves the picture and ends the program.
void saveWhenAnalysed(ui::MainWindow& window, const Arguments& args, int waited_ms = 0) {
  using State = view::AnalysisNews::State;
  const ui::RecordingReview& review = window.review();
  const bool busy = review.available() && review.state() != State::kDone && review.state() != State::kFailed;
  if (busy && waited_ms < kLongestWaitMs) {
    QTimer::singleShot(kSettleMs, &window,
                       [&window, args, waited_ms] { saveWhenAnalysed(window, args, waited_ms + kSettleMs); });
    return;
  }
  QTimer::singleShot(kSettleMs, &window, [&window, args] {
    QApplication::exit(written([&] { ui::savePicture(ui::grabWindow(window), args.screenshot); }));
  });
}

/// Plays for `play_s` before.
void takePicture(ui::MainWindow& window, const Arguments& args) {
  if (args.play_s > 0.0) window.playback().setPlaying(true);
  QTimer::singleShot(static_cast<int>(1000.0 * args.play_s), &window, [&window, args] {
    window.playback().setPlaying(false);
    saveWhenAnalysed(window, args);
  });
}

void seekWhenReady(studio::Studio& studio, ui::MainWindow& window, double t) {
  if (t > 0.0)
    QObject::connect(&studio, &studio::Studio::ready, &window, [&window, t] { window.playback().seek(t); });
}

/// Asks for the files of the command line. False: none of them can be opened.
bool open(studio::Studio& studio, ui::MainWindow& window, const Arguments& args) {
  const QString file = args.files.value(0);
  if (!args.server.isEmpty()) {
    studio.connectTo(args.server, file);
    return true;
  }
  const auto open_together = [&] {
    seekWhenReady(studio, window, args.at);
    return window.files().open(args.recording.isEmpty() ? args.files
                                                        : args.files + QStringList{args.recording});
  };
  if (args.files.size() > 1) return open_together();
  if (!args.recording.isEmpty() && ui::kindOf(args.recording) == ui::FileKind::kMoments) {
    studio.openMoments(args.recording, file);
    return true;
  }
  switch (file.isEmpty() ? ui::FileKind::kUnknown : ui::kindOf(file)) {
    case ui::FileKind::kProject:
      seekWhenReady(studio, window, args.at);
      window.projects().open(file);
      break;
    case ui::FileKind::kMoments:
      studio.openMoments(file, QString());
      return true;
    case ui::FileKind::kRecording:
      studio.openRecording(file);
      break;
    case ui::FileKind::kMesh:
      return open_together();
    case ui::FileKind::kScene:
    case ui::FileKind::kRobot:
    case ui::FileKind::kMargins:
    case ui::FileKind::kUnknown:
      // What a scene is its reader says best.
      if (!file.isEmpty()) {
        studio.openScene(file, args.recording, args.at);
        return true;
      }
  }
  if (!args.recording.isEmpty()) studio.openRecording(args.recording);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  using abstand::studio::Studio;
  // Makes writes to a closed pipe or beyond a limit fail instead of ending the program.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  const bool picture =
      std::any_of(argv, argv + argc, [](const char* a) { return std::string_view(a) == "--screenshot"; });
  ui::prepareOpenGl(picture);
  QCoreApplication::setOrganizationName("Abstand");
  QCoreApplication::setApplicationName("abstand-studio");
  QCoreApplication::setApplicationVersion(cli::kVersion);
  Arguments args;
  {
    // What needs no window needs no display.
    QCoreApplication words(argc, argv);
    ui::applyLanguage(words, languageFor(words.arguments()));
    if (!parse(words.arguments(), args)) return kWrongUsage;
  }
  studio::limitArenas();
  QApplication app(argc, argv);
  ui::applyLanguage(app, args.language);
  if (!args.screenshot.isEmpty()) {
    // Checked before expensive work; a picture must not replace one of its inputs.
    keepInputLog();
    const auto place = [&args] { placeOfOutput(QFile::encodeName(args.screenshot).toStdString()); };
    if (const int code = written(place)) return code;
  }
  const bool unattended = !args.screenshot.isEmpty() || args.measures();
  if (unattended) {
    // Neither a picture nor a figure may depend on stored window settings.
    QCoreApplication::setApplicationName("abstand-studio-picture");
    QSettings().clear();
  }
  ui::applyTheme(app, ui::themeOf(app.palette()));
  ui::MainWindow window;
  if (args.size || unattended) window.resize(args.size.value_or(kUnattendedSize));
  window.show();
  window.actions()[ui::ActionId::kReact]->setChecked(args.react);
  window.projects().setDialogs(!unattended);
  Studio studio(window, args.packages);
  if (unattended) {
    auto* probe = args.probe_s > 0.0 ? new studio::Probe(window, args.probe_s, &window) : nullptr;
    auto* soak = args.soak_s > 0.0 && !probe ? new studio::Soak(window, args.soak_s, &window) : nullptr;
    QObject::connect(&studio, &Studio::ready, &window, [&args, &window, probe, soak] {
      const auto print = [](const QJsonObject& figures) {
        QTextStream(stdout) << QJsonDocument(figures).toJson();
        QApplication::exit(0);
      };
      if (probe) return probe->start(print);
      if (soak) return soak->start(print);
      takePicture(window, args);
    });
    // Later, when the event loop runs and can be ended.
    QObject::connect(
        &studio, &Studio::failed, &window,
        [](const QString& problem) { QApplication::exit(fail(kBadInput, problem)); }, Qt::QueuedConnection);
    const auto tell = [](const QString& sentences) { QTextStream(stderr) << sentences << "\n"; };
    QObject::connect(&window.files(), &ui::FileCommands::failed, &window,
                     [tell](const QString&, const QString& problem) { tell(problem); });
    QObject::connect(&studio, &Studio::leftOut, &window,
                     [tell](const QStringList& sentences) { tell(sentences.join(QLatin1Char('\n'))); });
    if (args.files.isEmpty() && args.recording.isEmpty() && args.server.isEmpty()) takePicture(window, args);
  } else {
    window.keepAutosaves(ui::Autosave::standardFolder());
  }
  if (!open(studio, window, args) && unattended) return kBadInput;
  return QApplication::exec();
}
