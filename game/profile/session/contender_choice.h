// The ways of finding neighbours that a session compares, by the words of --compare.
#pragma once

#include <string>
#include <vector>

#include "game/sim/simulation.h"

namespace gw::profile {

struct ContenderChoice {
  std::string name;   // of --compare
  std::string about;  // a few words for people
  BroadPhase broadPhase = BroadPhase::ngrid;
  Gather gather = Gather::exact;
  Sort sort = usualSort(Gather::exact);
  // It misses neighbours, so it would play another game: only its upkeep and gathering are measured, on the positions
  // of an exact run.
  bool shadow() const { return gather != Gather::exact; }
};

// All words, in the order of help texts.
const std::vector<ContenderChoice>& contenderChoices();

// Of "ngrid,grid-hashed". Throws UserError on a word that is none, one that stands twice, and a list that begins
// with one measured in shadow.
std::vector<ContenderChoice> parseContenders(const std::string& list);

}  // namespace gw::profile
