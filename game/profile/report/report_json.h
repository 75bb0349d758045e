// report.json: all of a Report, for scripts and for --baseline. docs/reference/profile-report.md describes it, and
// docs/reference/profile-report.schema.json to the letter.
#pragma once

#include <filesystem>
#include <string>

#include "game/profile/metrics/report.h"

namespace gw::profile {

// Every finite number reads back as the same bits; the others are null and read back as NaN. Ends in a newline.
std::string reportJson(const Report& report);

// Throws FileError for what is no report of this version: damaged, cut short, or with something missing.
Report readReport(const std::filesystem::path& path);
// The same from its text; `shown` is what a refusal calls it.
Report reportIn(const std::string& text, const std::filesystem::path& shown);

}  // namespace gw::profile
