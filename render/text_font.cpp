#include "render/text_font.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "render/asset_file.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb/stb_image.h>

namespace gw {

namespace {

constexpr const char* kMetrics = "fonts/neon.json";
constexpr int kMostAtlas_px = 8192;

// Bytes of the file may be part of why it is refused: the sentence stays on one line.
[[noreturn]] void refuse(const std::filesystem::path& file, std::string why) {
  std::replace_if(
      why.begin(), why.end(), [](char c) { return uint8_t(c) < 0x20 || c == 0x7f; }, '?');
  throw std::runtime_error("The font " + file.string() + " is damaged (" + why +
                           "): put it back from the GpuWars package, or make it again with tools/make_font.py.");
}

// A file beside the metrics: nothing of another folder, nothing that does not fit on a line.
bool isPlainName(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == '.';
  });
}

float positive(const nlohmann::json& json, const char* key, const std::filesystem::path& file) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number() || !(found->get<float>() > 0)) {
    refuse(file, std::string(key) + " must be a number above 0");
  }
  return found->get<float>();
}

Glyph readGlyph(const nlohmann::json& json, uint32_t code, PixelSize atlas, const std::filesystem::path& file) {
  const std::string name = "glyph " + std::to_string(code);
  if (!json.is_array() || json.size() != 7) refuse(file, name + " must be 7 numbers");
  float value[7];
  for (size_t i = 0; i < 7; ++i) {
    if (!json[i].is_number()) refuse(file, name + " must be 7 numbers");
    value[i] = json[i].get<float>();
  }
  const Glyph glyph{value[0], value[1], value[2], value[3], value[4], value[5], value[6]};
  const bool inside = glyph.x >= 0 && glyph.y >= 0 && glyph.width >= 0 && glyph.height >= 0 &&
                      glyph.x + glyph.width <= float(atlas.width) && glyph.y + glyph.height <= float(atlas.height);
  if (!inside || !(glyph.advance > 0 && glyph.advance < 100)) refuse(file, name + " lies outside the atlas");
  return glyph;
}

}  // namespace

const Glyph& TextFont::glyph(char character) const {
  const auto code = uint32_t(uint8_t(character));
  return glyphs[(code < kFirst || code > kLast ? uint32_t('?') : code) - kFirst];
}

float TextFont::width_px(std::string_view text, float size_px) const {
  float units = 0;
  for (const char character : text) units += glyph(character).advance;
  return text.empty() ? 0 : (units - spacing) * size_px / capHeight;
}

TextFont loadTextFont(const std::filesystem::path& assets) {
  const std::filesystem::path metricsFile = assets / kMetrics;
  const nlohmann::json json = nlohmann::json::parse(readAsset(assets, kMetrics), nullptr, false);
  if (!json.is_object()) refuse(metricsFile, "not JSON");

  TextFont font;
  font.pixelsPerUnit = positive(json, "pixelsPerUnit", metricsFile);
  font.capHeight = positive(json, "capHeight", metricsFile);
  font.range = positive(json, "range", metricsFile);
  font.spacing = positive(json, "spacing", metricsFile);

  const auto image = json.find("image");
  if (image == json.end() || !image->is_string() || !isPlainName(image->get<std::string>())) {
    refuse(metricsFile, "it names no image");
  }
  const std::string imageName = "fonts/" + image->get<std::string>();
  const std::string bytes = readAsset(assets, imageName);
  int width = 0, height = 0, channels = 0;
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const bool known = stbi_info_from_memory(data, int(bytes.size()), &width, &height, &channels) != 0;
  if (!known || width > kMostAtlas_px || height > kMostAtlas_px) refuse(assets / imageName, "not a PNG of its size");
  stbi_uc* pixels = stbi_load_from_memory(data, int(bytes.size()), &width, &height, &channels, 1);
  if (pixels == nullptr) refuse(assets / imageName, stbi_failure_reason());
  font.atlasSize = {width, height};
  font.atlas.assign(pixels, pixels + size_t(width) * size_t(height));
  stbi_image_free(pixels);

  const auto glyphs = json.find("glyphs");
  if (glyphs == json.end() || !glyphs->is_object()) refuse(metricsFile, "it has no glyphs");
  for (uint32_t code = TextFont::kFirst; code <= TextFont::kLast; ++code) {
    const auto found = glyphs->find(std::to_string(code));
    if (found == glyphs->end()) refuse(metricsFile, "glyph " + std::to_string(code) + " is missing");
    font.glyphs[code - TextFont::kFirst] = readGlyph(*found, code, font.atlasSize, metricsFile);
  }
  return font;
}

}  // namespace gw
