// Fingerprints of input files.
#include "app/session/input_content.hpp"

#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "tests/support/paths.hpp"

namespace abstand::testing {
namespace input_content_test {

std::string hashOf(const std::filesystem::path& file) {
  ContentHash hash;
  session::addContent(hash, file);
  return hash.value().hex();
}

TEST(InputContent, HashCoversSizeAndAllBytes) {
  const ScratchFolder folder;
  constexpr std::size_t kBlock = std::size_t{1} << 20;
  for (const std::size_t bytes : {std::size_t{1}, kBlock - 1, kBlock, kBlock + 1, 3 * kBlock + 17}) {
    std::string text(bytes, '\0');
    for (std::size_t i = 0; i < bytes; ++i) text[i] = static_cast<char>(i * 131 % 251);
    const auto file = folder.write("input", text);
    ContentHash expected;
    expected.add(text.size());
    expected.add(text.data(), text.size());
    EXPECT_EQ(hashOf(file), expected.value().hex()) << bytes;
    text.back() ^= 1;
    EXPECT_NE(hashOf(folder.write("other", text)), expected.value().hex()) << "the last byte counts";
  }
}

TEST(InputContent, FolderHashCoversFilesByName) {
  const ScratchFolder a, b;
  for (const ScratchFolder* folder : {&a, &b}) folder->write("one", "1"), folder->write("two", "2");
  EXPECT_EQ(hashOf(a.path()), hashOf(b.path()));
  b.write("three", "3");
  EXPECT_NE(hashOf(a.path()), hashOf(b.path()));
}

TEST(InputContent, RejectsMissingAndEmptyFiles) {
  const ScratchFolder folder;
  EXPECT_THROW(hashOf(folder.path() / "gone"), ParseError);
  EXPECT_THROW(hashOf(folder.write("empty", "")), ParseError);
  EXPECT_THROW(hashOf("/dev/null"), ParseError);
}

}  // namespace input_content_test
}  // namespace abstand::testing
