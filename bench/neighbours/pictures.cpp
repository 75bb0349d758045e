// Draws the NGrid from real runs, for docs/design/ngrid.md:
//
//   build/release/gw_ngrid_pictures docs/images
#include "bench/neighbours/pictures.h"

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "Usage: gw_ngrid_pictures FOLDER; it writes ngrid_*.png there.\n");
    return 2;
  }
  try {
    const gw::TextFont font = gw::loadTextFont(GW_ASSETS_DIR);
    gw::bench::drawOrders(argv[1], font);
    gw::bench::drawGathers(argv[1], font);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
