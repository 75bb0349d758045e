#include "game/profile/report/palette.h"

#include <iterator>

namespace gw::profile {

namespace {

constexpr Colour kLines[] = {
    {"blue", "#0067a5", "#56b4e9"}, {"vermilion", "#d1500b", "#ff8f4d"}, {"green", "#00805c", "#35c99b"},
    {"pink", "#b0467f", "#ea94c4"}, {"ochre", "#9a6b00", "#f0bd3c"},     {"slate", "#4a5563", "#c3ccd6"},
};

constexpr const char* kDashes[] = {"", "9 4", "2.5 3", "10 3 2.5 3", "5 3"};

struct Area {
  Colour colour;
  bool dark;  // wants light text
};
constexpr Area kAreas[kAreaColours] = {
    {{"indigo", "#332288", "#5d50c6"}, true}, {{"cyan", "#88ccee", "#88ccee"}, false},
    {{"moss", "#117733", "#1c8a42"}, true},   {{"sand", "#ddcc77", "#ddcc77"}, false},
    {{"wine", "#882255", "#a63a70"}, true},   {{"teal", "#44aa99", "#44aa99"}, false},
    {{"purple", "#aa4499", "#b04fa0"}, true}, {{"olive", "#a3a33d", "#a8a845"}, false},
    {{"rose", "#d97a8a", "#d97a8a"}, false},  {{"grey", "#b9bec5", "#b9bec5"}, false},
};

}  // namespace

const Colour& lineColour(size_t style) {
  return kLines[style % std::size(kLines)];
}

const char* dashOf(size_t style) {
  return kDashes[style % std::size(kDashes)];
}

const Colour& areaColour(size_t style) {
  return kAreas[style % kAreaColours].colour;
}

const Colour& inkOnArea(size_t style) {
  return kAreas[style % kAreaColours].dark ? colour::kOnDark : colour::kOnLight;
}

}  // namespace gw::profile
