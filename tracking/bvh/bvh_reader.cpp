#include "tracking/bvh/bvh_reader.hpp"

#include <charconv>
#include <cmath>

#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

bool isBlankInBvh(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
bool isSpaceInBvh(char c) { return isBlankInBvh(c) || c == '\n'; }

}  // namespace

BvhReader::BvhReader(std::string text, std::string file) : text_(std::move(text)), file_(std::move(file)) {
  TextCursor in(text_, file_);
  hierarchy_ = parseBvhHierarchy(in, warnings_);
  head_ = parseBvhMotionHead(in, warnings_);
  at_ = in.offset();
  line_ = in.line();
  line_start_ = in.lineStart();
  values_.resize(hierarchy_.channel_count);
  chooseLayout();
}

SourcePos BvhReader::here() const { return {file_, line_, static_cast<int>(at_ - line_start_) + 1}; }

void BvhReader::nextLine() {
  ++at_;
  ++line_;
  line_start_ = at_;
}

bool BvhReader::lineHasMore() {
  while (at_ < text_.size() && isBlankInBvh(text_[at_])) ++at_;
  return at_ < text_.size() && text_[at_] != '\n';
}

std::size_t BvhReader::wordsIn(std::size_t from, std::size_t to) const {
  std::size_t words = 0;
  for (std::size_t i = from; i < to; ++i)
    if (!isSpaceInBvh(text_[i]) && (i == from || isSpaceInBvh(text_[i - 1]))) ++words;
  return words;
}

/// Inspects the first two non-empty lines.
void BvhReader::chooseLayout() {
  std::size_t from = at_;
  for (int lines = 0; lines < 2 && from < text_.size();) {
    const std::size_t to = std::min(text_.find('\n', from), text_.size());
    const std::size_t words = wordsIn(from, to);
    if (words == values_.size()) frame_a_line_ = true;
    if (words > 0) ++lines;
    from = to + 1;
  }
}

/// False if the text ends, possibly within the number.
bool BvhReader::readNumber(double& value) {
  const char* const end = text_.data() + text_.size();
  const char* first = text_.data() + at_;
  if (*first == '+' && first + 1 < end && first[1] != '-' && first[1] != '+') ++first;
  const auto r = std::from_chars(first, end, value);
  const bool whole = r.ptr == end || isSpaceInBvh(*r.ptr);
  if (r.ec == std::errc{} && whole && std::abs(value) <= kLargestBvhValue) {
    at_ = static_cast<std::size_t>(r.ptr - text_.data());
    return true;
  }
  std::size_t stop = at_;
  while (stop < text_.size() && !isSpaceInBvh(text_[stop])) ++stop;
  const std::string_view word(text_.data() + at_, stop - at_);
  if (stop == text_.size() && frames_ > 0 &&
      word.find_first_not_of("+-.0123456789eE") == std::string_view::npos) {
    cut_ = true;
    return false;
  }
  if (r.ec == std::errc{} && whole && std::isfinite(value))
    throw ParseError(here(), "found " + text::inQuotes(word) + ", expected a number below 1e9");
  throw ParseError(here(), "found " + text::inQuotes(word) + ", expected a number",
                   word.find(',') != std::string_view::npos ? "BVH uses a decimal point, not a comma" : "");
}

/// End of the data, with `partial` values of an incomplete frame. Always false.
bool BvhReader::finish(std::size_t partial) {
  done_ = true;
  const auto claimed = std::to_string(head_.frames);
  if (frames_ == 0)
    throw ParseError({file_, data_line_},
                     "found " + std::to_string(partial) +
                         " numbers and then the end, expected at least one frame of " +
                         std::to_string(values_.size()) +
                         (head_.frames > 0 ? " (" + claimed + " frames are claimed)" : ""));
  if (partial > 0 || cut_)
    warnings_.push_back({data_line_, "the last frame is truncated after " + std::to_string(partial) + " of " +
                                         std::to_string(values_.size()) + " numbers and ignored"});
  const auto claim = head_.frames > 0 ? static_cast<std::size_t>(head_.frames) : 0;
  if (static_cast<unsigned long long>(head_.frames) != frames_)
    warnings_.push_back(
        {head_.frames_line,
         "claims " + claimed + " frames, found " + std::to_string(frames_) + " complete ones: " +
             (beyondClaim() ? "frames beyond the stated number are ignored" : "all of them are kept"),
         claim > frames_ ? claim - frames_ : 0});
  return false;
}

std::optional<std::span<const double>> BvhReader::next() {
  if (done_ || !readFrame()) return std::nullopt;
  if (!beyondClaim()) return std::span<const double>(values_);
  // The header's count applies, as in other programs; further frames are still read, to be counted and
  // checked.
  while (readFrame()) {
  }
  return std::nullopt;
}

bool BvhReader::beyondClaim() const {
  return head_.frames > 0 && frames_ > static_cast<unsigned long long>(head_.frames);
}

bool BvhReader::readFrame() {
  std::size_t n = 0;
  while (n < values_.size()) {
    if (lineHasMore()) {
      data_line_ = line_;
      if (!readNumber(values_[n])) break;
      ++n;
    } else if (at_ >= text_.size()) {
      break;
    } else if (frame_a_line_ && n > 0) {
      // A short line: harmless at the end, otherwise the frame is invalid.
      const SourcePos end_of_line = here();
      while (at_ < text_.size() && isSpaceInBvh(text_[at_])) text_[at_] == '\n' ? nextLine() : void(++at_);
      if (at_ < text_.size())
        throw ParseError(end_of_line, "found " + std::to_string(n) + " numbers on the line, expected " +
                                          std::to_string(values_.size()));
    } else {
      nextLine();
    }
  }

  const bool whole = n == values_.size();
  if (whole && frame_a_line_ && lineHasMore())
    throw ParseError(here(), "found more numbers on the line, expected " + std::to_string(values_.size()));
  // A text that ends right after a digit, before the stated number of frames, may have a truncated number.
  if (whole && frames_ > 0 && at_ >= text_.size() && !isSpaceInBvh(text_.back()) &&
      static_cast<unsigned long long>(head_.frames) > frames_ + 1)
    cut_ = true;
  if (!whole || cut_) return finish(n);
  ++frames_;
  return true;
}

}  // namespace abstand::tracking
