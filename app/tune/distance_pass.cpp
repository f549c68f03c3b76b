#include "app/tune/distance_pass.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/tune/latency.hpp"
#include "core/base/error.hpp"
#include "core/safety/clearance_verdict.hpp"
#include "humanmodel/body_part.hpp"

namespace abstand::tune {
namespace {

void validate(const PassOptions& options) {
  const auto need = [](bool good, const char* what) {
    if (!good) throw UsageError(std::string("found ") + what);
  };
  need(std::isfinite(options.braking.reaction_time) && options.braking.reaction_time >= 0.0 &&
           options.braking.reaction_time <= 10.0,
       "a reaction time outside of 0 to 10 s");
  need(std::isfinite(options.braking.deceleration) && options.braking.deceleration > 0.0,
       "a deceleration that is not positive, expected rad/s^2 or m/s^2");
  need(std::isfinite(options.calibration_error) && options.calibration_error >= 0.0,
       "a calibration error that is negative, expected metres");
  need(std::isfinite(options.latency) && options.latency >= 0.0 && options.latency <= 10.0,
       "a latency outside of 0 to 10 s");
  options.separation.validate();
  need(std::isfinite(options.limit) && options.limit >= 0.0, "a limit that is negative, expected metres");
}

std::vector<PairId> idsOf(const std::vector<WatchedPair>& pairs) {
  std::vector<PairId> ids;
  for (const WatchedPair& pair : pairs) ids.push_back(pair.id);
  return ids;
}

/// Visits the lists with one entry per frame.
template <class Visit>
void eachList(PartClearance& part, const Visit& visit) {
  for (auto* list :
       {&part.track.t, &part.track.clearance, &part.track.between, &part.track.braking, &part.distance,
        &part.bound, &part.uncertainty, &part.age_uncertainty, &part.latency_uncertainty, &part.robot_speed,
        &part.person_speed, &part.separation.missing, &part.separation.speed_scale, &part.contact_scale})
    visit(*list);
  for (auto* list : {&part.link, &part.tool}) visit(*list);
  visit(part.contact);
}

double wholeSpeed(double speed) { return std::ceil(speed / kSpeedStep) * kSpeedStep; }

}  // namespace

void reserveFrames(std::size_t frames, PartClearance& part) {
  eachList(part, [frames](auto& list) { list.reserve(frames); });
}

void dropFrames(PartClearance& part) {
  eachList(part, [](auto& list) { std::remove_reference_t<decltype(list)>().swap(list); });
}

DistancePass::DistancePass(const session::Session& session, const PassOptions& options)
    : session_(session),
      options_(options),
      window_(session, watchedPairs(session), options.braking,
              {options.calibration_error, latencyUncertainty(session, options.latency)}),
      swept_(session.scene(), idsOf(window_.pairs())),
      braking_(session, window_, options.limit),
      judge_(session, options.contact, options.clamped) {
  validate(options);
  if (window_.pairs().empty())
    throw UsageError(session.description().file.string() +
                     ": found no pair of a person and a robot, expected at least one");
  std::set<humanmodel::BodyPart> there;
  for (const WatchedPair& pair : window_.pairs()) there.insert(pair.body_part);
  for (const humanmodel::BodyPart part : there)
    result_.parts.emplace_back().part = std::string(humanmodel::partName(part));
  for (PartClearance& part : result_.parts) {
    part.contact_excluded = judge_.excluded(part.part);
    if (options.keep_frames) reserveFrames(options.frames, part);
  }
  std::map<std::size_t, std::uint16_t> link_index, tool_index;
  const auto named = [&](std::size_t object, std::map<std::size_t, std::uint16_t>& index,
                         std::vector<std::string>& names) {
    const auto [at, fresh] = index.try_emplace(object, static_cast<std::uint16_t>(names.size()));
    if (fresh) names.push_back(session.scene().objects()[object].spec.name);
    return at->second;
  };
  for (const WatchedPair& pair : window_.pairs()) {
    const auto part = static_cast<std::uint16_t>(std::distance(there.begin(), there.find(pair.body_part)));
    result_.pairs.push_back({part, named(pair.link, link_index, result_.links),
                             pair.tool ? named(pair.part, tool_index, result_.tools) : kNoTool});
  }
  const margin::MarginOptions needs{options.limit, 0.0};
  link_watches_.assign(result_.links.size(), NeedWatch(needs));
  pair_watches_.assign(window_.pairs().size(), NeedWatch(needs));
  between_moving_.resize(window_.pairs().size());
  std::vector<ExposureTally::Names> names;
  for (const PassResult::PairOfNames& pair : result_.pairs) names.push_back({pair.part, pair.link});
  exposure_.emplace(session, window_.pairs(), names, options.near);
  nearest_.resize(result_.parts.size());
  closest_.assign(result_.parts.size(), kInfinity);
  motions_.resize(window_.pairs().size());
  hardest_.resize(result_.parts.size());
  least_.assign(result_.parts.size(), kInfinity);
  const std::size_t all = session.scene().pairs().size();
  limits_.assign(all, -kInfinity);
  uncertainty_.assign(all, 0.0);
}

void DistancePass::frame(double t, const std::vector<query::PairResult>& results) {
  for (std::size_t p = 0; p < window_.pairs().size(); ++p) {
    const PairId id = window_.pairs()[p].id;
    const query::PairResult& r = results[id.index()];
    const double now = window_.uncertaintyOf(window_.pairs()[p]);
    double& closest = closest_[result_.pairs[p].part];
    limits_[id.index()] = std::max(now, uncertainty_[id.index()]);
    uncertainty_[id.index()] = now;
    const double clearance = safety::certifiedClearance({r.distance, r.bound, now});
    if (std::isfinite(clearance)) closest = std::min(closest, clearance);
  }
  // Between frames the search must distinguish contact from none, and find distances below all earlier ones;
  // other pairs are not refined.
  for (std::size_t p = 0; p < window_.pairs().size(); ++p) {
    const double closest = closest_[result_.pairs[p].part];
    limits_[window_.pairs()[p].id.index()] +=
        std::max(options_.limit, std::isfinite(closest) ? closest : options_.limit);
  }
  const std::span<const run::SweptCheck::Between> between = swept_.frame(t, results, limits_);
  between_.clear();
  for (const auto& b : between) between_.push_back(b.lower);
  window_.add(t, results, between_, swept_.motions());
  settle();
}

PassResult DistancePass::finish() {
  window_.finish();
  settle();
  result_.swept_queries = swept_.queries();
  result_.braking_queries = braking_.queries();
  for (const NeedWatch& watch : link_watches_) result_.link_needs.push_back(watch.value());
  for (const NeedWatch& watch : pair_watches_) result_.pair_needs.push_back(watch.value());
  result_.exposure = exposure_->finish();
  return std::move(result_);
}

void DistancePass::settle() {
  while (!window_.empty() && braking_.ofFirst(braking_of_first_)) {
    const auto& frames = window_.frames();
    take(frames.front(), frames.size() > 1 ? &frames[1] : nullptr);
    if (options_.on_frame)
      options_.on_frame({frames.front(), motions_, between_moving_, braking_of_first_}, result_);
    window_.drop();
  }
}

void DistancePass::addFrame(double t) {
  for (PartClearance& part : result_.parts) {
    if (!part.track.t.empty() && part.separation.missing.back() > 0.0)
      part.separation.broken += t - part.track.t.back();
    if (!part.track.t.empty() && part.contact.back().share > 1.0)
      part.contacts.exceeded += t - part.track.t.back();
    if (!options_.keep_frames) eachList(part, [](auto& list) { list.clear(); });
    part.track.t.push_back(t);
    part.track.clearance.push_back(kInfinity);
    part.track.between.push_back(kInfinity);
    part.track.braking.push_back(kInfinity);
    part.distance.push_back(kInfinity);
    part.bound.push_back(0.0);
    part.uncertainty.push_back(0.0);
    part.age_uncertainty.push_back(0.0);
    part.latency_uncertainty.push_back(0.0);
    part.link.push_back(0);
    part.tool.push_back(kNoTool);
    part.robot_speed.push_back(0.0);
    part.person_speed.push_back(0.0);
    part.separation.missing.push_back(-kInfinity);
    part.separation.speed_scale.push_back(1.0);
    part.contact_scale.push_back(1.0);
    part.contact.emplace_back();
  }
}

void DistancePass::take(const WindowFrame& frame, const WindowFrame* next) {
  addFrame(frame.t);
  const std::size_t i = result_.parts.front().track.frames() - 1;
  for (std::size_t p = 0; p < window_.pairs().size(); ++p) {
    PartClearance& part = result_.parts[result_.pairs[p].part];
    if (frame.clearance[p] < part.track.clearance[i] || part.track.clearance[i] == kInfinity) {
      part.track.clearance[i] = frame.clearance[p];
      part.uncertainty[i] = frame.uncertainty[p];
      part.age_uncertainty[i] = frame.age_uncertainty[p];
      part.latency_uncertainty[i] = window_.latencyOf(window_.pairs()[p]);
      part.link[i] = result_.pairs[p].link;
      part.tool[i] = result_.pairs[p].tool;
      part.distance[i] = frame.distance[p];
      nearest_[result_.pairs[p].part] = p;
      part.bound[i] = frame.bound[p];
    }
    part.track.braking[i] = std::min(part.track.braking[i], braking_of_first_[p]);
    between_moving_[p] = kInfinity;
    // Contacts with a robot at rest are not relevant for margins.
    if (!next || frame.speed[window_.pairs()[p].link] == 0.0) continue;
    const double uncertainty = std::max(frame.uncertainty[p], next->uncertainty[p]);
    between_moving_[p] = frame.between[p] - uncertainty;
    part.track.between[i] = std::min(part.track.between[i], between_moving_[p]);
  }
  watchNeeds(frame);
  watchSpeeds(frame);
  exposure_->frame(frame, next ? next->t - frame.t : 0.0, motions_, nearest_);
  lookAhead(next);
  for (std::size_t part = 0; part < result_.parts.size(); ++part) watchApproach(part, frame);
}

void DistancePass::watchNeeds(const WindowFrame& frame) {
  nearest_to_link_.assign(result_.links.size(), {});
  link_between_.assign(result_.links.size(), kInfinity);
  link_braking_.assign(result_.links.size(), kInfinity);
  for (std::size_t p = 0; p < window_.pairs().size(); ++p) {
    const NearestPair nearest{frame.clearance[p], frame.bound[p], frame.uncertainty[p]};
    pair_watches_[p].add(frame.t, nearest, between_moving_[p], braking_of_first_[p]);
    const std::size_t link = result_.pairs[p].link;
    if (nearest.clearance < nearest_to_link_[link].clearance) nearest_to_link_[link] = nearest;
    link_between_[link] = std::min(link_between_[link], between_moving_[p]);
    link_braking_[link] = std::min(link_braking_[link], braking_of_first_[p]);
  }
  for (std::size_t link = 0; link < link_watches_.size(); ++link)
    link_watches_[link].add(frame.t, nearest_to_link_[link], link_between_[link], link_braking_[link]);
}

void DistancePass::watchSpeeds(const WindowFrame& frame) {
  for (std::size_t p = 0; p < window_.pairs().size(); ++p) {
    const WatchedPair& pair = window_.pairs()[p];
    PartClearance& part = result_.parts[result_.pairs[p].part];
    ClosingMotion& motion = motions_[p] = ApproachJudge::motion(frame, pair, p);
    // For an unseen part the direction is unknown: every motion of the link may be towards it.
    const bool unseen = frame.clearance[p] == -kInfinity;
    const double robot_speed = unseen && !frame.speed.empty() ? frame.speed[pair.link] : motion.robot_speed;
    if (robot_speed > 0.0)
      takeSeparation(
          part.separation,
          {frame.t, result_.pairs[p].link, frame.clearance[p], robot_speed, motion.person_speed, {}, 0.0},
          options_.separation);
    const bool near = options_.contact && frame.clearance[p] < options_.near;
    if (near && unseen) part.contact.back() = {result_.pairs[p].link, kNoRegion, 0.0, 0.0, 0.0, kInfinity};
    const bool closes = near && !unseen && motion.closing() > 0.0;
    if (closes) judge_.complete(frame, pair, motion);
    double& scale = part.contact_scale.back();
    const bool limits = !part.contact_excluded && near && robot_speed > 0.0 && scale > 0.0;
    if (limits) scale = unseen ? 0.0 : judge_.contactShare(pair, part.part, motion, scale);
    if (closes) watchContact(p, frame);
  }
  for (PartClearance& part : result_.parts) {
    double &missing = part.separation.missing.back(), &scale = part.separation.speed_scale.back();
    missing = wholeSpeed(missing);
    scale = std::floor(scale / kSpeedStep) * kSpeedStep;
    double& by_contact = part.contact_scale.back();
    by_contact = part.contact_excluded ? scale : std::floor(by_contact / kSpeedStep) * kSpeedStep;
    const FrameContact& contact = part.contact.back() = roundedUp(part.contact.back());
    auto& worst = part.contacts.worst;
    if (contact.share > 0.0 && (!worst || isHarder(contact, worst->contact))) worst = {frame.t, contact};
  }
}

void DistancePass::watchContact(std::size_t p, const WindowFrame& frame) {
  PartClearance& part = result_.parts[result_.pairs[p].part];
  FrameContact& hardest = part.contact.back();
  const ContactShare share = judge_.contact(motions_[p], frame.t, window_.pairs()[p], part.part);
  if (share.region.empty()) return;
  const double largest = share.excluded ? kInfinity : std::max(share.share, share.pressure_share);
  if (hardest.share > 0.0 && !isHarder({0, 0, share.force, 0.0, 0.0, largest}, hardest)) return;
  auto region = std::find(result_.regions.begin(), result_.regions.end(), share.region);
  if (region == result_.regions.end()) region = result_.regions.insert(region, share.region);
  hardest = {result_.pairs[p].link, static_cast<std::uint16_t>(region - result_.regions.begin()),
             share.force,           share.energy,
             share.pressure,        largest};
}

void DistancePass::lookAhead(const WindowFrame* next) {
  ahead_.assign(result_.parts.size(), kInfinity);
  if (!next) return;
  for (std::size_t p = 0; p < window_.pairs().size(); ++p) {
    double& least = ahead_[result_.pairs[p].part];
    least = std::min(least, next->clearance[p]);
  }
}

/// Of equal consecutive clearances the first one is the minimum.
void DistancePass::watchApproach(std::size_t index, const WindowFrame& frame) {
  PartClearance& part = result_.parts[index];
  const std::size_t p = nearest_[index];
  const WatchedPair& pair = window_.pairs()[p];
  const double clearance = part.track.clearance.back();
  const bool near = clearance < options_.near && std::isfinite(clearance);
  const bool told = near && clearance < least_[index] && clearance <= ahead_[index];
  least_[index] = clearance;
  ClosingMotion motion = motions_[p];
  part.robot_speed.back() = wholeSpeed(motion.robot_speed);
  part.person_speed.back() = wholeSpeed(motion.person_speed);
  std::optional<Hardest>& hardest = hardest_[index];
  if (!near) hardest.reset();
  const bool is_hardest = near && (!hardest || motion.closing() > hardest->motion.closing());
  if (is_hardest || told) judge_.complete(frame, pair, motion);
  if (is_hardest) hardest = {frame.t, pair, motion};
  if (!told) return;
  result_.approaches.push_back({static_cast<std::uint16_t>(index), part.link.back(), part.tool.back(),
                                frame.t, part.distance.back(), clearance, motion,
                                judge_.contact(hardest->motion, hardest->t, hardest->pair, part.part)});
  hardest.reset();
}

}  // namespace abstand::tune
