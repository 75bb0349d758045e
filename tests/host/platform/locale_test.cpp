// Numbers are written in one way, whatever the locale: files are for programs, and a film has the same bytes
// everywhere.
#include <gtest/gtest.h>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "game/profile/metrics/baseline.h"
#include "game/ui/tick_text.h"
#include "host/platform/number_format.h"

namespace gw::test {
namespace {

namespace fs = std::filesystem;

// A locale with decimal commas while it lives: an installed one, else one that is made for the purpose.
class DecimalCommas {
 public:
  DecimalCommas() {
    if (set()) return;
    std::string name = (fs::temp_directory_path() / "gw_locale_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) return;
    made_ = name;
    const std::string command = "localedef -i de_DE -f UTF-8 '" + name + "/de_DE.UTF-8' > /dev/null 2>&1";
    if (std::system(command.c_str()) != 0) return;
    setenv("LOCPATH", name.c_str(), 1);
    set();
  }
  ~DecimalCommas() {
    std::setlocale(LC_ALL, "C");
    unsetenv("LOCPATH");
    if (!made_.empty()) fs::remove_all(made_);
  }

  static bool there() { return std::string(std::localeconv()->decimal_point) == ","; }

 private:
  static bool set() { return std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr && there(); }

  fs::path made_;
};

TEST(Locale, NumbersForPeopleAndFilesHavePoints) {
  const DecimalCommas locale;
  if (!DecimalCommas::there()) GTEST_SKIP() << "no locale with decimal commas, and localedef makes none";
  char text[16];
  std::snprintf(text, sizeof text, "%.1f", 60.04);
  ASSERT_STREQ(text, "60,0") << "else this test would show nothing";

  EXPECT_EQ(oneDecimal(60.04), "60.0");
  EXPECT_EQ(twoDecimals(1.234), "1.23");
  EXPECT_EQ(withCommas(1234567), "1,234,567");
  EXPECT_EQ(minutesTenths(4530), "1:15.5");
  EXPECT_EQ(multiplierText(124), "x12.4");
  profile::Comparison comparison;
  comparison.compared.push_back({});
  profile::Compared& one = comparison.compared.back();
  one.enemies = 64;
  one.contender = "ngrid";
  one.metric = "frame_ms.p99";
  one.old = 12.5;
  one.now = 1234.5;
  one.ratio = {1.25, 1.125, 1.5};
  const std::string table = profile::baselineText(comparison);
  for (const char* number : {" 12.50 ", "1.250 (1.125 to 1.500)"}) {
    EXPECT_NE(table.find(number), std::string::npos) << table;
  }
  EXPECT_EQ(table.find(','), table.find(", ngrid")) << table;
}

}  // namespace
}  // namespace gw::test
