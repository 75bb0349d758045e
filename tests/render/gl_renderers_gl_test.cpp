#include <algorithm>

#include "render/gl_renderers.h"
#include "tests/render/gl_fixture.h"

namespace gw {
namespace {

using GlRenderers = GlTest;

TEST_F(GlRenderers, WhatDrawsHereIsListed) {
  const std::string drawing = context_->rendererName();
  const std::vector<GlRenderer> renderers = listGlRenderers();
  context_->makeCurrent();  // for the fixture's last check
  const auto found = std::find_if(renderers.begin(), renderers.end(),
                                  [&](const GlRenderer& renderer) { return renderer.name == drawing; });
  ASSERT_NE(found, renderers.end()) << drawing;
  // Mesa calls its software rasterisers so, and only those.
  EXPECT_EQ(found->software, drawing.find("llvmpipe") != std::string::npos || drawing.find("softpipe") == 0);
  if (found->software) {
    EXPECT_FALSE(found->cudaDevice.has_value());
  }
}

TEST_F(GlRenderers, PlacesAreNamedApartAndTheSameEachTime) {
  const std::vector<GlRenderer> first = listGlRenderers(), second = listGlRenderers();
  context_->makeCurrent();
  ASSERT_EQ(first.size(), second.size());
  for (size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].place, second[i].place);
    EXPECT_EQ(first[i].name, second[i].name);
    for (size_t j = 0; j < i; ++j) EXPECT_NE(first[i].place, first[j].place);
  }
}

}  // namespace
}  // namespace gw
