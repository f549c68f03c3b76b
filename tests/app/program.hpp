// Runs the program `abstand` as a user does.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <nlohmann/json.hpp>

#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"

namespace abstand::testing {

using nlohmann::json;

struct Answer {
  int code;
  std::string out, err;
};

class Cli : public ::testing::Test {
 protected:
  ~Cli() override { ::setenv("ABSTAND_CACHE", "off", 1); }
  ScratchFolder folder_;

  Answer run(const std::string& arguments) {
    const auto out = folder_.path() / "stdout", err = folder_.path() / "stderr";
    const std::string command = std::string("cd '") + projectFile("").string() +
                                "' && '" ABSTAND_PROGRAM "' " + arguments + " >'" + out.string() + "' 2>'" +
                                err.string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readFile(out, 1 << 28, true),
            readFile(err, 1 << 20, true)};
  }
  json runJson(const std::string& arguments) {
    const Answer a = run(arguments + " --json");
    EXPECT_EQ(a.code, 0) << a.err;
    return json::parse(a.out, nullptr, false);
  }
  std::string write(const std::string& name, const std::string& text) {
    return folder_.write(name, text).string();
  }
};

}  // namespace abstand::testing
