// The message where no OpenGL 4.5 comes, in environments as they are met.
#include "render/gl_environment.h"

#include <gtest/gtest.h>

#include <map>

namespace gw {
namespace {

std::string remedyWith(const std::map<std::string, std::string>& variables) {
  return glRemedy("install a driver", [&](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? nullptr : found->second.c_str();
  });
}

TEST(GlEnvironment, WithoutVariablesADriverIsMissing) {
  EXPECT_EQ(remedyWith({}), "install a driver");
  EXPECT_EQ(remedyWith({{"HOME", "/"}, {"DISPLAY", ":0"}}), "install a driver");
}

TEST(GlEnvironment, TheVariableThatIsSetIsTheLikelyCause) {
  for (const char* name :
       {"LIBGL_DRIVERS_PATH", "__EGL_VENDOR_LIBRARY_FILENAMES", "__EGL_VENDOR_LIBRARY_DIRS", "MESA_GL_VERSION_OVERRIDE",
        "GALLIUM_DRIVER", "MESA_LOADER_DRIVER_OVERRIDE", "EGL_PLATFORM", "VK_ICD_FILENAMES"}) {
    EXPECT_EQ(remedyWith({{name, "x"}}),
              "the environment has " + std::string(name) + "='x', the likely cause: unset it");
  }
  EXPECT_EQ(remedyWith({{"LIBGL_DRIVERS_PATH", ""}}),
            "the environment has LIBGL_DRIVERS_PATH='', the likely cause: unset it")
      << "an empty one hides every driver too";
}

TEST(GlEnvironment, SeveralAreAllNamed) {
  EXPECT_EQ(remedyWith({{"MESA_GL_VERSION_OVERRIDE", "3.3"}, {"EGL_PLATFORM", "x11"}}),
            "the environment has EGL_PLATFORM='x11' and MESA_GL_VERSION_OVERRIDE='3.3', one of them the likely cause: "
            "unset them");
}

TEST(GlEnvironment, ValuesStayOnOneLineAndShort) {
  const std::string remedy = remedyWith({{"VK_DRIVER_FILES", "a\nb" + std::string(500, 'c')}});
  EXPECT_EQ(remedy.find('\n'), std::string::npos);
  EXPECT_LT(remedy.size(), 200u);
}

}  // namespace
}  // namespace gw
