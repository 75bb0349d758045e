#include "game/overlay/overlay_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "game/cli/computing_options.h"

namespace gw {

namespace {

constexpr ImU32 kQuick = IM_COL32(93, 255, 165, 220), kSlow = IM_COL32(255, 194, 71, 230),
                kTooSlow = IM_COL32(255, 74, 94, 240), kBar = IM_COL32(53, 224, 255, 130),
                kQuiet = IM_COL32(160, 180, 192, 255), kGroove = IM_COL32(255, 255, 255, 22),
                kLine = IM_COL32(255, 255, 255, 60);
constexpr double k60Fps_ms = 1000.0 / 60, k30Fps_ms = 1000.0 / 30;
constexpr float kColumns = 40;  // the panel's width, in letters

void say(const std::string& text) {
  ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
}

void sayQuietly(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, kQuiet);
  say(text);
  ImGui::PopStyleColor();
}

// One column a frame, the newest at the right; lines at 60 and 30 frames a second.
void drawFrames(const FrameHistory& frames) {
  const float width = ImGui::GetContentRegionAvail().x, height = 3 * ImGui::GetTextLineHeight();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(corner, {corner.x + width, corner.y + height}, kGroove);
  const double top_ms = std::max(1.25 * k30Fps_ms, std::min(frames.longest_ms(), 200.0));
  const auto y = [&](double ms) { return corner.y + height * float(1 - std::min(ms / top_ms, 1.0)); };
  const std::vector<double> times_ms = frames.oldestFirst_ms();
  const float column = width / float(FrameHistory::kFrames);
  float x = corner.x + width - column * float(times_ms.size());
  for (const double ms : times_ms) {
    const ImU32 colour = ms > k30Fps_ms ? kTooSlow : ms > 1.1 * k60Fps_ms ? kSlow : kQuick;
    draw.AddRectFilled({x, y(ms)}, {x + std::max(column, 1.0f), corner.y + height}, colour);
    x += column;
  }
  for (const double ms : {k60Fps_ms, k30Fps_ms}) draw.AddLine({corner.x, y(ms)}, {corner.x + width, y(ms)}, kLine);
  ImGui::Dummy({width, height});
}

void drawStages(const OverlayFigures& figures) {
  if (figures.stages.empty()) {
    sayQuietly("stages of a tick: none was timed yet");
    return;
  }
  say(fmt::format("stages of a tick      {:8.3f} ms", figures.stages_ms()));
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (const StageFigure& stage : figures.stages) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float share = float(stage.perTick_ms / std::max(figures.stages_ms(), 1e-9));
    draw.AddRectFilled(corner, {corner.x + width, corner.y + height - 1}, kGroove);
    draw.AddRectFilled(corner, {corner.x + width * share, corner.y + height - 1}, kBar);
    say(fmt::format(" {:<20} {:8.3f} ms {:3.0f}%", stage.name, stage.perTick_ms, 100 * share));
  }
}

void drawCensus(const OverlayFigures& figures, const Rules& rules) {
  say(fmt::format("enemies alive {} of {}", figures.liveEnemies(), figures.enemiesThatFit));
  std::vector<std::string> counts;
  for (uint32_t type = 0; type < rules.enemyTypeCount; ++type) {
    counts.push_back(fmt::format(" {:<11}{:6}", rules.enemies[type].name, figures.census.enemies[type]));
  }
  counts.push_back(fmt::format(" {:<11}{:6}", "shots", figures.census.shots));
  counts.push_back(fmt::format(" {:<11}{:6}", "bits", figures.census.bits));
  for (size_t i = 0; i < counts.size(); i += 2) say(counts[i] + (i + 1 < counts.size() ? counts[i + 1] : ""));
}

void drawNeighbours(const OverlayFigures& figures) {
  std::string way = std::string("broad phase ") + nameOf(figures.broadPhase);
  if (figures.broadPhase == BroadPhase::ngrid) {
    way += fmt::format(", {}, {}", nameOf(figures.gather), nameOf(figures.sort));
  }
  say(way);
  if (figures.candidates.entities > 0) {
    say(fmt::format("candidates per entity {:9.1f}", figures.candidatesPerEntity()));
    say(fmt::format("neighbours per entity {:9.1f}", figures.neighboursPerEntity()));
  } else {
    sayQuietly("candidates: none searched, or too many");
  }
  if (const auto misaligned = figures.misaligned_percent()) {
    say(fmt::format("misaligned in NGrid   {:9.1f} %", *misaligned));
  } else {
    sayQuietly("misaligned: there is no NGrid");
  }
}

}  // namespace

void drawOverlayPanel(const OverlayFigures& figures, const PanelFrame& frame) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float letter = ImGui::CalcTextSize("0").x, margin = ImGui::GetStyle().WindowPadding.x;
  // Under the score, which stands in the top 112 of 720.
  ImGui::SetNextWindowPos({8, screen.y * 112 / 720}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize({kColumns * letter + 2 * margin, 0});
  ImGui::SetNextWindowBgAlpha(0.78f);
  const ImGuiWindowFlags still = frame.pointer ? ImGuiWindowFlags_None : ImGuiWindowFlags_NoInputs;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {4, 1});
  const bool open = ImGui::Begin("F3 hide  F4 colours  F5 broad phase", nullptr,
                                 ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                     ImGuiWindowFlags_NoFocusOnAppearing | still);
  if (open) {
    say(fmt::format("real {:.0f} FPS", frame.realFps));
    sayQuietly(fmt::format("ms: mean {:.1f}  p99 {:.1f}  longest {:.1f}", frame.frames.mean_ms(), frame.frames.p99_ms(),
                           frame.frames.longest_ms()));
    drawFrames(frame.frames);
    drawStages(figures);
    ImGui::Separator();
    drawCensus(figures, frame.rules);
    ImGui::Separator();
    drawNeighbours(figures);
    if (frame.colouring == Colouring::rows) say("coloured by row of the grid");
    ImGui::Separator();
    say(fmt::format("memory {:.1f} MiB on the device", double(figures.deviceBytes) / (1 << 20)));
    say(figures.device);
    sayQuietly(fmt::format("tick {}  hash {:016x}", frame.last.tick, frame.last.hash));
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace gw
