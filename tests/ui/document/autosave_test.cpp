// Autosaves: written whole, found when their program was killed, gone at a good end.
#include "ui/document/autosave.hpp"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <csignal>

#include "tests/support/paths.hpp"
#include "tests/ui/document/sample_project.hpp"
#include "ui/document/left_overs.hpp"

namespace abstand::ui {
namespace autosave_test {

struct AutosaveTest : ::testing::Test {
  QStringList files() const { return QDir(folder).entryList(QDir::Files); }
  testing::ScratchFolder scratch;
  QString folder{QString::fromStdString(scratch.path().string()) + "/a/b"};
  Document document;
};

TEST_F(AutosaveTest, IsWrittenWithSceneAndRemovedAtExit) {
  Autosave autosave(document, folder);
  autosave.write();
  EXPECT_FALSE(QFile::exists(autosave.file())) << "there is nothing to keep";
  document.open(sampleProject(), "/p.abstand", false);
  autosave.write();
  EXPECT_TRUE(QFile::exists(autosave.file()));
  EXPECT_TRUE(leftOvers(folder).empty()) << "its program lives";
  autosave.finish();
  EXPECT_TRUE(files().isEmpty());
  autosave.write();
  EXPECT_TRUE(files().isEmpty());
}

TEST_F(AutosaveTest, WritesAutomaticallyAfterEdit) {
  document.open(sampleProject(), "", false);
  Autosave autosave(document, folder);
  QSignalSpy looks(&autosave, &Autosave::aboutToWrite);
  ASSERT_TRUE(looks.wait(60000));
  ASSERT_TRUE(QFile::exists(autosave.file()));
}

TEST_F(AutosaveTest, ReportsUnwritableFolderOnce) {
  document.open(sampleProject(), "", false);
  scratch.write("a", "a file where a folder should be");
  Autosave autosave(document, folder);
  QSignalSpy failures(&autosave, &Autosave::failed);
  autosave.write();
  autosave.write();
  EXPECT_EQ(failures.size(), 1);
}

TEST_F(AutosaveTest, FindsWorkOfKilledProcess) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    // Nothing of Qt's event loop runs here: the autosave is told to write until the parent kills it.
    Document killed;
    killed.open(sampleProject(), "/cell/p.abstand", false);
    Autosave autosave(killed, folder);
    for (int i = 0;; ++i) {
      killed.setViewpoint({std::nullopt, 0.5 * i});
      autosave.write();
    }
  }
  const auto written = [&] { return !QDir(folder).entryList({"*.abstand"}, QDir::Files).isEmpty(); };
  while (!written()) {
    ASSERT_EQ(::waitpid(child, nullptr, WNOHANG), 0) << "it ended by itself";
    ::usleep(1000);
  }
  EXPECT_TRUE(leftOvers(folder).empty()) << "it lives";
  ::kill(child, SIGKILL);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  auto found = leftOvers(folder);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].problem, "");
  EXPECT_EQ(found[0].content.project.work, sampleProject().work);
  EXPECT_EQ(found[0].content.saved_as, "/cell/p.abstand");
  EXPECT_TRUE(leftOvers(folder).empty()) << "it was found already";
  found[0].remove();
  found.clear();
  EXPECT_TRUE(leftOvers(folder).empty());
}

TEST_F(AutosaveTest, RemovesFilesOfEndedProcesses) {
  QDir().mkpath(folder);
  scratch.write("a/b/dead.lock", "");
  scratch.write("a/b/dead.abstand.part77.0", "{");
  scratch.write("a/b/kept.lock", "");
  scratch.write("a/b/kept.abstand", projectText(sampleProject(), QString()));
  Autosave autosave(document, folder);
  EXPECT_EQ(leftOvers(folder).size(), 1u);
  EXPECT_EQ(files().size(), 3) << "an autosave, its lock, and that of this program";
}

TEST_F(AutosaveTest, ReportsDamagedAutosave) {
  QDir().mkpath(folder);
  scratch.write("a/b/x.abstand", "{");
  const auto found = leftOvers(folder);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].problem.contains("x.abstand")) << found[0].problem.toStdString();
}

}  // namespace autosave_test
}  // namespace abstand::ui
