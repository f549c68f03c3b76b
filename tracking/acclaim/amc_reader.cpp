#include "tracking/acclaim/amc_reader.hpp"

#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/text/message_text.hpp"
#include "tracking/acclaim/words.hpp"

namespace abstand::tracking {

bool looksLikeAmc(std::string_view text) {
  if (text.starts_with("#!OML:ASF")) return true;
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    const auto words = wordsOf(line);
    if (words.empty()) continue;
    if (words[0].front() != ':') return false;
    const std::string key = text::lowerCase(words[0]);
    if (key == ":fully-specified" || key == ":degrees" || key == ":radians") return true;
  }
  return false;
}

AmcReader::AmcReader(std::string_view text, std::string file, const AsfSkeleton& skeleton)
    : file_(std::move(file)), lines_(text), skeleton_(skeleton), in_degrees_(skeleton.in_degrees) {
  for (std::size_t i = 0; i < skeleton.bones.size(); ++i) {
    index_.emplace(skeleton.bones[i].name, i);
    first_.push_back(channels_);
    channels_ += skeleton.bones[i].channels.size();
    moving_ += skeleton.bones[i].channels.empty() ? 0 : 1;
  }
  frame_of_bone_.assign(skeleton.bones.size(), 0);
  while (nextWords() && words_[0].front() == ':') {
    const std::string key = text::lowerCase(words_[0]);
    if (key == ":degrees") in_degrees_ = true;
    if (key == ":radians") in_degrees_ = false;
    has_words_ = false;
  }
}

bool AmcReader::nextWords() {
  for (std::string_view line; !has_words_ && lines_.next(line);) {
    words_ = wordsOf(line);
    has_words_ = !words_.empty();
  }
  return has_words_;
}

bool AmcReader::readBone(std::vector<double>& values) {
  const SourcePos pos{file_, lines_.number()};
  const auto it = index_.find(std::string(words_[0]));
  if (it == index_.end())
    throw ParseError(pos, "found the bone " + text::inQuotes(words_[0]) + ", expected one of the skeleton");
  const AsfBone& bone = skeleton_.bones[it->second];
  if (frame_of_bone_[it->second] == frames_ + 1)
    throw ParseError(
        pos, "found the bone " + text::inQuotes(words_[0]) + " a second time in a frame, expected it once");
  if (words_.size() != bone.channels.size() + 1)
    throw ParseError(pos, "found " + std::to_string(words_.size() - 1) + " numbers for " +
                              text::inQuotes(words_[0]) + ", expected " +
                              std::to_string(bone.channels.size()) + " as stated by its dof");
  for (std::size_t k = 0; k < bone.channels.size(); ++k) {
    const auto v = parseDouble(words_[k + 1]);
    if (!v || std::abs(*v) > kLargestCoordinate)
      throw ParseError(pos, "found " + text::inQuotes(words_[k + 1]) + ", expected a number below 1e9");
    const bool is_angle = bone.channels[k] >= AsfChannel::kRx;
    values[first_[it->second] + k] = is_angle && in_degrees_ ? *v * (kPi / 180.0) : *v;
  }
  frame_of_bone_[it->second] = frames_ + 1;
  return !bone.channels.empty();
}

bool AmcReader::next(std::vector<double>& values) {
  if (at_end_ || !nextWords()) {
    at_end_ = true;
    if (frames_ == 0) throw ParseError({file_, lines_.number() + 1}, "found no frame, expected at least one");
    return false;
  }
  const int start = lines_.number();
  if (words_.size() != 1 || !parseInt(words_[0]))
    throw ParseError({file_, start},
                     "found " + text::inQuotes(words_[0]) + ", expected the number of a frame");
  has_words_ = false;
  values.assign(channels_, 0.0);
  std::size_t bones = 0;
  while (nextWords() && !(words_.size() == 1 && parseInt(words_[0]))) {
    try {
      bones += readBone(values) ? 1 : 0;
    } catch (const ParseError&) {
      // An incomplete last line invalidates only its own frame.
      has_words_ = false;
      if (frames_ == 0 || nextWords()) throw;
      break;
    }
    has_words_ = false;
  }
  if (bones == moving_) {
    ++frames_;
    return true;
  }
  const std::string what = std::to_string(bones) + " of " + std::to_string(moving_) + " bones";
  if (has_words_ || frames_ == 0)
    throw ParseError({file_, start}, "found a frame with " + what + ", expected all that move");
  warnings_.push_back({start, "the last frame is truncated after " + what + " and ignored", 1});
  at_end_ = true;
  return false;
}

}  // namespace abstand::tracking
