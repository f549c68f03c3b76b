#include "app/moment/moment_file.hpp"

#include <array>
#include <fstream>

#include "app/moment/byte_cursor.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"

namespace abstand::moment {
namespace {

constexpr std::size_t kEndBytes = kFrameHeaderBytes + 16;

void put(std::ostream& out, std::span<const std::byte> bytes) {
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// The last frame, of the fingerprint of all before.
std::array<std::byte, kEndBytes> endFrame(const ContentKey& key) {
  std::array<std::byte, kEndBytes> frame{};
  writeHeader({FrameType::kEnd, 0, 0, 0, kEndBytes}, frame);
  ByteWriter out{std::span<std::byte>(frame).subspan(kFrameHeaderBytes)};
  out.put(key.low);
  out.put(key.high);
  return frame;
}

/// The frame at `at`, which moves behind it.
std::span<const std::byte> frameAt(std::span<const std::byte> bytes, std::size_t& at,
                                   const std::string& name) {
  const auto rest = bytes.subspan(at);
  const auto header = rest.size() < kFrameHeaderBytes ? std::nullopt : readHeader(rest);
  if (!header || header->bytes > rest.size())
    throw ParseError({name}, "found damage at byte " + std::to_string(at) + ", expected a frame of a moment");
  at += header->bytes;
  return rest.first(header->bytes);
}

}  // namespace

void writeMomentFile(const std::filesystem::path& file, const SceneCard& card, const NextFrame& next) {
  OutputFile out(file);
  ContentHash hash;
  const auto add = [&](std::span<const std::byte> frame) {
    hash.add(frame.data(), frame.size());
    put(out.stream(), frame);
  };
  add(writeSceneCard(card));
  for (auto frame = next(); !frame.empty(); frame = next()) add(frame);
  put(out.stream(), endFrame(hash.value()));
  out.commit();
}

bool isMomentFile(const std::filesystem::path& file) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown)) return false;
  std::array<std::byte, kFrameHeaderBytes> begin{};
  std::ifstream in(file, std::ios::binary);
  in.read(reinterpret_cast<char*>(begin.data()), begin.size());
  if (in.gcount() != static_cast<std::streamsize>(begin.size())) return false;
  const auto header = readHeader(begin);
  return header && header->type == FrameType::kScene;
}

void readMomentFile(const std::filesystem::path& file, const std::function<void(const SceneCard&)>& begin,
                    const TakeMoment& take) {
  const std::string text = readFile(file);
  const std::string name = file.string();
  const auto bytes = std::as_bytes(std::span(text));
  if (bytes.size() < kEndBytes) throw ParseError({name}, "found too few bytes, expected recorded moments");
  ContentHash hash;
  hash.add(bytes.data(), bytes.size() - kEndBytes);
  const auto end = endFrame(hash.value());
  if (std::memcmp(bytes.data() + bytes.size() - kEndBytes, end.data(), kEndBytes) != 0)
    throw ParseError({name},
                     "found a fingerprint that differs from the content, expected a whole file of moments");
  const auto frames = bytes.first(bytes.size() - kEndBytes);
  std::size_t at = 0;
  const auto card = readSceneCard(frameAt(frames, at, name));
  if (!card) throw ParseError({name}, "found a damaged first frame, expected the description of a scene");
  begin(*card);
  Moment moment = makeMoment(*card);
  double last = -kInfinity;
  while (at < frames.size()) {
    const std::size_t from = at;
    const auto frame = frameAt(frames, at, name);
    if (!readMoment(frame, moment) || moment.shown.t <= last)
      throw ParseError({name}, "found damage at byte " + std::to_string(from) + ", expected a later moment");
    last = moment.shown.t;
    take(frame, moment);
  }
  if (last == -kInfinity) throw ParseError({name}, "found no moment, expected at least one");
}

}  // namespace abstand::moment
