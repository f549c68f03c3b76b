// The page as PDF: with converters that stand in for the real ones, and with those that are installed.
#include <chrono>
#include <fstream>

#include "app/report/child_program.hpp"
#include "tests/app/program.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::report {
namespace pdf_test {

namespace fs = std::filesystem;
using testing::Answer;

class Pdf : public testing::Cli {
 protected:
  Pdf() {
    ::setenv("ABSTAND_CACHE", (folder_.path() / "cache").c_str(), 1);
    const std::string scene = testing::writeSlide(
        folder_, {.robot = 0.5, .person = 0.3, .stops_at = kInfinity, .rate = 50.0, .seconds = 2.0});
    fs::create_directory(folder_.path() / "bin");
    EXPECT_EQ(run("tune " + scene + " --out " + file("results")).code, 0);
  }
  ~Pdf() override { ::setenv("PATH", path_.c_str(), 1); }
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  /// A converter that is this script; the only one.
  void standIn(const std::string& name, const std::string& script) {
    const std::string program = write("bin/" + name, "#!/bin/sh\n" + script + "\n");
    fs::permissions(program, fs::perms::owner_all);
  }
  Answer report(bool only_stand_ins) {
    // `sh` finds what it needs by itself.
    ::setenv("PATH", only_stand_ins ? file("bin").c_str() : path_.c_str(), 1);
    const Answer a = run("report " + file("results") + " --pdf " + file("page.pdf"));
    ::setenv("PATH", path_.c_str(), 1);
    return a;
  }
  /// Nothing but the results is left, and the message is one line that says this.
  void expectNothing(const Answer& a, int code, const std::string& said) {
    EXPECT_EQ(a.code, code) << a.err;
    EXPECT_NE(a.err.find(said), std::string::npos) << a.err;
    EXPECT_EQ(std::count(a.err.begin(), a.err.end(), '\n'), 1) << a.err;
    EXPECT_FALSE(fs::exists(file("page.pdf")));
    for (const auto& entry : fs::directory_iterator(folder_.path()))
      EXPECT_EQ(entry.path().filename().string().find(".part"), std::string::npos) << entry.path();
  }

  std::string path_ = ::getenv("PATH");
};

TEST_F(Pdf, NamesMissingPackage) { expectNothing(report(true), 2, "apt-get install weasyprint"); }

TEST_F(Pdf, HoldsConverterOutput) {
  standIn("wkhtmltopdf",
          "for page; do last=$page; [ -f \"$page\" ] && html=$page; done\n"
          "{ printf '%%PDF-'; /bin/cat \"$html\"; } >\"$last\"");
  EXPECT_EQ(report(true).code, 0);
  const std::string pdf = readFile(file("page.pdf"));
  EXPECT_EQ(pdf.compare(0, 5, "%PDF-"), 0);
  EXPECT_NE(pdf.find("Proposed margins"), std::string::npos);
  EXPECT_NE(pdf.find("Signature"), std::string::npos);
  // Drawings are complete without the page's style.
  EXPECT_EQ(pdf.find("<polyline class=\"s0\" points"), std::string::npos);
  EXPECT_NE(pdf.find("fill=\"none\" stroke=\"#0072b2\""), std::string::npos);
}

TEST_F(Pdf, TuneMakesOneWhereTheNameSaysSo) {
  const auto tune = [&](const std::string& name) {
    ::setenv("PATH", file("bin").c_str(), 1);
    const Answer a = run("tune " + file("slide.yaml") + " --report " + file(name));
    ::setenv("PATH", path_.c_str(), 1);
    return a;
  };
  expectNothing(tune("page.pdf"), 2, "--report: found neither weasyprint nor wkhtmltopdf");
  standIn("weasyprint",
          "for page; do last=$page; [ -f \"$page\" ] && html=$page; done\n"
          "{ printf '%%PDF-'; /bin/cat \"$html\"; } >\"$last\"");
  ASSERT_EQ(tune("page.PDF").code, 0);
  EXPECT_EQ(readFile(file("page.PDF")).compare(0, 5, "%PDF-"), 0);
  ASSERT_EQ(tune("page.html").code, 0);
  EXPECT_EQ(readFile(file("page.html")), readFile(file("page.PDF")).substr(5));
}

TEST_F(Pdf, IsNotWrittenIfConverterFails) {
  standIn("weasyprint", "echo some words; echo 'no memory for fonts' >&2; exit 3");
  expectNothing(report(true), 4, "no memory for fonts");
  standIn("weasyprint", "for page; do last=$page; done; echo '<html>' >\"$last\"");
  expectNothing(report(true), 4, "something else than PDF");
  standIn("weasyprint", "exit 0");
  EXPECT_NE(report(true).code, 0);
  EXPECT_FALSE(fs::exists(file("page.pdf")));
}

TEST_F(Pdf, UsesInstalledConverter) {
  if (!findProgram("weasyprint") && !findProgram("wkhtmltopdf")) GTEST_SKIP() << "no converter is installed";
  const Answer a = report(false);
  ASSERT_EQ(a.code, 0) << a.err;
  EXPECT_EQ(readFile(file("page.pdf")).compare(0, 5, "%PDF-"), 0);
  if (!findProgram("pdftotext")) return;
  ASSERT_EQ(std::system(("pdftotext '" + file("page.pdf") + "' '" + file("page.txt") + "'").c_str()), 0);
  const std::string text = readFile(file("page.txt"));
  for (const char* said : {"Proposed margins", "Cost of margins", "Nearest approaches", "Signature"})
    EXPECT_NE(text.find(said), std::string::npos) << said;
}

TEST(ChildProgram, PassesArgumentsVerbatim) {
  const auto echo = findProgram("echo");
  ASSERT_TRUE(echo);
  const ProgramEnd end = runProgram(*echo, {"first\nsecond $HOME; `exit 1` *"}, 10.0);
  EXPECT_EQ(end.code, 0);
  EXPECT_EQ(end.last_words, "second $HOME; `exit 1` *");
  EXPECT_EQ(runProgram("/no/such/program", {}, 10.0).code, 127);
  EXPECT_FALSE(findProgram("no-such-program-anywhere"));
}

TEST(ChildProgram, TimeoutKillsDescendants) {
  const testing::ScratchFolder folder;
  const auto begin = std::chrono::steady_clock::now();
  const std::string alive = (folder.path() / "alive").string();
  // Once it holds its output open, and once it does not.
  for (const std::string redirect : {"", " >/dev/null 2>&1"}) {
    const ProgramEnd end = runProgram(
        "/bin/sh", {"-c", "exec" + redirect + "; (sleep 2; echo >'" + alive + "') & sleep 60"}, 0.3);
    EXPECT_TRUE(end.timed_out);
    EXPECT_EQ(end.code, -1);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30)) << "not until they end";
  ::sleep(3);
  EXPECT_FALSE(fs::exists(alive));
}

}  // namespace pdf_test
}  // namespace abstand::report
