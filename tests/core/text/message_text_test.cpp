// Quotes of untrusted text in messages.
#include <gtest/gtest.h>

#include "core/base/utf8.hpp"
#include "core/text/message_text.hpp"

namespace abstand {
namespace message_text_test {

TEST(MessageText, QuotesKeepUtf8) {
  EXPECT_EQ(text::inQuotes("\xe5\x8f\xb3\xe8\x82\xa9"), "'\xe5\x8f\xb3\xe8\x82\xa9'") << "right shoulder";
  EXPECT_EQ(text::inDoubleQuotes("Ger\xc3\xa4t"), "\"Ger\xc3\xa4t\"");
  EXPECT_EQ(text::inDoubleQuotes(""), "nothing");
}

TEST(MessageText, QuotesReplaceControlsAndInvalidBytes) {
  // Divided literals: no trigraphs.
  EXPECT_EQ(text::inQuotes(std::string_view("a\x1b[31m\0\n\x7f", 9)),
            "'a?[31m??"
            "?'");
  EXPECT_EQ(text::inQuotes("\xff\xe5\x8f"),
            "'??"
            "?'")
      << "an incomplete character at the end";
  EXPECT_EQ(text::inQuotes("a\xe2\x80\xae"
                           "b\xc2\x9b"),
            "'a?b?'")
      << "bidirectional mark, C1 control";
}

TEST(MessageText, QuotesAreCutBetweenCharacters) {
  EXPECT_EQ(text::inQuotes(std::string(40, 'x')), "'" + std::string(40, 'x') + "'");
  EXPECT_EQ(text::inQuotes(std::string(41, 'x')), "'" + std::string(40, 'x') + "...'");
  for (std::size_t lead = 0; lead < 3; ++lead) {
    std::string wide(lead, 'x');
    for (int i = 0; i < 60; ++i) wide += "\xe5\x8f\xb3";
    const std::string quote = text::inQuotes(wide);
    EXPECT_TRUE(isPlainText(quote)) << quote;
    EXPECT_TRUE(quote.ends_with("\xe5\x8f\xb3...'")) << quote;
  }
}

}  // namespace message_text_test
}  // namespace abstand
