#include "gpu/exec/tick_graph.h"
#include "gpu/math/state_hash.h"
#include "tests/gpu/probe_parts.h"

namespace gw::GW_DEVICE {
namespace {

// One item: counts its own visit.
struct CountVisit {
  uint32_t* visits;
  GW_BODY void operator()(uint32_t i) const { atomicAddTo(visits[i], 1); }
};

std::vector<uint32_t> countVisits(const ExecOptions& options, uint32_t capacity, const uint32_t* live) {
  Queue queue(options);
  Buffer<uint32_t> visits(queue, capacity + 1024), count(queue, 1);
  if (live) count.upload(live, 1);
  forEach(queue, Count{capacity, live ? count.data() : nullptr}, CountVisit{visits.data()});
  auto result = visits.download();
  return result;
}

// One team: one line of 128 words. Each phase reads what other lanes wrote in the phase before.
struct FoldLine {
  static constexpr uint32_t kLanes = 128;
  struct Shared {
    uint64_t word[2][kLanes];
  };
  uint64_t* lines;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    uint64_t* line = lines + uint64_t(team.index) * kLanes;
    team.phase([&](uint32_t lane) { s.word[0][kLanes - 1 - lane] = line[lane]; });
    uint32_t from = 0;
    for (uint32_t step = 1; step < kLanes; step *= 2) {
      team.phase([&](uint32_t lane) {
        s.word[1 - from][lane] = 3 * s.word[from][lane] + s.word[from][(lane + step) % kLanes];
      });
      from = 1 - from;
    }
    team.phase([&](uint32_t lane) { line[lane] = s.word[from][lane] + team.index; });
  }
};

test::Words foldLines(const ExecOptions& options, const test::Words& lines) {
  Queue queue(options);
  auto words = uploaded(queue, lines);
  const uint32_t teams = uint32_t(lines.size()) / FoldLine::kLanes;
  forEachTeam(queue, teams, FoldLine{words.data()});
  auto result = words.download();
  return result;
}

// One team in all: more shared memory than a CUDA kernel gets without asking.
struct ReverseBigLine {
  static constexpr uint32_t kLanes = 256, kWords = 16384;
  struct Shared {
    uint32_t word[kWords];
  };
  uint32_t* line;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    team.phase([&](uint32_t lane) {
      for (uint32_t i = lane; i < kWords; i += kLanes) s.word[kWords - 1 - i] = line[i];
    });
    team.phase([&](uint32_t lane) {
      for (uint32_t i = lane; i < kWords; i += kLanes) line[i] = s.word[i];
    });
  }
};

std::vector<uint32_t> reverseBigLine(const ExecOptions& options, const std::vector<uint32_t>& line) {
  Queue queue(options);
  Buffer<uint32_t> words(queue, ReverseBigLine::kWords);
  words.upload(line);
  forEachTeam(queue, 1, ReverseBigLine{words.data()});
  auto result = words.download();
  return result;
}

// One item: one word, into all three totals.
struct AddToTotals {
  uint32_t* sum;
  uint64_t *most, *sum64;
  const uint64_t* in;
  GW_BODY void operator()(uint32_t i) const {
    atomicAddTo(*sum, uint32_t(in[i]));
    atomicRaiseTo(*most, in[i]);
    atomicAddTo64(*sum64, in[i]);
  }
};

test::Words atomics(const ExecOptions& options, const test::Words& in) {
  Queue queue(options);
  auto words = uploaded(queue, in);
  Buffer<uint32_t> sum(queue, 1);
  Buffer<uint64_t> most(queue, 1), sum64(queue, 1);
  forEach(queue, Count{uint32_t(in.size())}, AddToTotals{sum.data(), most.data(), sum64.data(), words.data()});
  test::Words result{sum.download()[0], most.download()[0], sum64.download()[0]};
  return result;
}

// One item: mixes a word with its neighbour's of the launch before.
struct MixWithNext {
  uint64_t* out;
  const uint64_t* in;
  uint32_t count;
  GW_BODY void operator()(uint32_t i) const { out[i] = mixed(in[i] + 3 * in[i + 1 < count ? i + 1 : 0]); }
};

test::Words replayGraph(const ExecOptions& options, const test::Words& in, uint32_t ticks) {
  Queue queue(options);
  auto words = uploaded(queue, in);
  const uint32_t n = uint32_t(in.size());
  Buffer<uint64_t> a(queue, n), b(queue, n);
  TickGraph graph;  // moved into, as its users do
  graph = TickGraph(queue, [&] {
    forEach(queue, Count{n}, MixWithNext{a.data(), words.data(), n});
    forEach(queue, Count{n}, MixWithNext{b.data(), a.data(), n});
    forEach(queue, Count{n}, MixWithNext{words.data(), b.data(), n});
  });
  for (uint32_t t = 0; t < ticks; ++t) graph.replay(queue);
  auto result = words.download();
  return result;
}

}  // namespace

void addExecProbes(test::Probes& probes) {
  probes.countVisits = countVisits;
  probes.foldLines = foldLines;
  probes.reverseBigLine = reverseBigLine;
  probes.atomics = atomics;
  probes.replayGraph = replayGraph;
}

test::Probes probes() {
  test::Probes all{};
  addExecProbes(all);
  addMathProbes(all);
  addScanProbes(all);
  addGridProbes(all);
  addGatherProbes(all);
  return all;
}

}  // namespace gw::GW_DEVICE
