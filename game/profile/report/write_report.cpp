#include "game/profile/report/write_report.h"

#include <fmt/format.h>

#include <system_error>

#include "game/profile/report/plots.h"
#include "game/profile/report/png.h"
#include "game/profile/report/report_html.h"
#include "game/profile/report/report_json.h"
#include "host/platform/atomic_file.h"
#include "host/platform/remedy.h"
#include "host/platform/user_error.h"

namespace gw::profile {

namespace {

namespace fs = std::filesystem;

void makeFolder(const fs::path& folder) {
  const auto refuse = [&](const std::string& why) {
    throw UserError(ExitCode::badFile, fmt::format("{} cannot take the report: {}.", folder.string(), why));
  };
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (fs::exists(status) && !fs::is_directory(status)) refuse("it is a file; give the name of a folder");
  if (!fs::exists(status) && !fs::create_directory(folder, error) && error) {
    refuse(becauseNoFolder(error.value()));
  }
}

void write(const fs::path& path, const std::string& text) {
  writeFileAtomically(path, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

}  // namespace

void makeReportFolder(const fs::path& folder) {
  for (const fs::path& one : {folder, folder / "plots"}) {
    makeFolder(one);
    checkWritable(one / "report.json");
  }
}

std::string writeReport(const Report& report, const fs::path& folder) {
  makeReportFolder(folder);
  write(folder / "report.json", reportJson(report));
  const std::vector<Plot> plots = plotsOf(report);
  for (const Plot& plot : plots) {
    std::error_code none;
    fs::remove(folder / "plots" / (plot.name + ".png"), none);  // an earlier session's would belie the new picture
    write(folder / "plots" / (plot.name + ".svg"), plot.svg);
  }
  write(folder / "report.html", reportHtml(report, plots));
  try {
    for (const Plot& plot : plots) {
      if (!writePngOf(plot.svg, folder / "plots" / (plot.name + ".png"))) return kNoPng;
    }
  } catch (const FileError&) {  // a report that is not whole is no report
    throw;
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

}  // namespace gw::profile
