// What a device reports when it cannot go on. The text is one sentence with a remedy.
#pragma once

#include <stdexcept>

namespace gw {

struct DeviceError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace gw
