// The members of the plain structs that a tick works on, by name. A member that is missing here does not compile.
#pragma once

#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "game/sim/debug/inspection.h"
#include "game/sim/game_globals.h"

namespace gw {

// Adjacent numbers of one type in a struct.
struct Member {
  const char* name;
  ValueKind kind;
  size_t offset, bytes, numberBytes;
};

template <class Number>
constexpr Member memberOf(const char* name, size_t offset, size_t bytes) {
  using One = std::remove_all_extents_t<Number>;
  static_assert(std::is_arithmetic_v<One> || std::is_enum_v<One>);
  return {name, std::is_floating_point_v<One> ? ValueKind::real : ValueKind::whole, offset, bytes, sizeof(One)};
}

// Whether they are in order, without gaps, and fill the struct.
template <size_t kCount>
constexpr bool fill(const Member (&members)[kCount], size_t structBytes) {
  size_t next = 0;
  for (const Member& member : members) {
    if (member.offset != next) return false;
    next += member.bytes;
  }
  return next == structBytes;
}

#define GW_MEMBER_OF(Struct, member)                                                                             \
  memberOf<std::remove_reference_t<decltype(std::declval<Struct&>().member)>>(#member, offsetof(Struct, member), \
                                                                              sizeof(std::declval<Struct&>().member))

inline constexpr Member kGlobalsMembers[] = {
    GW_MEMBER_OF(GameGlobals, seed),
    GW_MEMBER_OF(GameGlobals, score),
    GW_MEMBER_OF(GameGlobals, kills),
    GW_MEMBER_OF(GameGlobals, totals.contact),
    GW_MEMBER_OF(GameGlobals, totals.occupied),
    GW_MEMBER_OF(GameGlobals, totals.kills),
    GW_MEMBER_OF(GameGlobals, totals.bareKills),
    GW_MEMBER_OF(GameGlobals, totals.dying),
    GW_MEMBER_OF(GameGlobals, totals.bitsTaken),
    GW_MEMBER_OF(GameGlobals, totals.inView),
    GW_MEMBER_OF(GameGlobals, totals.coming),
    GW_MEMBER_OF(GameGlobals, totals.refusedBits),
    GW_MEMBER_OF(GameGlobals, totals.reserved),
    GW_MEMBER_OF(GameGlobals, ship.x),
    GW_MEMBER_OF(GameGlobals, ship.y),
    GW_MEMBER_OF(GameGlobals, ship.previous_x),
    GW_MEMBER_OF(GameGlobals, ship.previous_y),
    GW_MEMBER_OF(GameGlobals, ship.velocity_x),
    GW_MEMBER_OF(GameGlobals, ship.velocity_y),
    GW_MEMBER_OF(GameGlobals, ship.aim_rad),
    GW_MEMBER_OF(GameGlobals, ship.untouchable_ticks),
    GW_MEMBER_OF(GameGlobals, ship.fire_ticks),
    GW_MEMBER_OF(GameGlobals, tick),
    GW_MEMBER_OF(GameGlobals, over),
    GW_MEMBER_OF(GameGlobals, multiplierTenths),
    GW_MEMBER_OF(GameGlobals, frameTime_us),
    GW_MEMBER_OF(GameGlobals, bank_us),
    GW_MEMBER_OF(GameGlobals, flushes),
    GW_MEMBER_OF(GameGlobals, flushScores),
    GW_MEMBER_OF(GameGlobals, flush_x),
    GW_MEMBER_OF(GameGlobals, flush_y),
    GW_MEMBER_OF(GameGlobals, flushRadius_m),
    GW_MEMBER_OF(GameGlobals, blast),
    GW_MEMBER_OF(GameGlobals, blastId),
    GW_MEMBER_OF(GameGlobals, wave),
    GW_MEMBER_OF(GameGlobals, waveClock_ticks),
    GW_MEMBER_OF(GameGlobals, idle_ticks),
    GW_MEMBER_OF(GameGlobals, endless),
    GW_MEMBER_OF(GameGlobals, clock_ticks),
    GW_MEMBER_OF(GameGlobals, allAttack),
    GW_MEMBER_OF(GameGlobals, endlessPoints),
    GW_MEMBER_OF(GameGlobals, pace),
    GW_MEMBER_OF(GameGlobals, contacts),
    GW_MEMBER_OF(GameGlobals, bitsTaken),
    GW_MEMBER_OF(GameGlobals, refused),
    GW_MEMBER_OF(GameGlobals, peakEnemies),
    GW_MEMBER_OF(GameGlobals, input.move_x),
    GW_MEMBER_OF(GameGlobals, input.move_y),
    GW_MEMBER_OF(GameGlobals, input.aim),
    GW_MEMBER_OF(GameGlobals, input.buttons),
    GW_MEMBER_OF(GameGlobals, killsByType),
    GW_MEMBER_OF(GameGlobals, reserved),
};
static_assert(fill(kGlobalsMembers, sizeof(GameGlobals)));

inline constexpr Member kCommandMembers[] = {
    GW_MEMBER_OF(Command, type),      GW_MEMBER_OF(Command, count),      GW_MEMBER_OF(Command, firstBirth),
    GW_MEMBER_OF(Command, pattern),   GW_MEMBER_OF(Command, x),          GW_MEMBER_OF(Command, y),
    GW_MEMBER_OF(Command, angle_rad), GW_MEMBER_OF(Command, spread_rad), GW_MEMBER_OF(Command, hits),
};
static_assert(fill(kCommandMembers, sizeof(Command)));

// Of what stages pass to each other; the commands follow in a list of their own, what is for the report only is left
// out.
inline constexpr Member kScratchMembers[] = {
    GW_MEMBER_OF(TickScratch, input.move_x), GW_MEMBER_OF(TickScratch, input.move_y),
    GW_MEMBER_OF(TickScratch, input.aim),    GW_MEMBER_OF(TickScratch, input.buttons),
    GW_MEMBER_OF(TickScratch, commandCount), GW_MEMBER_OF(TickScratch, births),
    GW_MEMBER_OF(TickScratch, bitRoom),
};
static_assert(fill(kScratchMembers, offsetof(TickScratch, commands)));

#undef GW_MEMBER_OF

// The numbers of `members` in the struct at `from` as columns of one value each, called "prefix.member[i]".
template <size_t kCount>
void addMembers(std::vector<Column>& columns, const std::string& prefix, const Member (&members)[kCount],
                const void* from) {
  for (const Member& member : members) {
    const size_t count = member.bytes / member.numberBytes;
    for (size_t i = 0; i < count; ++i) {
      uint64_t value = 0;  // little-endian, as is every machine that this is built for
      std::memcpy(&value, static_cast<const char*>(from) + member.offset + i * member.numberBytes, member.numberBytes);
      columns.push_back({prefix + member.name + (count > 1 ? "[" + std::to_string(i) + "]" : ""), member.kind,
                         std::make_shared<const std::vector<uint64_t>>(1, value)});
    }
  }
}

}  // namespace gw
