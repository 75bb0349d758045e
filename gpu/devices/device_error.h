// What a device reports when it cannot go on. The text is one sentence with a remedy.
#pragma once

#include <stdexcept>

namespace gw {

struct DeviceError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The device has no room for what was asked of it, and is otherwise well.
struct DeviceOutOfMemory : DeviceError {
  using DeviceError::DeviceError;
};

}  // namespace gw
