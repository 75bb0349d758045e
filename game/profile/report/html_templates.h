// Several named templates in one text. A line "<!-- template NAME -->" starts one; {{KEY}} is replaced by a value.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace gw::profile {

class HtmlTemplates {
 public:
  using Values = std::initializer_list<std::pair<std::string_view, std::string_view>>;

  // `text` must outlive this.
  explicit HtmlTemplates(std::string_view text);

  // Values are inserted as they are: text must be escaped already. Throws std::logic_error when the template does not
  // exist, or one of its keys has no value.
  std::string fill(std::string_view name, Values values) const;

 private:
  std::map<std::string_view, std::string_view> templates_;
};

}  // namespace gw::profile
