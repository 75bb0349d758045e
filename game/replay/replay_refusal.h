// What is wrong in a replay file, from the code that finds it.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "game/replay/replay.h"

namespace gw {

class ReplayRefusal {
 public:
  explicit ReplayRefusal(std::string name) : name_(std::move(name)) {}

  // One sentence about the file, which says what to do.
  [[noreturn]] void refuse(const std::string& what) const { throw ReplayError(fmt::format("{}: {}", name_, what)); }
  // The same for a file that is not as it was written.
  [[noreturn]] void damaged(const std::string& what) const {
    refuse(fmt::format("the replay is damaged ({}); {}", what, kFetchAgain));
  }

  const std::string& name() const { return name_; }

  static constexpr const char* kFetchAgain = "copy or record it again";

 private:
  std::string name_;  // of the file, as messages call it
};

}  // namespace gw
