// The folder of a session: report.json, report.html and plots/, each file whole or not at all.
#pragma once

#include <filesystem>
#include <string>

#include "game/profile/metrics/report.h"

namespace gw::profile {

// Makes the folder and plots/ in it where they are not there. For before a session, which is long: throws UserError
// when nothing could be written there.
void makeReportFolder(const std::filesystem::path& folder);

// Files of an earlier report are replaced. Returns one sentence about it, or nothing: why there are
// no PNG, say, which the report does without. Throws UserError or FileError.
std::string writeReport(const Report& report, const std::filesystem::path& folder);

}  // namespace gw::profile
