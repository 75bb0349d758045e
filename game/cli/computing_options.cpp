#include "game/cli/computing_options.h"

#include <fmt/format.h>

#include "game/cli/shared_options.h"
#include "host/cli/option_set.h"

namespace gw {
namespace {

constexpr Choice<DeviceOption> kDevices[] = {
    {"auto", DeviceOption::automatic}, {"cuda", DeviceOption::cuda}, {"cpu", DeviceOption::cpu}};
constexpr Choice<BroadPhase> kBroadPhases[] = {{"ngrid", BroadPhase::ngrid},
                                               {"grid", BroadPhase::grid},
                                               {"grid-hashed", BroadPhase::gridHashed},
                                               {"brute", BroadPhase::bruteForce}};
constexpr Choice<Gather> kGathers[] = {
    {"exact", Gather::exact}, {"adaptive", Gather::adaptive}, {"fixed", Gather::fixed}};
constexpr Choice<Sort> kSorts[] = {
    {"bitonic", Sort::bitonic}, {"odd-even", Sort::oddEven}, {"full", Sort::full}, {"frozen", Sort::frozen}};
constexpr Choice<VisitOrder> kOrders[] = {
    {"forward", VisitOrder::forward}, {"reversed", VisitOrder::reversed}, {"shuffled", VisitOrder::shuffled}};

// What --thesis stands for.
void takeThesis(ComputingOptions& o) {
  const auto refuse = [](const char* option, const char* value) {
    throw UsageError(
        fmt::format("'--thesis' means '--gather adaptive --sort bitonic'; leave it or '{} {}' out", option, value));
  };
  if (o.gather.value_or(Gather::adaptive) != Gather::adaptive) refuse("--gather", nameOf(*o.gather));
  if (o.sort.value_or(Sort::bitonic) != Sort::bitonic) refuse("--sort", nameOf(*o.sort));
  o.gather = Gather::adaptive;
  o.sort = Sort::bitonic;
}

void checkNeighbours(const ComputingOptions& o, bool ownGame) {
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
  if (o.broadPhase == BroadPhase::ngrid) return;
  const auto refuse = [&](const std::string& option) {
    throw UsageError(
        fmt::format("'{}' is about the NGrid, which '--broad-phase {}' does not use; leave out one of the two", option,
                    nameOf(o.broadPhase)));
  };
  if (o.sort && *o.sort != Sort::bitonic) refuse(fmt::format("--sort {}", nameOf(*o.sort)));
  if (o.gather.value_or(Gather::exact) != Gather::exact) {
    refuse(o.thesis ? "--thesis" : fmt::format("--gather {}", nameOf(*o.gather)));
  }
}

void checkDevice(const ComputingOptions& o) {
  const auto refuse = [](const char* option, const char* device) {
    throw UsageError(
        fmt::format("'{}' is about the {} device; leave it out or choose '--device {}'", option, device, device));
  };
  if (o.device == DeviceOption::cpu && o.blockSize != ComputingOptions().blockSize) refuse("--block-size", "cuda");
  if (o.device == DeviceOption::cpu && o.cudaCheck) refuse("--cuda-check", "cuda");
  if (o.device == DeviceOption::cuda && o.order != VisitOrder::forward) refuse("--order", "cpu");
  if (o.device == DeviceOption::cuda && o.protectMemory) refuse("--protect-memory", "cpu");
}

}  // namespace

void ComputingOptions::declareComputing(OptionSet& options, GameSource usual) {
  const bool ownGame = usual == GameSource::ownGame;
  options.choice("--device", kDevices, "the device that computes", "auto", device);
  options.integer("--threads", "worker threads of the cpu device (0: one per processor that it may use)", 0, 256,
                  threads);
  options.choice("--broad-phase", kBroadPhases, "how neighbours are found; does not change the game", "ngrid",
                 broadPhase);
  options.choice("--gather", kGathers,
                 "how the NGrid is searched; adaptive and fixed miss some neighbours, so the game differs",
                 ownGame ? "exact" : "the replay's", gather);
  options.choice(
      "--sort", kSorts, "how the NGrid is kept in order",
      ownGame ? "frozen, or bitonic with an inexact gather" : "the replay's with an inexact gather, else frozen", sort);
  options.flag("--thesis", "the thesis's own NGrid: --gather adaptive --sort bitonic", thesis);
  options.choice("--order", kOrders, "the order in which the cpu device visits items", "forward", order, kDiagnostics);
  options.flag("--protect-memory", "the cpu device's memory is unreadable outside launches and copies", protectMemory,
               kDiagnostics);
  options.integerMultiple("--block-size", "threads per block of the cuda device (128)", 32, 1024, 32, blockSize,
                          kDiagnostics);
  options.flag("--cuda-check", "the cuda device waits for every launch and reports which one failed; slow", cudaCheck,
               kDiagnostics);
  options.path("--assets", "folder of shaders and rule tables", "DIR", assetsDir, kDiagnostics);
}

void ComputingOptions::checkComputing(GameSource source) {
  if (thesis) takeThesis(*this);
  checkNeighbours(*this, source == GameSource::ownGame);
  checkDevice(*this);
}

const char* nameOf(BroadPhase broadPhase) {
  return wordFor(kBroadPhases, broadPhase);
}
const char* nameOf(Gather gather) {
  return wordFor(kGathers, gather);
}
const char* nameOf(Sort sort) {
  return wordFor(kSorts, sort);
}

}  // namespace gw
