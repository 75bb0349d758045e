#include "game/cli/devices_options.h"

#include "host/cli/option_set.h"

namespace gw {

void DevicesOptions::declare(OptionSet& options) {
  options.pathOrStdout("--json", "write the list as JSON to OUT, or to stdout", "OUT", jsonPath);
}

}  // namespace gw
