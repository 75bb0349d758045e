#include "bench/balance_table.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace gw {

namespace {

constexpr uint32_t kLongDrought_ticks = 10 * kTicksPerSecond;

// One CSV line; `io` is called with every value in order, for writing and for reading alike.
template <class Run, class Io>
void eachValue(Run& run, uint32_t types, const Io& io) {
  io(run.seed);
  io(run.ticks);
  io(run.score);
  io(run.capped);
  io(run.contacts);
  io(run.drought_ticks);
  io(run.idle_ticks);
  io(run.peakAlive);
  io(run.endAlive);
  io(run.refused);
  for (uint32_t t = 0; t < types; ++t) io(run.kills[t]);
  for (uint32_t t = 0; t < types; ++t) io(run.damage_us[t]);
}

std::string headOf(const std::string& setting, const Rules& rules) {
  std::string head =
      "# " + setting + "\nseed,ticks,score,capped,contacts,drought_ticks,idle_ticks,peak_alive,end_alive,refused";
  for (const char* what : {"kills_", "damage_us_"}) {
    for (uint32_t t = 0; t < rules.enemyTypeCount; ++t) head += std::string(",") + what + rules.enemies[t].name;
  }
  return head + "\n";
}

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

double seconds(double ticks) {
  return ticks / kTicksPerSecond;
}

// The value that a share `at` of all is not above; `values` sorted.
double quantile(const std::vector<double>& values, double at) {
  return values[size_t(at * double(values.size() - 1) + 0.5)];
}

std::vector<double> sorted(const std::vector<BalanceRun>& runs, const std::function<double(const BalanceRun&)>& value) {
  std::vector<double> values;
  values.reserve(runs.size());
  for (const BalanceRun& run : runs) values.push_back(value(run));
  std::sort(values.begin(), values.end());
  return values;
}

}  // namespace

BalanceFile::BalanceFile(std::filesystem::path path, const std::string& setting, const Rules& rules)
    : path_(std::move(path)), head_(headOf(setting, rules)), types_(rules.enemyTypeCount) {
  if (path_.empty()) return;
  if (std::filesystem::exists(path_)) read();
  if (!std::filesystem::exists(path_) || std::filesystem::file_size(path_) == 0) {
    if (!(std::ofstream(path_, std::ios::binary) << head_ << std::flush)) {
      throw std::runtime_error("Cannot write " + path_.string() + "; name a folder that exists and can be written.");
    }
  }
}

void BalanceFile::read() {
  if (std::filesystem::is_directory(path_)) throw std::runtime_error(path_.string() + " is a folder; name a file.");
  std::ifstream file(path_, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw std::runtime_error("Cannot read " + path_.string() + "; name a file.");
  const size_t whole = text.rfind('\n') + 1;  // 0 when there is none
  if (whole < text.size()) {
    std::filesystem::resize_file(path_, whole);
    text.resize(whole);
  }
  if (text.empty()) return;
  if (text.rfind(head_, 0) != 0) {
    throw std::runtime_error(path_.string() +
                             " holds runs of another bot, mode, cap or other rules; choose another file with --csv.");
  }
  std::istringstream lines(text.substr(head_.size()));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream values(line);
    BalanceRun run;
    bool good = true;
    eachValue(run, types_, [&](auto& value) { good = good && (values >> value) && (values.get(), true); });
    if (!good) throw std::runtime_error(path_.string() + " is damaged at '" + line + "'; delete that line.");
    runs_.push_back(run);
  }
}

void BalanceFile::append(const BalanceRun& run) {
  runs_.push_back(run);
  if (path_.empty()) return;
  std::ostringstream line;
  const char* comma = "";
  eachValue(run, types_, [&](const auto& value) {
    line << comma << value;
    comma = ",";
  });
  line << "\n";
  if (!(std::ofstream(path_, std::ios::binary | std::ios::app) << line.str() << std::flush)) {
    throw std::runtime_error("Cannot write " + path_.string() + "; make room for it.");
  }
}

std::string balanceSummary(const std::string& title, const Rules& rules, std::vector<BalanceRun> runs) {
  std::ostringstream out;
  out << "# Balance: " << title << "\n\n";
  if (runs.empty()) {
    out << "No run was finished.\n";
    return out.str();
  }
  const auto count = double(runs.size());
  out << runs.size() << " runs\n\n| | min | p10 | median | p90 | max |\n|---|---|---|---|---|---|\n";
  const auto row = [&](const char* name, const char* pattern, const std::function<double(const BalanceRun&)>& value) {
    const std::vector<double> values = sorted(runs, value);
    out << "| " << name;
    for (const double at : {0.0, 0.1, 0.5, 0.9, 1.0}) out << " | " << format(pattern, quantile(values, at));
    out << " |\n";
  };
  row("survived, s", "%.1f", [](const BalanceRun& r) { return seconds(r.ticks); });
  row("score", "%.0f", [](const BalanceRun& r) { return double(r.score); });
  row("contacts", "%.0f", [](const BalanceRun& r) { return r.contacts; });
  row("kills", "%.0f", [](const BalanceRun& r) { return double(r.allKills()); });
  row("peak alive", "%.0f", [](const BalanceRun& r) { return r.peakAlive; });
  row("alive at the end", "%.0f", [](const BalanceRun& r) { return r.endAlive; });
  row("refused", "%.0f", [](const BalanceRun& r) { return r.refused; });
  row("longest drought, s", "%.1f", [](const BalanceRun& r) { return seconds(r.drought_ticks); });
  row("idle, %", "%.1f", [](const BalanceRun& r) { return 100.0 * r.idle_ticks / r.watched_ticks(); });

  double damage = 0, kills = 0;
  for (const BalanceRun& run : runs) {
    kills += double(run.allKills());
    for (const uint64_t us : run.damage_us) damage += double(us);
  }
  out << "\n| type | damage, % | kills, % | kills per run |\n|---|---|---|---|\n";
  for (uint32_t t = 0; t < rules.enemyTypeCount; ++t) {
    double hurt = 0, died = 0;
    for (const BalanceRun& run : runs) {
      hurt += double(run.damage_us[t]);
      died += run.kills[t];
    }
    out << "| " << rules.enemies[t].name << " | " << format("%.1f", damage > 0 ? 100 * hurt / damage : 0) << " | "
        << format("%.1f", kills > 0 ? 100 * died / kills : 0) << " | " << format("%.1f", died / count) << " |\n";
  }
  const auto with = [&](const std::function<bool(const BalanceRun&)>& is) {
    return std::count_if(runs.begin(), runs.end(), is);
  };
  double idle = 0, watched = 0;
  for (const BalanceRun& run : runs) {
    idle += run.idle_ticks;
    watched += run.watched_ticks();
  }
  const auto worst = std::max_element(runs.begin(), runs.end(), [](const BalanceRun& a, const BalanceRun& b) {
    return a.drought_ticks < b.drought_ticks;
  });
  out << "\n- Still alive at the cap: " << with([](const BalanceRun& r) { return r.capped; }) << ".\n"
      << "- Idle: " << format("%.1f", 100 * idle / watched) << " % of the first " << kWatched_ticks / kTicksPerSecond
      << " s of all runs (fewer than " << rules.idle.fewerThan << " in view, and as few coming).\n"
      << "- Droughts in that time, from " << kFirstKill_ticks / kTicksPerSecond << " s on: the worst "
      << format("%.1f", seconds(worst->drought_ticks)) << " s (seed " << worst->seed << "); over "
      << kLongDrought_ticks / kTicksPerSecond << " s in "
      << with([](const BalanceRun& r) { return r.drought_ticks > kLongDrought_ticks; }) << " runs.\n"
      << "- Births refused in " << with([](const BalanceRun& r) { return r.refused > 0; }) << " runs.\n";
  return out.str();
}

}  // namespace gw
