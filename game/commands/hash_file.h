// --hashes: one line a tick, "tick hash" with the hash as 16 hexadecimal digits.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace gw {

class HashFile {
 public:
  // Empty: writes nothing. "-": stdout. Throws UserError when the file cannot be written.
  explicit HashFile(const std::filesystem::path& path);

  void write(uint32_t tick, uint64_t hash);
  // A line between the hashes of several replays; starts with '#'.
  void comment(const std::string& text);
  // Throws UserError when something could not be written.
  void close();

  bool isStdout() const { return file_ == stdout; }

 private:
  struct Closer {
    void operator()(std::FILE* file) const {
      if (file != stdout) std::fclose(file);
    }
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Closer> owner_;
  std::FILE* file_ = nullptr;
};

}  // namespace gw
