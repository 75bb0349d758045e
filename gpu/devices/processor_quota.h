// The share of the processors' time that control groups leave to this process, in version 1 (cpu.cfs_quota_us) and
// version 2 (cpu.max). A limit of any group above it holds for it too.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace gw {

// Read once, when it is made; throttled_s() reads again. Never throws: what cannot be read is no limit.
class ProcessorQuota {
 public:
  // `root` holds /proc and where the groups are mounted.
  explicit ProcessorQuota(const std::filesystem::path& root = "/");

  // The time of how many processors, e.g. 0.3; nothing: no limit, or the system does not say.
  std::optional<double> processors() const;

  // For how long the group's threads have been kept waiting since it was made, each for itself: of the groups above it
  // that which waited longest. Nothing where there is no quota.
  std::optional<double> throttled_s() const;

 private:
  std::vector<std::filesystem::path> folders_;  // of its groups, each with those above it
};

}  // namespace gw
