// Preloaded: the program runs in the locale of its environment, as one does into which some library has brought it.
#include <clocale>

namespace {
const bool set = std::setlocale(LC_ALL, "") != nullptr;
}  // namespace

extern "C" bool gw_comma_locale_set() {
  return set;
}
