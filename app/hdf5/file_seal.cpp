#include "app/hdf5/file_seal.hpp"

#include <fstream>
#include <vector>

#include "core/base/content_hash.hpp"
#include "core/base/write_error.hpp"

namespace abstand::hdf5 {
namespace {

constexpr char kMagic[] = "abstand tables 1\nxxh3-128 ";
constexpr std::size_t kBlock = std::size_t{1} << 20;

/// Checksum of all bytes from the current position on.
std::string checksum(std::istream& in) {
  ContentHash hash;
  std::vector<char> block(kBlock);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0)
    hash.add(block.data(), static_cast<std::size_t>(in.gcount()));
  return hash.value().hex();
}

}  // namespace

void seal(const std::filesystem::path& file) {
  std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
  stream.seekg(kSealBytes);
  std::string text = kMagic + checksum(stream) + "\n";
  text.resize(kSealBytes, '\0');
  stream.clear();
  stream.seekp(0);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.flush();
  if (!stream) throw WriteError(file.string(), std::string("the checksum cannot be written"));
}

std::string brokenSeal(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string head(kSealBytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  const std::string magic = kMagic;
  if (!in || head.compare(0, magic.size(), magic) != 0)
    return "found no table file of abstand, expected one that it wrote";
  const std::string hex = checksum(in);
  if (head.compare(magic.size(), hex.size(), hex) != 0)
    return "found content that does not match its checksum, expected an undamaged file";
  return {};
}

}  // namespace abstand::hdf5
