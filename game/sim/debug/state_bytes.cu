// Every byte of device memory, and what damage to it does. Buffers by id follow from game/sim/entity_fields.h; any
// other new buffer or member is listed here, or this file does not compile. tests/game/sim/damage_test.cpp turns over
// bits of all of them and checks what this list says.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "game/sim/debug/state_columns.h"

namespace gw::GW_DEVICE {
namespace {

struct Part {
  const char* name;
  uint32_t bytes;
  Standing standing = Standing::hashed;
  const char* why = "";
};

template <size_t kCount>
constexpr size_t bytesOf(const Part (&parts)[kCount]) {
  size_t sum = 0;
  for (const Part& part : parts) sum += part.bytes;
  return sum;
}

constexpr const char* kOtherSide = "the next tick writes it before it reads it: the two sides take turns";
constexpr const char* kZero = "always 0 and never read";
constexpr const char* kWithinTick = "what the passes of one tick hand on; each tick begins by clearing it";

constexpr Part kGlobals[] = {{"all", sizeof(GameGlobals)}};
constexpr Part kTables[] = {{"all", sizeof(Tables)}};
constexpr Part kScratch[] = {
    {"before the hashes", offsetof(TickScratch, fieldHashes), Standing::rewritten, kWithinTick},
    {"hashes", sizeof(TickScratch::fieldHashes)},
    {"after the hashes",
     uint32_t(sizeof(TickScratch) - offsetof(TickScratch, fieldHashes) - sizeof(TickScratch::fieldHashes)),
     Standing::rewritten, kWithinTick}};
constexpr Part kReport[] = {{"all", sizeof(TickReport), Standing::rewritten, "rewritten in each tick"}};
constexpr Part kCells[] = {{"x", 4}, {"y", 4}, {"id", 4}, {"type", 4}};
constexpr Part kCellsBefore[] = {
    {"all", sizeof(Cell), Standing::rewritten,
     "the start of the last tick, which only bots look at; what they did is recorded, and integrate writes it"}};
constexpr Part kCellOf[] = {{"all", sizeof(uint32_t)}};
class Listing {
 public:
  // The parts of one buffer, which fill its elements.
  template <class T, size_t kCount>
  void add(const char* name, const Buffer<T>& buffer, const Part (&parts)[kCount], bool byCell = false) {
    if (bytesOf(parts) != sizeof(T)) throw std::logic_error(std::string(name) + ": its parts do not fill it");
    uint32_t offset = 0;
    for (const Part& part : parts) offset += addPart(name, buffer, part, offset, 1, byCell);
  }

  // A buffer of state by id: the fields that lie in it, and what lies between them.
  template <class T>
  void addState(const char* name, const Buffer<T>& buffer, StateBuffer number, size_t offsetInElements) {
    for (uint32_t offset = 0; offset < sizeof(T);) {
      Part part{"unused", 4, Standing::unread, kZero};
      for (const EntityField& field : kEntityFields) {
        if (field.buffer == number && field.elementOffset - offsetInElements == offset) {
          part = {field.column, 4, Standing::ofLiving};
        }
      }
      offset += addPart(name, buffer, part, offset, 1, false);
    }
  }

  // A buffer by id that the next tick writes before it reads it.
  template <class T>
  void addWhole(const char* name, const Buffer<T>& buffer, const char* why, uint32_t perId = 1) {
    addPart(name, buffer, {"all", perId * uint32_t(sizeof(T)), Standing::rewritten, why}, 0, perId, false);
  }

  std::vector<BytesOfBuffer> list;

 private:
  // Returns its bytes.
  template <class T>
  uint32_t addPart(const char* name, const Buffer<T>& buffer, const Part& part, uint32_t offset, uint32_t perElement,
                   bool byCell) {
    list.push_back({name, part.name, part.standing, part.why, reinterpret_cast<uint8_t*>(buffer.data()) + offset,
                    part.bytes, uint32_t(sizeof(T)) * perElement, uint32_t(buffer.size()) / perElement, byCell});
    return part.bytes;
  }
};

#define GW_FILLS(parts, T) static_assert(bytesOf(parts) == sizeof(T))
GW_FILLS(kGlobals, GameGlobals);
GW_FILLS(kTables, Tables);
GW_FILLS(kScratch, TickScratch);
GW_FILLS(kReport, TickReport);
GW_FILLS(kCells, Cell);
GW_FILLS(kCellsBefore, Cell);
GW_FILLS(kCellOf, uint32_t);
#undef GW_FILLS

// GameState has these buffers and what is derived from them, and nothing else: a new one changes its size.
#define GW_COUNT_ONE(...) +1
#define GW_COUNT_TWO(...) +2
constexpr size_t kBuffers = 7 GW_STATE_BUFFERS(GW_COUNT_ONE, GW_COUNT_TWO) GW_TICK_BUFFERS(GW_COUNT_ONE);
#undef GW_COUNT_ONE
#undef GW_COUNT_TWO
struct Known {
  Buffer<uint32_t> buffers[kBuffers];
  Limits limits;
  Neighbourhood neighbourhood;
  Scan birthScan;
};
static_assert(sizeof(GameState) == sizeof(Known), "list the new buffer in bytesOf(), then count it here");

}  // namespace

#if GW_ON_CUDA
namespace {
void addDerived(Queue&, Listing&) {}  // its allocations are not listed
}  // namespace
#else
namespace {

// All that is neither named nor state: what finds neighbours, ranks births, counts and draws.
void addDerived(Queue& queue, Listing& all) {
  const size_t named = all.list.size();
  uint32_t number = 0;
  for (const GuardedMemory::Range& range : queue.memory.ranges()) {
    uint8_t* d_bytes = static_cast<uint8_t*>(range.start);
    const bool known = std::any_of(
        all.list.begin(), all.list.begin() + ptrdiff_t(named),
        [&](const BytesOfBuffer& part) { return part.d_bytes >= d_bytes && part.d_bytes < d_bytes + range.bytes; });
    if (known) continue;
    all.list.push_back({"derived " + std::to_string(++number), "all", Standing::costOnly,
                        "rebuilt from the state before it is read, or only chooses how much work is done", d_bytes, 1,
                        1, uint32_t(range.bytes)});
  }
}

}  // namespace
#endif

std::vector<BytesOfBuffer> bytesOf(Queue& queue, const GameState& state, const View& v) {
  Listing all;
  all.add("globals", state.globals, kGlobals);
  all.add("tables", state.tables, kTables);
  all.add("scratch", state.scratch, kScratch);
  all.add("report", state.report, kReport);
  all.add("cells", sideOf(state.cells, v.moved), kCells, true);
  all.add("cells before", sideOf(state.cells, v.cells), kCellsBefore, true);
  all.add("cellOf", state.cellOf, kCellOf);
#define GW_ONE(name, Type) all.addState(#name, state.name, StateBuffer::name, offsetof(EntityElements, name));
#define GW_TWO(name, next, Type)                                                                      \
  all.addState(#name, sideOf(state.name, v.next), StateBuffer::name, offsetof(EntityElements, name)); \
  all.addWhole(#name " before", sideOf(state.name, v.name), kOtherSide);
#define GW_BUFFER(name, Type, perId, ...) all.addWhole(#name, state.name, kWithinTick, perId);
  GW_STATE_BUFFERS(GW_ONE, GW_TWO)
  GW_TICK_BUFFERS(GW_BUFFER)
#undef GW_ONE
#undef GW_TWO
#undef GW_BUFFER
  addDerived(queue, all);
  return all.list;
}

}  // namespace gw::GW_DEVICE
