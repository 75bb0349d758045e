// What options each verb takes, and where their values go.
#pragma once

#include "game/cli/command_line.h"
#include "game/cli/command_line_values.h"

namespace gw {

class VerbOptions {
 public:
  // Declares those of options.verb. What is parsed is read by the values, so that every refusal is one sentence of
  // ours; all three must live until they are.
  VerbOptions(CommandLineValues& values, Options& options);
  VerbOptions(const VerbOptions&) = delete;
  VerbOptions& operator=(const VerbOptions&) = delete;

 private:
  void addGame();
  void addComputing();
  void addSize();
  void addWindow();
  void addReplay();
  void addRender();
  void addVerify();
  void addDesync();
  void addProbe();
  void addTrim();
  void addDiff();
  void addDevices();
  void addProfile();

  CommandLineValues& values_;
  Options& options_;
};

}  // namespace gw
