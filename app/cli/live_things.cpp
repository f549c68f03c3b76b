#include "app/cli/live_things.hpp"

#include <cmath>

#include "app/cli/things_report.hpp"
#include "tracking/tracker/known_objects.hpp"

namespace abstand::cli {
namespace {

const std::string kPrefix = "scene: ";

constexpr double kOtherBand = 0.03;  // m, from which on another displacement is said

}  // namespace

LiveThings::LiveThings(const CommandLine& line, const LiveThingsArguments& args) {
  if (args.scene.empty()) return;
  std::optional<serve::Address> server;
  if (!args.server.empty()) server = serve::parseAddress(args.server, "--robots");
  session::SessionOptions options;
  options.cache = line.cache;
  options.monitor = buildMonitor(line);
  things_.emplace(args.scene.string(), scene_file::loadScene(args.scene, args.packages), options, server);
}

void LiveThings::update(std::chrono::steady_clock::time_point came) {
  if (things_) things_->update(std::chrono::duration<double>(came.time_since_epoch()).count());
}

tracking::KnownThings LiveThings::known() {
  if (!things_) return {};
  return [this](double, const tracking::DepthCamera& camera) { return things_->at(camera); };
}

tracking::KnownThings LiveThings::atRest() {
  if (!things_) return {};
  return [this](double, const tracking::DepthCamera& camera) { return things_->atRest(camera); };
}

std::vector<std::string> LiveThings::news(std::span<const tracking::ShownThings> shown,
                                          std::span<const std::string> names) {
  if (!things_) return {};
  std::vector<std::string> news = things_->news();
  said_shown_.resize(shown.size(), 1);
  said_bands_.resize(shown.size(), 0.0);
  for (std::size_t c = 0; c < shown.size(); ++c) {
    const double band = shown[c].areShown() ? shown[c].displaced().band() : 0.0;
    if (band >= said_bands_[c] + kOtherBand) {
      said_bands_[c] = band;
      news.push_back(names[c] + " shows the robots and objects " +
                     tracking::bandReason(shown[c].displaced()));
    }
    if (shown[c].areShown() == (said_shown_[c] != 0)) continue;
    said_shown_[c] = shown[c].areShown();
    const std::string share = names[c] + format(" shows the robots and objects in %.0f %% of their pixels",
                                                100.0 * shown[c].share());
    news.push_back(shown[c].areShown()
                       ? share + ": they are removed from the images again"
                       : share +
                             format(", expected %.0f or more: they are not where the scene has them, or the "
                                    "camera is not (T_WC), and are not removed from the images",
                                    100.0 * tracking::ShownThings::kElsewhere));
  }
  for (std::string& one : news) one = kPrefix + one;
  reported_.insert(reported_.end(), news.begin(), news.end());
  return news;
}

nlohmann::ordered_json LiveThings::json(const tracking::ShownThings& shown) const {
  if (!things_) return {};
  return thingsJson(shown.areShown(), shown.share(), shown.displaced());
}

std::string LiveThings::text(std::span<const tracking::ShownThings> shown) const {
  if (!things_) return {};
  std::string text = "robots and objects of the scene:";
  for (std::size_t c = 0; c < shown.size(); ++c) {
    text += c > 0 ? "; " : " ";
    text += shown[c].areShown() ? "removed" : "not removed";
    if (const std::string found = thingsText(shown[c].share(), shown[c].displaced()); !found.empty())
      text += ", " + found;
  }
  return text + "\n";
}

}  // namespace abstand::cli
