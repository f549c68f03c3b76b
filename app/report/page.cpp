#include "app/report/page.hpp"

#include "app/report/svg_plot.hpp"
#include "core/text/escaped_xml.hpp"

namespace abstand::report {
namespace {

// Colours by Okabe and Ito, distinguishable for colour-blind readers; dashes distinguish them in print.
constexpr const char* kStyle = R"(<style>
:root{color-scheme:light dark;--text:#1b1b1b;--back:#fff;--soft:#666;--rule:#d5d5d5;--bad:#b34700;--good:#00694d;
--c0:#0072b2;--c1:#d55e00;--c2:#009e73;--c3:#cc79a7;--c4:#b58900;--c5:#56b4e9;--c6:#7a5195;--c7:#555;--c8:#a00;--skin:#ececec;
--h0:#f6d746;--h1:#fca50a;--h2:#f37819;--h3:#dd513a;--h4:#bc3754;--h5:#932667;--h6:#6a176e;--h7:#420a68}
@media (prefers-color-scheme:dark){:root{--text:#e6e6e6;--back:#16181b;--soft:#a0a0a0;--rule:#3a3d42;--bad:#ff9b5e;
--good:#4fd1a5;--c0:#56b4e9;--c1:#ff9b5e;--c2:#4fd1a5;--c3:#e5a3c8;--c4:#f0e442;--c5:#8ecbf0;--c6:#c1a0e0;--c7:#aaa;
--c8:#ff7a7a;--skin:#2b2e33;
--h0:#5a1a86;--h1:#7d2482;--h2:#a03070;--h3:#c43e54;--h4:#dd513a;--h5:#f37819;--h6:#fca50a;--h7:#f6d746}}
body{font:16px/1.5 system-ui,sans-serif;color:var(--text);background:var(--back);max-width:64rem;margin:2rem auto;
padding:0 1rem}
h2{margin-top:2.5rem;border-bottom:1px solid var(--rule)}
.wide{overflow-x:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums}
td,th{padding:.15rem .7rem .15rem 0;text-align:left;border-bottom:1px solid var(--rule);vertical-align:top}
td{white-space:nowrap}td:last-child{white-space:normal}th{color:var(--soft);font-weight:600}.soft{color:var(--soft)}
.passed{color:var(--good);font-weight:600}.failed{color:var(--bad);font-weight:600}
a{color:inherit}svg{width:100%;max-width:45rem;display:block;margin:1rem 0}
svg text{fill:var(--text);font:12px system-ui,sans-serif}
.axis{stroke:var(--text)}.grid{stroke:var(--rule)}polyline{fill:none;stroke-width:1.6}
.s0{stroke:var(--c0)}.s1{stroke:var(--c1);stroke-dasharray:7 3}.s2{stroke:var(--c2);stroke-dasharray:2 3}
.s3{stroke:var(--c3);stroke-dasharray:9 3 2 3}.s4{stroke:var(--c4)}.s5{stroke:var(--c5);stroke-dasharray:7 3}
.s6{stroke:var(--c6);stroke-dasharray:2 3}.s7{stroke:var(--c7);stroke-dasharray:9 3 2 3}.s8{stroke:var(--c8)}
.moment{max-width:60rem}.moment polygon{stroke-width:.8}figure{margin:1.5rem 0}figcaption{color:var(--soft)}
.moment polygon{fill-opacity:1}.person{fill:#e69f0055;stroke:#b36b00}.robot{fill:#56b4e955;stroke:#2271a8}
.thing{fill:#8883;stroke:#888}
.heat{max-width:60rem}.skin{fill:var(--skin)}.outline{fill:none;stroke:var(--soft);stroke-width:.8}
.unseen{stroke:var(--bad);stroke-width:1.2;stroke-dasharray:4 3}.h0{fill:var(--h0)}.h1{fill:var(--h1)}.h2{fill:var(--h2)}
.h3{fill:var(--h3)}.h4{fill:var(--h4)}.h5{fill:var(--h5)}.h6{fill:var(--h6)}.h7{fill:var(--h7)}
.moment .strong{stroke-width:2.4}.gap{stroke:var(--bad);stroke-width:2.5}
@page{size:A4;margin:15mm}
@media print{body{max-width:none;margin:0;padding:0;font-size:10pt}h2{break-after:avoid;margin-top:1.5rem}
h2,td,th{border-bottom:1px solid #bbb}tr,figure,svg,.whole{break-inside:avoid;page-break-inside:avoid}
thead{display:table-header-group}.wide{overflow:visible}table{font-size:8pt;width:100%}
td,td:last-child{white-space:normal;overflow-wrap:break-word}td,th{padding-right:.4rem}svg{max-width:15cm}.moment{max-width:13cm}
h2+p{break-after:avoid;page-break-after:avoid}.sign td{height:1.1cm}}
</style>)";

}  // namespace

std::string pageBegin(const std::string& title) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>" +
         text::escapedXml(title) + "</title>\n" + kStyle + "</head><body>\n";
}

std::string pageEnd() { return "</body></html>\n"; }

std::string cell(const std::string& text, const char* tag) {
  return std::string("<") + tag + ">" + text::escapedXml(text) + "</" + tag + ">";
}

std::string htmlTable(const std::vector<std::string>& header,
                      const std::vector<std::vector<std::string>>& rows) {
  std::string html = "<div class=\"wide\"><table><thead><tr>";
  for (const std::string& name : header) html += cell(name, "th");
  html += "</tr></thead>\n<tbody>";
  for (const auto& row : rows) {
    html += "<tr>";
    for (const std::string& value : row) html += cell(value);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace abstand::report
