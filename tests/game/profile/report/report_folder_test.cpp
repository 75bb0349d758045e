// The folder of a session: every file whole, and one sentence about what cannot be written.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "game/profile/report/plots.h"
#include "game/profile/report/png.h"
#include "game/profile/report/report_json.h"
#include "game/profile/report/write_report.h"
#include "host/platform/atomic_file.h"
#include "host/platform/user_error.h"
#include "tests/game/profile/report/sample_report.h"
#include "tests/game/profile/report/scratch_folder.h"

namespace gw::profile::test {
namespace {

class ReportFolder : public ScratchFolder {
 protected:
  // report_files_test.py and profile_html_e2e.py look at what these leave there.
  std::filesystem::path samples(const char* name) const {
    const char* where = std::getenv("GW_SAMPLE_REPORTS");
    return (where == nullptr ? folder_ : std::filesystem::path(where)) / name;
  }
};

class Path {
 public:
  explicit Path(const char* value) : before_(std::getenv("PATH")) { setenv("PATH", value, 1); }
  ~Path() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

void checkFolder(const std::filesystem::path& folder, const Report& report) {
  const std::string said = writeReport(report, folder);
  EXPECT_TRUE(said.empty() || said == kNoPng) << said;
  EXPECT_EQ(reportJson(readReport(folder / "report.json")), reportJson(report));
  EXPECT_TRUE(exists(folder / "report.html"));
  for (const Plot& plot : plotsOf(report)) {
    EXPECT_TRUE(exists(folder / "plots" / (plot.name + ".svg"))) << plot.name;
    EXPECT_EQ(exists(folder / "plots" / (plot.name + ".png")), said.empty()) << plot.name;
  }
}

TEST_F(ReportFolder, HoldsAllOfASession) {
  checkFolder(samples("full"), sampleReport());
}

TEST_F(ReportFolder, HoldsAllOfASessionThatMeasuredNothing) {
  Report report;
  report.cases = {{8192, {}, {}}};
  checkFolder(samples("empty"), report);
}

TEST_F(ReportFolder, TakesNamesThatAreMarkup) {
  EXPECT_NO_THROW(writeReport(hostileReport(), samples("hostile")));
}

TEST_F(ReportFolder, IsWrittenOverAnEarlierOne) {
  writeReport(sampleReport(), folder_ / "out");
  const size_t before = filesThere();
  writeReport(sampleReport(), folder_ / "out");
  EXPECT_EQ(filesThere(), before) << "and no part is left";
}

TEST_F(ReportFolder, WithoutRsvgConvertThereAreSvgsAndASentence) {
  const Path none("/none");
  EXPECT_EQ(writeReport(sampleReport(), folder_ / "out"),
            "There is no rsvg-convert, so the pictures are SVG only: install it (Debian, Ubuntu: apt install "
            "librsvg2-bin) to get them as PNG too.");
  EXPECT_TRUE(exists(folder_ / "out" / "report.html"));
}

TEST_F(ReportFolder, AnRsvgConvertThatFailsIsSaidInASentence) {
  const std::filesystem::path fake = folder_ / "rsvg-convert";
  put(fake, "#!/bin/sh\necho 'out of paper' >&2\nexit 3\n");
  chmod(fake.c_str(), 0755);
  const Path own(folder_.c_str());
  const std::string said = refusal<UserError>([&] { writePngOf("<svg/>", folder_ / "a.png"); });
  EXPECT_EQ(said,
            "rsvg-convert could not make " + (folder_ / "a.png").string() + " (out of paper): open the SVG beside it.");
  EXPECT_EQ(filesThere(), 1u) << "the program alone";
}

// What it does instead of drawing, and what the user is told.
TEST_F(ReportFolder, AnRsvgConvertThatOnlySaysThatItDrewIsSaidInASentence) {
  const std::filesystem::path fake = folder_ / "rsvg-convert", picture = folder_ / "a.png";
  put(picture, "an earlier picture");
  const Path own((folder_.string() + ":/usr/bin:/bin").c_str());
  const std::pair<const char*, const char*> cases[] = {
      {"exit 0", "rsvg-convert ended well but wrote nothing to "},
      {"echo no picture > \"$6\"", "rsvg-convert ended well but what it wrote to "},
      {"echo 'Error: No such file or directory' >&2; exit 1", "sees other folders"},
      {"echo 'Error: Permission denied (os error 13)' >&2; exit 1", "sees other folders"},
      {"echo 'Error: No space left on device' >&2; exit 1", "(Error: No space left on device): make room"},
  };
  for (const auto& [instead, says] : cases) {
    put(fake, "#!/bin/sh\ncat > /dev/null\n" + std::string(instead) + "\n");
    chmod(fake.c_str(), 0755);
    const std::string said = refusal<UserError>([&] { writePngOf("<svg/>", picture); });
    EXPECT_NE(said.find(says), std::string::npos) << instead << ": " << said;
    EXPECT_NE(said.find("open the SVG beside it."), std::string::npos) << said;
    EXPECT_EQ(said.find("make room") != said.npos, std::string(instead).find("No space") != std::string::npos) << said;
    EXPECT_EQ(content(picture), "an earlier picture") << instead;
    EXPECT_EQ(filesThere(), 2u) << instead;
  }
}

TEST_F(ReportFolder, OneThatCannotBeIsRefusedBeforeASession) {
  EXPECT_NE(refusal<UserError>([&] { makeReportFolder(folder_ / "none" / "below"); }).find("choose a folder inside"),
            std::string::npos);
  put(folder_ / "file", "x");
  EXPECT_NE(refusal<UserError>([&] { makeReportFolder(folder_ / "file"); }).find("it is a file"), std::string::npos);
  EXPECT_NE(refusal<FileError>([&] { makeReportFolder("/proc"); }).find("/proc"), std::string::npos);
}

TEST_F(ReportFolder, AWriteProtectedOneIsRefused) {
  if (geteuid() == 0) GTEST_SKIP() << "nothing is write-protected for root";
  chmod(folder_.c_str(), 0555);
  EXPECT_NE(refusal<UserError>([&] { makeReportFolder(folder_ / "out"); }).find("cannot take"), std::string::npos);
  chmod(folder_.c_str(), 0755);
}

TEST_F(ReportFolder, AFullDiskLeavesTheEarlierReport) {
  writeReport({}, folder_);
  const std::string before = content(folder_ / "report.json");
  const size_t files = filesThere();
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit;
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit small = {1000, limit.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string said = refusal<FileError>([&] { writeReport(sampleReport(), folder_); });
  setrlimit(RLIMIT_FSIZE, &limit);
  EXPECT_NE(said.find("report.json cannot be written: "), std::string::npos) << said;
  EXPECT_NE(said.find("make room or choose another disk"), std::string::npos) << said;
  EXPECT_EQ(content(folder_ / "report.json"), before);
  EXPECT_EQ(filesThere(), files);
}

}  // namespace
}  // namespace gw::profile::test
