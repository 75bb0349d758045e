// main() has one handler for all errors that a user can correct: each knows its exit code.
#include <gtest/gtest.h>

#include "game/desync/remote_probe.h"
#include "game/profile/session/runner.h"
#include "game/replay/replay.h"
#include "game/tables/rule_texts.h"
#include "host/cli/option_set.h"
#include "host/platform/atomic_file.h"

namespace gw::test {
namespace {

template <class Error>
ExitCode codeOf(const Error& error) {
  try {
    throw error;
  } catch (const UserError& caught) {
    EXPECT_STREQ(caught.what(), "a sentence");
    return caught.code;
  }
}

TEST(ErrorCodes, EachErrorHasItsOwn) {
  EXPECT_EQ(codeOf(UserError(ExitCode::failedRun, "a sentence")), ExitCode::failedRun);
  EXPECT_EQ(codeOf(UsageError("a sentence")), ExitCode::badUsage);
  EXPECT_EQ(codeOf(FileError("a sentence")), ExitCode::badFile);
  EXPECT_EQ(codeOf(ReplayError("a sentence")), ExitCode::badFile);
  EXPECT_EQ(codeOf(TableError("a sentence")), ExitCode::badFile);
  EXPECT_EQ(codeOf(ProbeError("a sentence")), ExitCode::failedRun);
  EXPECT_EQ(codeOf(profile::SceneDesync("a sentence")), ExitCode::desync);
}

}  // namespace
}  // namespace gw::test
