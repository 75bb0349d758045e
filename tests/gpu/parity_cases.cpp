#include "tests/gpu/parity_cases.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

#include "tests/gpu/parity_sizes.h"
#include "tests/gpu/random_cells.h"

namespace gw::test {
namespace {

// Appends the elements of any plain vector, each as one or more words.
template <class T>
void append(Words& words, const std::vector<T>& values) {
  constexpr size_t kWords = (sizeof(T) + 7) / 8;
  words.push_back(values.size());
  for (const T& value : values) {
    uint64_t raw[kWords] = {};
    std::memcpy(raw, &value, sizeof(T));
    words.insert(words.end(), raw, raw + kWords);
  }
}

template <class CellT>
Words wordsOf(const GridStateOf<CellT>& state) {
  Words words;
  append(words, state.cells);
  for (const auto& column : {state.cellOf, state.living, state.starts, {state.moved}}) append(words, column);
  for (const auto& column : {state.low, state.high, state.reachHigh, state.reachLow, state.near, state.far,
                             state.slabReachHigh, state.slabReachLow}) {
    append(words, column);
  }
  return words;
}

// Every exponent and both signs, infinities and NaN; the second one is a neighbour or anything.
std::vector<Float2> floatPairs() {
  std::mt19937_64 random(11);
  std::vector<Float2> pairs;
  for (uint32_t i = 0; i < atMostItems(size_t(60000)); ++i) {
    const uint32_t bits[2] = {uint32_t(random()), uint32_t(random())};
    Float2 pair;
    std::memcpy(&pair, bits, sizeof pair);
    if (i % 3 == 1) pair = {between(random, -100, 100), between(random, -100, 100)};
    if (i % 3 == 2) pair.y = pair.x * between(random, -2, 2);
    pairs.push_back(pair);
  }
  const float special[] = {0.0f,
                           -0.0f,
                           1e-45f,
                           -1e-45f,
                           8192.0f,
                           8192.001f,
                           -8192.0f,
                           87.0f,
                           -87.0f,
                           88.0f,
                           std::numeric_limits<float>::infinity(),
                           -std::numeric_limits<float>::infinity(),
                           std::numeric_limits<float>::quiet_NaN(),
                           std::numeric_limits<float>::max()};
  for (float x : special) {
    for (float y : special) pairs.push_back({x, y});
  }
  return pairs;
}

std::vector<float> firsts(const std::vector<Float2>& pairs) {
  std::vector<float> values;
  for (const Float2& pair : pairs) values.push_back(pair.x);
  return values;
}

// Lengths around those at which other teams take over; ties along one axis, along all, and with dead cells, of which
// only x is at +infinity.
Words lineSorts(const Probes& device, const ExecOptions& options) {
  Words words;
  for (uint32_t length : atMostItems({1u,   2u,    3u,    4u,    5u,    127u,  128u,  129u,  511u,  512u,
                                      513u, 1000u, 1024u, 1025u, 2047u, 2048u, 2049u, 3000u, 4095u, 4096u})) {
    for (Layout layout : {Layout::uniform, Layout::coincident, Layout::zeros, Layout::line}) {
      auto line = makeCells({layout, {length, 1}, 20, length});
      for (uint32_t i = 0; i < length; i += 7) line[i].x = std::numeric_limits<float>::infinity();
      append(words, device.sortLineByX(options, line));
      append(words, device.sortLineByY(options, line));
      append(words, device.sortLineByZ(options, makeCells3({layout, {length, 1}, 20, length})));
    }
  }
  return words;
}

constexpr GridShape kShapes[] = {{1, 1}, {1, 37}, {37, 1}, {16, 16}, {48, 13}, {208, 41}, {2048, 3}, {5, 2048}};

// Lines as long as there are, and in three dimensions many short ones.
constexpr GridShape kLongShapes[] = {{2049, 2}, {4096, 2}, {3, 4095}, {2, 1, 4096}, {5, 3, 90}};

Words longLines(const Probes& device, const ExecOptions& options, Upkeep upkeep) {
  Words words;
  for (const GridShape& whole : kLongShapes) {
    const GridShape shape = atMostItems(whole);
    for (Layout layout : {Layout::uniform, Layout::coincident}) {
      const CellSpec spec{layout, shape, 10, shape.cells()};
      const Words after = shape.slabs == 1 ? wordsOf(device.upkeep(options, shape, makeCells(spec), upkeep))
                                           : wordsOf(device.upkeep3(options, shape, makeCells3(spec), upkeep));
      words.insert(words.end(), after.begin(), after.end());
    }
  }
  return words;
}

Words upkeepOf3(const Probes& device, const ExecOptions& options, Upkeep upkeep) {
  Words words;
  uint64_t seed = 1;
  for (const GridShape& whole : {GridShape{1, 1, 1}, {1, 1, 37}, {37, 5, 3}, {16, 16, 16}, {2048, 2, 2}, {3, 3, 700}}) {
    const GridShape shape = atMostItems(whole);
    for (uint32_t layout = 0; layout < kLayouts; ++layout) {
      const auto cells = makeCells3({Layout(layout), shape, 10, ++seed});
      const Words after = wordsOf(device.upkeep3(options, shape, cells, upkeep));
      words.insert(words.end(), after.begin(), after.end());
    }
  }
  return words;
}

Words reports(const Probes& device, const ExecOptions& options) {
  Words words;
  const auto take = [&](const GridReport& r) {
    append(words, std::vector<uint32_t>{r.misaligned, r.moved, r.rounds});
    for (float step : r.steps) words.push_back(std::bit_cast<uint32_t>(step));
  };
  for (uint32_t layout = 0; layout < kLayouts; ++layout) {
    for (Upkeep upkeep : {Upkeep::maintain, Upkeep::transpose, Upkeep::pack, Upkeep::sortUntilStable}) {
      take(device.report(options, {61, 33}, makeCells({Layout(layout), {61, 33}, 15, layout}), upkeep));
      take(device.report3(options, {17, 9, 8}, makeCells3({Layout(layout), {17, 9, 8}, 15, layout}), upkeep));
    }
  }
  return words;
}

Words upkeepOf(const Probes& device, const ExecOptions& options, Upkeep upkeep) {
  Words words;
  uint64_t seed = 1;
  for (const GridShape& whole : kShapes) {
    const GridShape shape = atMostItems(whole);
    for (uint32_t layout = 0; layout < kLayouts; ++layout) {
      auto state = device.upkeep(options, shape, makeCells({Layout(layout), shape, 10, ++seed}), upkeep);
      moveCells(state.cells, 1.0f, ++seed);
      const bool itself = upkeep == Upkeep::transpose || upkeep == Upkeep::refresh;
      const Upkeep next = itself ? upkeep : Upkeep::maintain;
      const Words after = wordsOf(device.upkeep(options, shape, state.cells, next));
      words.insert(words.end(), after.begin(), after.end());
    }
  }
  return words;
}

Words gathers(const Probes& device, const ExecOptions& options, Method method) {
  Words words;
  uint64_t seed = 100;
  for (uint32_t layout = 0; layout < kLayouts; ++layout) {
    const CellSpec spec{Layout(layout), {112, 23}, 15, ++seed};
    const auto cells = makeCells(spec);
    const Gathered gathered = device.gather(options, spec.shape, cells, makeQueries(cells, 300, ++seed), method);
    append(words, gathered.found);
    append(words, gathered.visits);
    append(words, gathered.tested);
  }
  return words;
}

Words gathers3(const Probes& device, const ExecOptions& options, Method method) {
  Words words;
  for (uint64_t layout = 0; layout < kLayouts; ++layout) {
    const GridShape shape{23, 11, 6};
    const auto cells = makeCells3({Layout(layout), shape, 15, layout + 300});
    const Gathered gathered = device.gather3(options, shape, cells, makeQueries3(cells, 200, layout + 400), method);
    append(words, gathered.found);
    append(words, gathered.visits);
    append(words, gathered.tested);
  }
  return words;
}

Words binnings(Binned (*bin)(const ExecOptions&, const std::vector<Cell>&), const ExecOptions& options) {
  Words words;
  for (const uint32_t count : atMostItems({1u, 2u, 300u, 5000u, 40000u})) {
    for (uint32_t layout = 0; layout < kLayouts; ++layout) {
      const Binned binned = bin(options, makeCells({Layout(layout), {count, 1}, 15, count + layout}));
      for (const Cell& cell : binned.cells) words.push_back(cell.id);
      append(words, binned.cellOf);
      append(words, binned.begin);
    }
  }
  return words;
}

Words gathersAround(const Probes& device, const ExecOptions& options, Around method) {
  Words words;
  uint64_t seed = 200;
  for (uint32_t layout = 0; layout < kLayouts; ++layout) {
    const CellSpec spec{Layout(layout), {37, 22}, 15, ++seed};
    for (const float radius : {0.3f, 5.0f, 1e30f}) {
      const CellSpec deep{Layout(layout), {13, 9, 7}, 15, seed};
      for (const Gathered& gathered : {device.gatherAround(options, spec.shape, makeCells(spec), radius, method),
                                       device.gatherAround3(options, deep.shape, makeCells3(deep), radius, method)}) {
        append(words, gathered.found);
        append(words, gathered.visits);
        append(words, gathered.tested);
      }
    }
  }
  return words;
}

std::vector<ParityCase> makeCases() {
  std::vector<ParityCase> cases;
  const auto add = [&](const char* name, auto run) { cases.push_back({name, run}); };
  using Options = const ExecOptions&;

  add("ForEach", [](const Probes& device, Options options) {
    Words words;
    for (uint32_t count : atMostItems({0u, 1u, 63u, 64u, 65u, 255u, 256u, 257u, 100000u})) {
      append(words, device.countVisits(options, count, nullptr));
      for (uint32_t live : {0u, 1u, count / 2, count, count + 7})
        append(words, device.countVisits(options, count, &live));
    }
    return words;
  });
  add("Teams", [](const Probes& device, Options options) {
    Words words;
    for (size_t teams : {0, 1, 7, 300}) {
      append(words, device.foldLines(options, makeWords(atMostItems(teams * 128), teams)));
    }
    return words;
  });
  add("BigSharedMemory", [](const Probes& device, Options options) {
    std::vector<uint32_t> line;
    for (uint32_t i = 0; i < 16384; ++i) line.push_back(i * 2654435761u);
    Words words;
    append(words, device.reverseBigLine(options, line));
    return words;
  });
  add("Atomics", [](const Probes& device, Options options) {
    return device.atomics(options, makeWords(atMostItems(size_t(100000)), 3));
  });
  add("Graph", [](const Probes& device, Options options) {
    return device.replayGraph(options, makeWords(atMostItems(size_t(5000)), 4), 20);
  });
  add("ExactMath", [](const Probes& device, Options options) {
    Words words;
    append(words, device.exactMath(options, floatPairs()));
    return words;
  });
  add("Philox", [](const Probes& device, Options options) {
    std::vector<Uint4> counters;
    std::vector<uint32_t> bits;
    std::mt19937_64 random(5);
    for (uint32_t i = 0; i < atMostItems(size_t(50000)); ++i) {
      const uint64_t word = random();
      counters.push_back({i, uint32_t(word), uint32_t(word >> 32), i % 4});
      bits.push_back(uint32_t(word));
    }
    Words words;
    append(words, device.philox(options, 0xFEEDFACECAFEBEEFull, counters));
    append(words, device.unitFloats(options, bits));
    return words;
  });
  add("FixedTerms", [](const Probes& device, Options options) {
    Words words;
    for (float scale : {1.0f, 1048576.0f, 0.0009765625f})
      append(words, device.fixedTerms(options, firsts(floatPairs()), scale));
    return words;
  });
  add("StateHash", [](const Probes& device, Options options) {
    return device.hashWords(options, makeWords(atMostItems(size_t(100000)), 6));
  });
  add("Scan", [](const Probes& device, Options options) {
    Words words;
    for (size_t count : atMostItems({0, 1, 255, 1023, 1024, 1025, 100000, 300001}))
      append(words, device.scan(options, makeWords(count, count)));
    return words;
  });
  add("Reduce", [](const Probes& device, Options options) {
    Words words;
    for (size_t count : atMostItems({0, 1, 255, 1023, 1024, 1025, 300001}))
      words.push_back(device.reduce(options, makeWords(count, count)));
    return words;
  });
  add("SortKeys", [](const Probes& device, Options options) {
    Words words;
    for (size_t count : atMostItems({1, 2, 1000, 100000})) {
      Words keys = makeWords(count, count);
      for (size_t i = 0; i < count; ++i) keys[i] = keys[i] << 32 | i;  // all different
      append(words, device.sortKeys(options, keys));
    }
    return words;
  });
  add("LineSort", lineSorts);
  add("Maintain", [](const Probes& device, Options options) { return upkeepOf(device, options, Upkeep::maintain); });
  add("Rebuild", [](const Probes& device, Options options) { return upkeepOf(device, options, Upkeep::rebuild); });
  add("Refresh", [](const Probes& device, Options options) { return upkeepOf(device, options, Upkeep::refresh); });
  add("Pack", [](const Probes& device, Options options) { return upkeepOf(device, options, Upkeep::pack); });
  add("Repack", [](const Probes& device, Options options) { return upkeepOf(device, options, Upkeep::repack); });
  add("Maintain3", [](const Probes& device, Options options) { return upkeepOf3(device, options, Upkeep::maintain); });
  add("Rebuild3", [](const Probes& device, Options options) { return upkeepOf3(device, options, Upkeep::rebuild); });
  add("Refresh3", [](const Probes& device, Options options) { return upkeepOf3(device, options, Upkeep::refresh); });
  add("Transpose3",
      [](const Probes& device, Options options) { return upkeepOf3(device, options, Upkeep::transpose); });
  add("Pack3", [](const Probes& device, Options options) { return upkeepOf3(device, options, Upkeep::pack); });
  add("Repack3", [](const Probes& device, Options options) { return upkeepOf3(device, options, Upkeep::repack); });
  add("LongLines", [](const Probes& device, Options options) { return longLines(device, options, Upkeep::maintain); });
  add("LongLinesTransposed",
      [](const Probes& device, Options options) { return longLines(device, options, Upkeep::transpose); });
  add("LongLinesPacked",
      [](const Probes& device, Options options) { return longLines(device, options, Upkeep::pack); });
  add("Reports", reports);
  add("RowGather", [](const Probes& device, Options options) { return gathers(device, options, Method::rows); });
  add("PackedRows", [](const Probes& device, Options options) { return gathers(device, options, Method::packedRows); });
  add("RowGather3", [](const Probes& device, Options options) { return gathers3(device, options, Method::rows); });
  add("PackedRows3",
      [](const Probes& device, Options options) { return gathers3(device, options, Method::packedRows); });
  add("BruteForce", [](const Probes& device, Options options) { return gathers(device, options, Method::bruteForce); });
  add("UniformGrid", [](const Probes& device, Options options) { return gathers(device, options, Method::grid); });
  add("HashedGrid", [](const Probes& device, Options options) { return gathers(device, options, Method::hashedGrid); });
  add("UniformGrid3", [](const Probes& device, Options options) { return gathers3(device, options, Method::grid); });
  add("HashedGrid3",
      [](const Probes& device, Options options) { return gathers3(device, options, Method::hashedGrid); });
  add("Bins", [](const Probes& device, Options options) { return binnings(device.binCells, options); });
  add("Buckets", [](const Probes& device, Options options) { return binnings(device.hashCells, options); });
  add("Transpose", [](const Probes& device, Options options) { return upkeepOf(device, options, Upkeep::transpose); });
  add("Settle",
      [](const Probes& device, Options options) { return upkeepOf(device, options, Upkeep::sortUntilStable); });
  add("AroundByRows",
      [](const Probes& device, Options options) { return gathersAround(device, options, Around::rows); });
  add("AroundByPackedRows",
      [](const Probes& device, Options options) { return gathersAround(device, options, Around::packedRows); });
  add("AroundByBruteForce",
      [](const Probes& device, Options options) { return gathersAround(device, options, Around::bruteForce); });
  add("NeighbourLists", [](const Probes& device, Options options) {
    Words words;
    for (uint32_t layout = 0; layout < kLayouts; ++layout) {
      for (const Method method : {Method::rows, Method::packedRows, Method::grid}) {
        const CellSpec spec{Layout(layout), {31, 14}, 15, layout}, deep{Layout(layout), {11, 8, 6}, 15, layout};
        for (const Lists& lists : {device.lists(options, spec.shape, makeCells(spec), 4.0f, method),
                                   device.lists3(options, deep.shape, makeCells3(deep), 9.0f, method)}) {
          append(words, lists.begin);
          append(words, lists.neighbours);
        }
      }
    }
    return words;
  });
  add("FixedGather",
      [](const Probes& device, Options options) { return gathersAround(device, options, Around::fixedWindow); });
  add("AdaptiveGather",
      [](const Probes& device, Options options) { return gathersAround(device, options, Around::adaptiveWindow); });
  return cases;
}

}  // namespace

const std::vector<ParityCase>& parityCases() {
  static const std::vector<ParityCase> cases = makeCases();
  return cases;
}

std::optional<std::string> difference(const Words& expected, const Words& actual) {
  if (expected.size() != actual.size()) {
    return std::to_string(actual.size()) + " words instead of " + std::to_string(expected.size());
  }
  const auto [mine, theirs] = std::mismatch(expected.begin(), expected.end(), actual.begin());
  if (mine == expected.end()) return std::nullopt;
  return "word " + std::to_string(mine - expected.begin()) + " of " + std::to_string(expected.size()) + " is " +
         std::to_string(*theirs) + " instead of " + std::to_string(*mine);
}

}  // namespace gw::test
