// Text in XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace abstand::text {

/// `text` with <, >, & and " as entities, and a space for every control character but line breaks.
std::string escapedXml(std::string_view text);

}  // namespace abstand::text
