#include "game/cli/command_line_checks.h"

#include <fmt/format.h>

#include "game/cli/command_line_values.h"

namespace gw {
namespace {

[[noreturn]] void refuse(const char* sentence) {
  throw UsageError(sentence);
}

void checkNeighbours(const Options& o) {
  const bool ownGame = o.verb == Verb::play || o.verb == Verb::profile;  // else a replay says how it is gathered
  const bool exact = o.gather ? *o.gather == Gather::exact : ownGame;
  if (exact && o.sort == Sort::oddEven) {
    throw UsageError(
        "'--sort odd-even' does not keep the order that an exact gather needs; add '--gather adaptive' or "
        "'--gather fixed'");
  }
  const bool fullSort = o.sort == Sort::full || o.sort == Sort::frozen;
  if (o.gather && !exact && fullSort) {
    throw UsageError(
        fmt::format("'--sort {}' does not keep the order that '--gather {}' needs; choose '--sort bitonic' or "
                    "'--sort odd-even'",
                    nameOf(*o.sort), nameOf(*o.gather)));
  }
  if (o.sort && *o.sort != Sort::bitonic && o.broadPhase != BroadPhase::ngrid) {
    throw UsageError(fmt::format(
        "'--sort {}' keeps the NGrid in order, which '--broad-phase {}' does without; leave out one of the two",
        nameOf(*o.sort), nameOf(o.broadPhase)));
  }
  if (o.gather.value_or(Gather::exact) != Gather::exact && o.broadPhase != BroadPhase::ngrid) {
    throw UsageError(fmt::format("'{}' asks the NGrid, which '--broad-phase {}' does without; leave out one of the two",
                                 o.thesis ? "--thesis" : fmt::format("--gather {}", nameOf(*o.gather)),
                                 nameOf(o.broadPhase)));
  }
}

void checkPlay(const Options& o) {
  if (o.headless && o.fullscreen) refuse("'--headless' has no window for '--fullscreen'; leave out one of the two");
  if (o.headless && !o.ticks) refuse("'--headless' does not end by itself; give '--ticks N' too");
  if (!o.headless && !o.hashesPath.empty()) refuse("'--hashes' is for runs without a window; add '--headless'");
  if (!o.headless && !o.screenshotPath.empty()) refuse("'--screenshot' is for runs without a window; add '--headless'");
  if (!o.recordPath.empty() && o.recordPath == o.hashesPath) {
    refuse("'--record' and '--hashes' name the same file; give each its own");
  }
}

// What the name of the output asks for.
void checkRender(const Options& o) {
  if (o.outPath.empty()) {
    throw UsageError("'gpuwars render' has nowhere to draw to; give '--out' a folder, FILE.png or FILE.mp4");
  }
  const std::string ending = o.outPath.extension().string();
  for (const char* other :
       {".avi", ".bmp", ".gif", ".jpeg", ".jpg", ".mkv", ".mov", ".webm", ".webp", ".MP4", ".PNG"}) {
    if (ending != other) continue;
    throw UsageError(fmt::format("'--out {}' is no kind of file that can be made; give a folder, FILE.png or FILE.mp4",
                                 o.outPath.string()));
  }
  if (ending == ".mp4" && (o.width_px % 2 != 0 || o.height_px % 2 != 0)) {
    throw UsageError(fmt::format("'--width {}' and '--height {}' are no size for a film; give even numbers", o.width_px,
                                 o.height_px));
  }
  if (o.fromTick && o.toTick && *o.fromTick > o.toTick) {
    throw UsageError(fmt::format("'--from {}' comes after '--to {}'; exchange them", *o.fromTick, o.toTick));
  }
}

void checkVerify(const Options& o) {
  if (!o.jsonPath.empty() && o.jsonPath == o.hashesPath) {
    refuse("'--json' and '--hashes' name the same place; give each its own");
  }
  if (!o.junitPath.empty() && (o.junitPath == o.hashesPath || o.junitPath == o.jsonPath)) {
    refuse("'--junit' and '--json' or '--hashes' name the same place; give each its own");
  }
  if (o.against && !o.reference.empty()) {
    refuse("'--against' and '--reference' each name another side, and a run is played beside one; leave out one");
  }
  if (!o.referenceOptions.empty() && o.reference.empty()) {
    refuse("'--reference-options' are for the program of '--reference'; name one");
  }
  if (o.heavy && (o.against || !o.reference.empty())) {
    refuse("'--heavy' compares a run with itself, and not with another side; leave out one of the two");
  }
}

void checkProfile(const Options& o) {
  if (o.outPath.empty()) refuse("'gpuwars profile' needs a folder for its report; add '--out DIR'");
  if (o.sceneAsked && !o.replayPath.empty()) refuse("'--scene' and '--replay' each name what is played; leave out one");
  if (!o.replayPath.empty() && !o.enemiesList.empty()) {
    refuse("'--enemies' is what '--replay' was recorded with; leave it out");
  }
  if (o.ticks != 0 && o.seconds != 0) refuse("'--ticks' and '--seconds' both name the length of a run; leave out one");
  if (o.headless && o.drawNothing) refuse("'--no-draw' needs no '--headless'; leave out one of the two");
  if (o.drawNothing && o.paced) refuse("'--paced' has no effect with '--no-draw'; leave out one of the two");
  if (o.drawNothing && o.scene == profile::SceneKind::menu) refuse("'--scene menu' is drawn; leave out '--no-draw'");
  if (!o.compare.empty() && o.broadPhase != BroadPhase::ngrid) {
    refuse("'--compare' names the broad phases; leave '--broad-phase' out");
  }
  if (o.sort && !o.compare.empty() && ("," + o.compare + ",").find(",ngrid,") == std::string::npos) {
    refuse("'--sort' is about the contender ngrid, which '--compare' does not name; leave out one of the two");
  }
  if (o.gather.value_or(Gather::exact) != Gather::exact) {
    refuse("a profile plays exact games, and measures an inexact gather beside one; use '--compare ngrid,thesis'");
  }
}

void checkDevice(const Options& o) {
  if (o.device == DeviceOption::cpu && o.blockSize != Options().blockSize) {
    refuse("'--block-size' is about the cuda device; leave it out or choose '--device cuda'");
  }
  if (o.device == DeviceOption::cpu && o.cudaCheck) {
    refuse("'--cuda-check' is about the cuda device; leave it out or choose '--device cuda'");
  }
  if (o.device == DeviceOption::cuda && (o.order != VisitOrder::forward || o.protectMemory)) {
    refuse("'--order' and '--protect-memory' are about the cpu device; leave them out or choose '--device cpu'");
  }
}

}  // namespace

void takeThesis(Options& options) {
  const auto refuse = [](const char* option, const char* value) {
    throw UsageError(
        fmt::format("'--thesis' means '--gather adaptive --sort bitonic'; leave it or '{} {}' out", option, value));
  };
  if (options.gather.value_or(Gather::adaptive) != Gather::adaptive) refuse("--gather", nameOf(*options.gather));
  if (options.sort.value_or(Sort::bitonic) != Sort::bitonic) refuse("--sort", nameOf(*options.sort));
  options.gather = Gather::adaptive;
  options.sort = Sort::bitonic;
}

void checkContradictions(const Options& o) {
  checkNeighbours(o);
  if (o.verb == Verb::render) checkRender(o);
  if (o.verb == Verb::play) checkPlay(o);
  if (o.verb == Verb::verify) checkVerify(o);
  if (o.verb == Verb::profile) checkProfile(o);
  checkDevice(o);
}

}  // namespace gw
