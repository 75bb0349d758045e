#include "game/profile/report/html_templates.h"

#include <algorithm>
#include <stdexcept>

namespace gw::profile {

namespace {

constexpr std::string_view kHead = "<!-- template ", kHeadEnd = " -->\n", kOpen = "{{", kClose = "}}";

std::string_view valueOf(std::string_view key, HtmlTemplates::Values values) {
  const auto found = std::find_if(values.begin(), values.end(), [&](const auto& value) { return value.first == key; });
  if (found == values.end()) throw std::logic_error("The template has no value for " + std::string(key) + ".");
  return found->second;
}

}  // namespace

HtmlTemplates::HtmlTemplates(std::string_view text) {
  for (size_t head = text.find(kHead); head != text.npos;) {
    const size_t name = head + kHead.size(), nameEnd = text.find(kHeadEnd, name);
    const size_t body = nameEnd + kHeadEnd.size(), next = text.find(kHead, body);
    templates_[text.substr(name, nameEnd - name)] = text.substr(body, std::min(next, text.size()) - body);
    head = next;
  }
}

std::string HtmlTemplates::fill(std::string_view name, Values values) const {
  const auto found = templates_.find(name);
  if (found == templates_.end()) throw std::logic_error("There is no template " + std::string(name) + ".");
  std::string html;
  std::string_view rest = found->second;
  for (size_t open = rest.find(kOpen); open != rest.npos; open = rest.find(kOpen)) {
    const size_t key = open + kOpen.size(), close = rest.find(kClose, key);
    html += rest.substr(0, open);
    html += valueOf(rest.substr(key, close - key), values);
    rest.remove_prefix(close + kClose.size());
  }
  return html += rest;
}

}  // namespace gw::profile
