#include "gpu/line_sort.h"
#include "gpu/ngrid.h"
#include "tests/gpu/probe_parts.h"

namespace gw::GW_DEVICE {
namespace {

// One team in all: sorts one line.
template <class Less>
struct SortOneLine {
  static constexpr uint32_t kLanes = 128;
  struct Shared {
    Cell line[kLongestLine];
  };
  Cell* cells;
  uint32_t length;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    team.phase([&](uint32_t lane) {
      for (uint32_t i = lane; i < length; i += kLanes) s.line[i] = cells[i];
    });
    sortLine<kLanes>(team, s.line, length, Less{});
    team.phase([&](uint32_t lane) {
      for (uint32_t i = lane; i < length; i += kLanes) cells[i] = s.line[i];
    });
  }
};

template <class Less>
std::vector<Cell> sortOneLine(const ExecOptions& options, const std::vector<Cell>& line) {
  Queue queue(options);
  auto cells = uploaded(queue, line);
  forEachTeam(queue, 1, SortOneLine<Less>{cells.data(), uint32_t(line.size())});
  auto result = cells.download();
  countLaunches(1);
  return result;
}

// One item: one row, copied to where the host can download it from.
struct CopyRows {
  float *low, *high, *reachHigh, *reachLow;
  uint32_t* living;
  NGridView grid;
  GW_BODY void operator()(uint32_t row) const {
    low[row] = grid.low[row];
    high[row] = grid.high[row];
    reachHigh[row] = grid.reachHigh[row];
    reachLow[row] = grid.reachLow[row];
    living[row] = grid.living[row];
  }
};

test::GridState upkeep(const ExecOptions& options, test::GridShape shape, const std::vector<Cell>& start,
                       test::Upkeep upkeep) {
  Queue queue(options);
  NGrid grid(queue, {shape.columns, shape.rows});
  auto cells = uploaded(queue, start);
  Buffer<uint32_t> cellOf(queue, start.size()), living(queue, shape.rows);
  cellOf.upload(std::vector<uint32_t>(start.size(), 0xFFFFFFFFu));
  Buffer<float> low(queue, shape.rows), high(queue, shape.rows), reachHigh(queue, shape.rows),
      reachLow(queue, shape.rows);
  switch (upkeep) {
    case test::Upkeep::maintain:
      grid.maintain(queue, cells.data(), cellOf.data());
      break;
    case test::Upkeep::rebuild:
      grid.rebuild(queue, cells.data(), cellOf.data());
      break;
    case test::Upkeep::refresh:
      grid.refresh(queue, cells.data(), cellOf.data());
      break;
    case test::Upkeep::settle:
      grid.settle(queue, cells.data(), cellOf.data());
      break;
    case test::Upkeep::transpose:
      grid.transpose(queue, cells.data(), cellOf.data());
      countLaunches(5);
      return {cells.download(), cellOf.download(), {}, {}, {}, {}, {}};
  }
  forEach(queue, Count{shape.rows},
          CopyRows{low.data(), high.data(), reachHigh.data(), reachLow.data(), living.data(), grid.view(cells.data())});
  test::GridState state{cells.download(), cellOf.download(),    living.download(),  low.download(),
                        high.download(),  reachHigh.download(), reachLow.download()};
  countLaunches(upkeep == test::Upkeep::refresh ? 3 : upkeep == test::Upkeep::maintain ? 4 : 7);
  return state;
}

}  // namespace

void addGridProbes(test::Probes& probes) {
  probes.sortLineByX = sortOneLine<ByX>;
  probes.sortLineByY = sortOneLine<ByY>;
  probes.upkeep = upkeep;
}

}  // namespace gw::GW_DEVICE
