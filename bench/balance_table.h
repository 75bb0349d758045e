// What gw_bench_balance keeps and says: one CSV line per run, and a summary of all in Markdown.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/balance_run.h"

namespace gw {

// The finished runs of one setting. Lines are appended as runs finish, so that work can be stopped and
// taken up again; a line that was cut off half-way is dropped.
class BalanceFile {
 public:
  // Reads what is there. Throws std::runtime_error, one sentence, when the file is unreadable, damaged, or
  // holds runs of another setting. An empty path keeps nothing.
  BalanceFile(std::filesystem::path path, const std::string& setting, const Rules& rules);

  const std::vector<BalanceRun>& runs() const { return runs_; }
  void append(const BalanceRun& run);  // throws std::runtime_error

 private:
  void read();

  std::filesystem::path path_;
  std::string head_;
  uint32_t types_;
  std::vector<BalanceRun> runs_;
};

// `title`: who played what.
std::string balanceSummary(const std::string& title, const Rules& rules, std::vector<BalanceRun> runs);

}  // namespace gw
