#include "game/cli/diff_options.h"

#include "host/cli/option_set.h"

namespace gw {

void DiffOptions::declare(OptionSet& options) {
  options.files("FILE", "the two replays to compare", 2, 2, files);
  options.pathOrStdout("--json", "write the differences as JSON to OUT, or to stdout", "OUT", jsonPath);
}

}  // namespace gw
