#include "host/overlay/imgui_layer.h"

#include <SDL_hints.h>
#include <SDL_mouse.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#if __has_include(<backends/imgui_impl_sdl2.h>)  // since 1.89.2
#include <backends/imgui_impl_sdl2.h>
#else
#include <backends/imgui_impl_sdl.h>
#endif

#include <algorithm>
#include <string>

#include "render/gl_group.h"

namespace gw {

namespace {

// ImGui's own font is made of pixels, so it is taken at whole multiples of its size.
constexpr float kFontSize_px = 13;
constexpr int kFontSizes = 3, kHeightPerSize_px = 700;

}  // namespace

ImGuiLayer::ImGuiLayer(SdlContext& context) : context_(context) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;  // whether there is one is the game's to say
  for (int times = 1; times <= kFontSizes; ++times) {
    ImFontConfig font;
    font.SizePixels = kFontSize_px * float(times);
    io.Fonts->AddFontDefault(&font);
  }
  // The backend would let the click that gives the window the focus act on the game.
  const char* before = SDL_GetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH);
  const std::string clickThrough = before ? before : "0";
  ImGui_ImplSDL2_InitForOpenGL(context_.window(), nullptr);
  SDL_SetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, clickThrough.c_str());
  ImGui_ImplOpenGL3_Init("#version 450 core");
}

ImGuiLayer::~ImGuiLayer() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplSDL2_Shutdown();
  ImGui::DestroyContext();
}

bool ImGuiLayer::handle(const SDL_Event& event) {
  const bool press = event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEWHEEL;
  if (!press && event.type != SDL_MOUSEBUTTONUP && event.type != SDL_MOUSEMOTION && event.type != SDL_WINDOWEVENT) {
    return false;
  }
  const bool takes = press && ImGui::GetIO().WantCaptureMouse;
  if (takes || !press) ImGui_ImplSDL2_ProcessEvent(&event);
  return takes;
}

void ImGuiLayer::begin() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplSDL2_NewFrame();
  ImGuiIO& io = ImGui::GetIO();
  // The backend looks only where the window has the keyboard's focus; the pointer is over it without, too.
  int x = 0, y = 0;
  SDL_GetMouseState(&x, &y);
  io.MousePos = {float(x), float(y)};
  io.FontDefault = io.Fonts->Fonts[std::clamp(context_.size().height / kHeightPerSize_px, 1, kFontSizes) - 1];
  ImGui::NewFrame();
}

void ImGuiLayer::end() {
  ImGui::Render();
  const GlGroup group("overlay");
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace gw
