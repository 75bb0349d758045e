// A side that another program plays: 'PROGRAM probe FILE OPTIONS', a build of GpuWars that knows the verb.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "game/desync/probe.h"
#include "host/platform/user_error.h"

namespace gw {

// The other program cannot be asked, or does not answer: one sentence with a remedy.
struct ProbeError : UserError {
  explicit ProbeError(const std::string& sentence) : UserError(ExitCode::failedRun, sentence) {}
};

class ChildProcess;

class RemoteProbe final : public Probe {
 public:
  // Starts it; throws ProbeError when it does not come up. Every question may throw that, too. `giveUp` is asked now
  // and then while it does not answer.
  RemoteProbe(const std::filesystem::path& program, const std::vector<std::string>& arguments,
              std::function<bool()> giveUp = {});
  ~RemoteProbe() override;

  std::string name() const override { return name_; }
  void restart() override;
  std::vector<uint64_t> play(uint32_t ticks) override;
  void keep() override;
  void goBack() override;
  std::vector<StageHashes> playByStages() override;
  std::vector<uint64_t> blocks(const std::string& stage, const std::string& field) override;
  std::vector<uint64_t> values(const std::string& stage, const std::string& field, uint32_t block) override;
  FieldValue global(const std::string& stage, const std::string& field) override;
  std::vector<FieldValue> entity(const std::string& stage, uint32_t id) override;
  std::vector<NearEntity> around(const std::string& stage, uint32_t id, uint32_t count) override;

 private:
  template <class Read>
  auto ask(const nlohmann::json& question, const Read& read);
  void refuseToWait() const;  // throws when waiting was given up
  ProbeError answeredElse() const;

  std::string program_, name_;
  std::function<bool()> giveUp_;
  std::unique_ptr<ChildProcess> child_;
};

}  // namespace gw
