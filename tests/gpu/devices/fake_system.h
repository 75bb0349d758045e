// A folder that stands for /: /proc and /sys as some other machine, container or service has them.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace gw::test {

class FakeSystem {
 public:
  FakeSystem() {
    static int count = 0;
    root_ = std::filesystem::temp_directory_path() /
            ("gw_fake_system_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    std::filesystem::remove_all(root_);
    std::filesystem::create_directories(root_);
  }
  ~FakeSystem() { std::filesystem::remove_all(root_); }
  FakeSystem(const FakeSystem&) = delete;
  FakeSystem& operator=(const FakeSystem&) = delete;

  const std::filesystem::path& root() const { return root_; }

  // `path` below /, e.g. "proc/self/cgroup".
  FakeSystem& file(const std::string& path, const std::string& text) {
    std::filesystem::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
    return *this;
  }

 private:
  std::filesystem::path root_;
};

}  // namespace gw::test
