// The report.json that --baseline names. What is read of it is written and read as the same, and any two reports can be
// held against each other.
#include "game/profile/metrics/baseline.h"
#include "game/profile/report/report_json.h"
#include "host/platform/atomic_file.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace gw;
  try {
    const profile::Report first = profile::reportIn(fuzz::textOf(data, size), "report.json");
    const std::string written = profile::reportJson(first);
    const profile::Report again = profile::reportIn(written, "report.json");
    fuzz::demand(profile::reportJson(again) == written, "a report is another once it has been written and read");
    fuzz::demand(!profile::baselineText(profile::compareWithBaseline(first, again)).empty(),
                 "a comparison says nothing");
  } catch (const FileError& error) {
    fuzz::demandSentence(error.what());
  }
  return 0;
}
