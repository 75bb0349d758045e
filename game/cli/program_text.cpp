// What --help and the man page of the program say beyond its verbs.
#include <fmt/format.h>

#include "game/cli/command_line.h"
#include "game/replay/format.h"

namespace gw {
namespace {

std::string codeOf(ExitCode code) {
  return std::to_string(int(code));
}

ProgramText makeProgramText() {
  ProgramText text;
  text.name = "gpuwars";
  text.version = fmt::format("gpuwars {} (simulation {}, replay format {}.{})", GW_VERSION, kSimulationVersion,
                             kReplayMajor, kReplayMinor);
  text.title = "GpuWars";
  text.summary = "a twin-stick shooter whose whole simulation runs as GPU kernels";
  text.verbHint = "to watch a file: 'gpuwars replay FILE'";
  text.filePattern = "*.gwr";
  text.paragraphs = {
      "You are a GPUship inside the computer universe and process (shoot) what a GPU processes: thousands of enemies,\n"
      "each of which thinks, moves and collides sixty times a second.\n"
      "Without an NVIDIA GPU the same kernels run on the processor, with the same results, bit for bit.",
      "Games can be recorded; a replay can be watched, made into a video, and verified tick by tick.\n"
      "Options mean the same under every verb; each verb has a page of its own."};
  text.files = {{"~/.config/gpuwars/settings.toml",
                 "The settings, written by the settings screen; --settings names another file."}};
  text.environment = {{"XDG_CONFIG_HOME", "The folder of settings in place of ~/.config."},
                      {"CUDA_VISIBLE_DEVICES", "Hides NVIDIA GPUs from CUDA programs."}};
  text.exitCodes = {{codeOf(ExitCode::fine), "success"},
                    {codeOf(ExitCode::failedRun), "failed run (diff: the replays differ)"},
                    {codeOf(ExitCode::badUsage), "bad usage"},
                    {codeOf(ExitCode::badFile), "bad file"},
                    {codeOf(ExitCode::desync), "desync"},
                    {"128 + N", "signal N ended the run early (130: Ctrl-C), and what was written is complete"}};
  return text;
}

}  // namespace

const ProgramText& programText() {
  static const ProgramText text = makeProgramText();
  return text;
}

}  // namespace gw
