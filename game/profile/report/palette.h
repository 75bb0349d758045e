// Colours and dashes of the report's pictures. Each colour has a twin for dark pages; nothing is told by colour alone.
#pragma once

#include <cstddef>

namespace gw::profile {

struct Colour {
  const char* name;  // of its CSS class
  const char* light;
  const char* dark;
};

namespace colour {
inline constexpr Colour kPanel{"panel", "#ffffff", "#161b22"}, kEdge{"edge", "#d0d5dc", "#39424e"},
    kInk{"ink", "#1c2128", "#e8ecf1"}, kFaint{"faint", "#59636e", "#9aa5b1"}, kGrid{"grid", "#e6e9ed", "#2a323c"},
    kReference{"reference", "#8a3ffc", "#be95ff"}, kOnDark{"on-dark", "#ffffff", "#ffffff"},
    kOnLight{"on-light", "#111111", "#111111"};
}  // namespace colour

// Of contenders: after Okabe and Ito, darkened for white pages and lightened for dark ones. They repeat after 6, their
// dashes after 5, so that 30 contenders differ in one of the two.
const Colour& lineColour(size_t style);
const char* dashOf(size_t style);  // of stroke-dasharray

// Of stages: after Tol's muted set. They repeat after kAreaColours.
inline constexpr size_t kAreaColours = 10;
const Colour& areaColour(size_t style);
const Colour& inkOnArea(size_t style);

}  // namespace gw::profile
