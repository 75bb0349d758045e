// The devices that there are.
#include <gpuwars/device_list.h>

#include <cstdio>

int main() {
  for (const gw::DeviceInfo& device : gw::listDevices().devices) std::printf("%s\n", device.kind.c_str());
  return 0;
}
