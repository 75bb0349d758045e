#include "game/profile/session/contender_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "host/platform/user_error.h"

namespace gw::profile {

const std::vector<ContenderChoice>& contenderChoices() {
  static const std::vector<ContenderChoice> choices{
      {"ngrid", "NGrid, exact gather, frozen rows"},
      {"grid", "uniform grid: dense cells, counting sort", BroadPhase::grid},
      {"grid-hashed", "hashed uniform grid with index sort, as in the thesis", BroadPhase::gridHashed},
      {"brute", "everybody asks everybody", BroadPhase::bruteForce},
      {"thesis", "the thesis's NGrid: adaptive N-radius, bitonic sort", BroadPhase::ngrid, Gather::adaptive,
       Sort::bitonic},
  };
  return choices;
}

std::vector<ContenderChoice> parseContenders(const std::string& list) {
  std::vector<ContenderChoice> chosen;
  std::string known;
  for (const ContenderChoice& choice : contenderChoices()) known += (known.empty() ? "" : ", ") + choice.name;
  const auto refuse = [](const std::string& sentence) { throw UserError(ExitCode::badUsage, sentence); };
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const auto is = [&](const ContenderChoice& choice) { return choice.name == word; };
    const auto& all = contenderChoices();
    const auto found = std::find_if(all.begin(), all.end(), is);
    if (found == all.end()) {
      refuse(
          fmt::format("'--compare {}' names '{}', which is none of {}; separate them by commas.", list, word, known));
    }
    if (std::any_of(chosen.begin(), chosen.end(), is)) {
      refuse(fmt::format("'--compare {}' names {} twice; once is enough.", list, word));
    }
    chosen.push_back(*found);
  }
  if (chosen.empty()) refuse(fmt::format("'--compare' names nothing; choose among {}.", known));
  if (chosen.front().shadow()) {
    refuse(
        fmt::format("'{}' is measured on the positions of an exact run; name one of those first, as in "
                    "'--compare ngrid,{}'.",
                    chosen.front().name, chosen.front().name));
  }
  return chosen;
}

}  // namespace gw::profile
