#include "app/moment/scene_card.hpp"

#include "app/moment/byte_cursor.hpp"
#include "app/moment/frame.hpp"
#include "core/base/text_file.hpp"

namespace abstand::moment {
namespace {

constexpr std::size_t kMaxName = 4096;  // bytes
constexpr std::uint32_t kMaxDof = 1000;

class CardWriter {
 public:
  template <class T>
  void number(T value) {
    const auto* p = reinterpret_cast<const std::byte*>(&value);
    bytes.insert(bytes.end(), p, p + sizeof value);
  }
  void text(const std::string& text) {
    number(static_cast<std::uint32_t>(text.size()));
    const auto* p = reinterpret_cast<const std::byte*>(text.data());
    bytes.insert(bytes.end(), p, p + text.size());
  }
  std::vector<std::byte> bytes = std::vector<std::byte>(kFrameHeaderBytes);
};

std::string readName(ByteReader& in) {
  const auto count = in.get<std::uint32_t>();
  if (count > kMaxName) in.fail();
  return in.getText(count);
}

/// Number of entries of at least `bytes` each; more than the rest can hold is damage.
std::uint32_t readCount(ByteReader& in, std::size_t bytes) {
  const auto count = in.get<std::uint32_t>();
  if (count > in.left() / bytes) in.fail();
  return in.good() ? count : 0;
}

void readNames(ByteReader& in, std::vector<std::string>& names) {
  names.resize(readCount(in, sizeof(std::uint32_t)));
  for (std::string& name : names) name = readName(in);
}

}  // namespace

std::size_t SceneCard::dof() const {
  std::size_t sum = 0;
  for (const Robot& robot : robots) sum += robot.dof;
  return sum;
}

ContentKey sceneKey(const std::string& file) {
  constexpr std::uintmax_t kMaxBytes = std::uintmax_t{64} << 20;
  const std::string text = readFile(file, kMaxBytes);
  ContentHash hash;
  hash.add(text.data(), text.size());
  return hash.value();
}

std::vector<std::byte> writeSceneCard(const SceneCard& card) {
  CardWriter out;
  out.number(card.server);
  out.number(card.scene.low);
  out.number(card.scene.high);
  out.text(card.file);
  for (const auto* names : {&card.objects, &card.people, &card.groups}) {
    out.number(static_cast<std::uint32_t>(names->size()));
    for (const std::string& name : *names) out.text(name);
  }
  out.number(static_cast<std::uint32_t>(card.robots.size()));
  for (const SceneCard::Robot& robot : card.robots) {
    out.text(robot.name);
    out.number(robot.dof);
  }
  out.number(static_cast<std::uint32_t>(card.pairs.size()));
  for (const auto& [a, b] : card.pairs) {
    out.number(a);
    out.number(b);
  }
  writeHeader({FrameType::kScene, 0, 0, 0, static_cast<std::uint32_t>(out.bytes.size())}, out.bytes);
  return out.bytes;
}

std::optional<SceneCard> readSceneCard(std::span<const std::byte> frame) {
  if (frame.size() < kFrameHeaderBytes) return {};
  const auto header = readHeader(frame);
  if (!header || header->type != FrameType::kScene || header->bytes != frame.size()) return {};
  ByteReader in(frame.subspan(kFrameHeaderBytes));
  SceneCard card;
  card.server = in.get<std::uint64_t>();
  card.scene.low = in.get<std::uint64_t>();
  card.scene.high = in.get<std::uint64_t>();
  card.file = readName(in);
  readNames(in, card.objects);
  readNames(in, card.people);
  readNames(in, card.groups);
  card.robots.resize(readCount(in, 2 * sizeof(std::uint32_t)));
  for (SceneCard::Robot& robot : card.robots) {
    robot.name = readName(in);
    robot.dof = in.get<std::uint32_t>();
    if (robot.dof > kMaxDof) in.fail();
  }
  card.pairs.resize(readCount(in, 2 * sizeof(std::uint32_t)));
  for (auto& [a, b] : card.pairs) {
    a = in.get<std::uint32_t>();
    b = in.get<std::uint32_t>();
    if (a >= card.objects.size() || b >= card.objects.size() || a == b) in.fail();
  }
  if (!in.good() || in.left() > 0) return {};
  return card;
}

}  // namespace abstand::moment
