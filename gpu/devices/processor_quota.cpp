#include <gpuwars/processor_quota.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

namespace gw {
namespace {

namespace fs = std::filesystem;

bool listHas(std::string_view list, std::string_view name) {
  while (!list.empty()) {
    const size_t end = std::min(list.find(','), list.size());
    if (list.substr(0, end) == name) return true;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return false;
}

// A group of the hierarchy that shares out processors, as /proc/self/cgroup names it: "1:cpu,cpuacct:/path", or
// "0::/path" for version 2.
struct Group {
  bool version2;
  fs::path path;
};

std::vector<Group> groupsOfThisProcess(const fs::path& root) {
  std::vector<Group> groups;
  std::ifstream file(root / "proc/self/cgroup");
  for (std::string line; std::getline(file, line);) {
    const size_t first = line.find(':'), second = line.find(':', std::min(first, line.size() - 1) + 1);
    if (first == line.npos || second == line.npos) continue;
    const std::string_view controllers = std::string_view(line).substr(first + 1, second - first - 1);
    const bool version2 = line.starts_with("0:") && controllers.empty();
    if (version2 || listHas(controllers, "cpu")) groups.push_back({version2, line.substr(second + 1)});
  }
  return groups;
}

// "\040" stands for a space, and so on.
std::string unescaped(const std::string& text) {
  std::string plain;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool code = text[i] == '\\' && i + 3 < text.size() && text.find_first_not_of("01234567", i + 1) > i + 3;
    plain += code ? char(std::stoi(text.substr(i + 1, 3), nullptr, 8)) : text[i];
    if (code) i += 3;
  }
  return plain;
}

// Where a hierarchy is mounted, and which of its groups stands there: in a container mostly its own.
struct Mount {
  bool version2;
  fs::path group, folder;
};

std::vector<Mount> mountsOf(const fs::path& root) {
  std::vector<Mount> mounts;
  std::ifstream file(root / "proc/self/mountinfo");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word, group, folder, type, source, options;
    words >> word >> word >> word >> group >> folder;
    while (words >> word && word != "-") {
    }
    words >> type >> source >> options;
    const bool version2 = type == "cgroup2";
    if (!version2 && !(type == "cgroup" && listHas(options, "cpu"))) continue;
    mounts.push_back({version2, unescaped(group), root / fs::path(unescaped(folder)).relative_path()});
  }
  return mounts;
}

// The folder of the group and of all above it, as far as they can be seen from here.
void addFolders(std::vector<fs::path>& folders, const Group& group, const Mount& mount) {
  const fs::path below = group.path.lexically_relative(mount.group);
  fs::path folder = mount.folder;
  folders.push_back(folder);
  if (below.empty() || *below.begin() == "..") return;  // it is not below what is mounted: another namespace's name
  for (const fs::path& name : below) {
    if (name != ".") folders.push_back(folder /= name);
  }
}

// Of "max 100000", "30000 100000", and of the two files of version 1.
std::optional<double> quotaIn(const fs::path& folder) {
  double quota = 0, period = 0;
  if (std::ifstream(folder / "cpu.max") >> quota >> period ||
      (std::ifstream(folder / "cpu.cfs_quota_us") >> quota && std::ifstream(folder / "cpu.cfs_period_us") >> period)) {
    if (quota > 0 && period > 0) return quota / period;
  }
  return std::nullopt;
}

std::optional<double> throttledIn_s(const fs::path& folder) {
  std::ifstream file(folder / "cpu.stat");
  std::string name;
  for (double value = 0; file >> name >> value;) {
    if (name == "throttled_usec") return value * 1e-6;  // version 2
    if (name == "throttled_time") return value * 1e-9;  // version 1
  }
  return std::nullopt;
}

// Of all that have a value.
template <class Of, class Choose>
std::optional<double> over(const std::vector<fs::path>& folders, Of of, Choose choose) {
  std::optional<double> chosen;
  for (const fs::path& folder : folders) {
    if (const std::optional<double> value = of(folder)) chosen = chosen ? choose(*chosen, *value) : *value;
  }
  return chosen;
}

}  // namespace

ProcessorQuota::ProcessorQuota(const fs::path& root) {
  const std::vector<Mount> mounts = mountsOf(root);
  for (const Group& group : groupsOfThisProcess(root)) {
    for (const Mount& mount : mounts) {
      if (group.version2 == mount.version2) addFolders(folders_, group, mount);
    }
  }
}

std::optional<double> ProcessorQuota::processors() const {
  return over(folders_, quotaIn, [](double a, double b) { return std::min(a, b); });
}

std::optional<double> ProcessorQuota::throttled_s() const {
  if (!processors()) return std::nullopt;
  return over(folders_, throttledIn_s, [](double a, double b) { return std::max(a, b); });
}

}  // namespace gw
