#include "game/tables/toml_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>  // join() since fmt 11

#include <algorithm>
#include <cmath>

#include "host/platform/toml_library.h"

namespace gw {

struct TomlTable::Impl {
  std::shared_ptr<const toml::table> document;
  std::string file;
  const toml::table* node;
  std::string path;  // with a trailing dot; empty for the document
  std::vector<std::string> known;

  std::unique_ptr<Impl> child(const toml::table* table, std::string childPath) const {
    return std::make_unique<Impl>(Impl{document, file, table, std::move(childPath), {}});
  }
};

namespace {

uint32_t lineOf(const toml::node& node) {
  return std::max<uint32_t>(1, node.source().begin.line);
}

std::string shown(const toml::node& node) {
  if (const auto* v = node.as_integer()) return fmt::format("{}", v->get());
  if (const auto* v = node.as_floating_point()) return fmt::format("{}", v->get());
  if (const auto* v = node.as_string()) return fmt::format("'{}'", v->get());
  if (const auto* v = node.as_boolean()) return v->get() ? "true" : "false";
  if (node.is_table()) return "a table";
  if (node.is_array()) return "a list";
  return "a date or time";
}

// What a table quotes may hold line ends or run for pages: a message stays one line of bearable length.
std::string oneLine(std::string text) {
  constexpr size_t kStart = 300, kEnd = 200;
  if (text.size() > kStart + kEnd) text.replace(kStart, text.size() - kStart - kEnd, " ... ");
  std::replace_if(
      text.begin(), text.end(), [](char c) { return uint8_t(c) < 0x20 || c == 0x7f; }, '?');
  return text;
}

void checkLines(const RuleText& text) {
  size_t line = 1, length = 0;
  for (char c : text.text) {
    length = c == '\n' ? 0 : length + 1;
    line += c == '\n';
    if (length > TomlTable::kMaxLine) {
      throw TableError(fmt::format("{}, line {}: the line is longer than {} characters; break it", text.name, line,
                                   TomlTable::kMaxLine));
    }
  }
}

// The one place where keys are looked up; remembers that the key is known.
const toml::node& find(const TomlTable& reader, const toml::table& table, std::vector<std::string>& known,
                       std::string_view key, const char* kind) {
  if (std::find(known.begin(), known.end(), key) == known.end()) known.emplace_back(key);
  const toml::node* node = table.get(key);
  if (!node) reader.refuse(key, fmt::format("the key is missing; add it with {}", kind));
  return *node;
}

}  // namespace

TomlTable::TomlTable(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
TomlTable::TomlTable(TomlTable&&) noexcept = default;
TomlTable& TomlTable::operator=(TomlTable&&) noexcept = default;
TomlTable::~TomlTable() = default;

TomlTable TomlTable::parse(const RuleText& text) {
  if (text.text.size() > kMaxRuleText) {
    throw TableError(fmt::format("{}: the table is longer than {} bytes; shorten it", text.name, kMaxRuleText));
  }
  checkLines(text);
  try {
    auto document = std::make_shared<const toml::table>(parseToml(text.text));
    const toml::table* node = document.get();
    return TomlTable(std::make_unique<Impl>(Impl{std::move(document), text.name, node, "", {}}));
  } catch (const TomlError& error) {
    throw TableError(fmt::format("{}, line {}: this is not TOML ({}); correct the line", text.name, error.line,
                                 oneLine(error.what())));
  }
}

void TomlTable::refuse(std::string_view key, const std::string& complaint) const {
  const toml::node* node = impl_->node->get(key);
  throw TableError(fmt::format("{}, line {}, {}{}: {}", impl_->file, lineOf(node ? *node : *impl_->node), impl_->path,
                               oneLine(std::string(key)), oneLine(complaint)));
}

float TomlTable::number(std::string_view key, double least, double most) {
  const toml::node& node = find(*this, *impl_->node, impl_->known, key, "a number");
  if (!node.is_number())
    refuse(key, fmt::format("{} is not a number; give one from {} to {}", shown(node), least, most));
  const double value = node.value<double>().value_or(std::nan(""));
  if (!(value >= least && value <= most)) {
    refuse(key, fmt::format("{} is out of range; give a number from {} to {}", shown(node), least, most));
  }
  return static_cast<float>(value);
}

uint64_t TomlTable::integer(std::string_view key, uint64_t least, uint64_t most) {
  const toml::node& node = find(*this, *impl_->node, impl_->known, key, "a whole number");
  const auto* value = node.as_integer();
  if (!value) {
    refuse(key, fmt::format("{} is not a whole number; give one from {} to {}", shown(node), least, most));
  }
  if (value->get() < 0 || uint64_t(value->get()) < least || uint64_t(value->get()) > most) {
    refuse(key, fmt::format("{} is out of range; give a whole number from {} to {}", value->get(), least, most));
  }
  return uint64_t(value->get());
}

std::vector<uint64_t> TomlTable::ascendingIntegers(std::string_view key, size_t maxCount, uint64_t least,
                                                   uint64_t most) {
  const toml::node& node = find(*this, *impl_->node, impl_->known, key, "a list of whole numbers");
  const auto* array = node.as_array();
  if (!array) refuse(key, fmt::format("{} is not a list; write whole numbers in brackets", shown(node)));
  if (array->size() > maxCount) {
    refuse(key, fmt::format("the list has {} numbers; keep at most {}", array->size(), maxCount));
  }
  std::vector<uint64_t> values;
  for (const toml::node& item : *array) {
    const auto* value = item.as_integer();
    if (!value || value->get() < 0 || uint64_t(value->get()) < least || uint64_t(value->get()) > most) {
      refuse(key,
             fmt::format("{} does not belong in the list; give whole numbers from {} to {}", shown(item), least, most));
    }
    if (!values.empty() && uint64_t(value->get()) <= values.back()) {
      refuse(key, fmt::format("{} follows {}; order the numbers upwards", value->get(), values.back()));
    }
    values.push_back(uint64_t(value->get()));
  }
  return values;
}

std::string TomlTable::string(std::string_view key) {
  const toml::node& node = find(*this, *impl_->node, impl_->known, key, "a text in quotes");
  const auto* value = node.as_string();
  if (!value) refuse(key, fmt::format("{} is not a text; write one in quotes", shown(node)));
  return value->get();
}

uint32_t TomlTable::choice(std::string_view key, std::span<const std::string_view> names) {
  const std::string value = string(key);
  const auto found = std::find(names.begin(), names.end(), value);
  if (found == names.end()) {
    refuse(key, fmt::format("'{}' is not known; choose one of: {}", value, fmt::join(names, ", ")));
  }
  return uint32_t(found - names.begin());
}

TomlTable TomlTable::table(std::string_view key) {
  const toml::node& node = find(*this, *impl_->node, impl_->known, key, "a table of that name");
  const auto* value = node.as_table();
  if (!value) refuse(key, fmt::format("{} is not a table; write it as [{}{}]", shown(node), impl_->path, key));
  return TomlTable(impl_->child(value, fmt::format("{}{}.", impl_->path, key)));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key, size_t maxCount) {
  const toml::node& node = find(*this, *impl_->node, impl_->known, key, "at least one table in double brackets");
  const auto* array = node.as_array();
  if (!array || array->empty() || !array->is_homogeneous<toml::table>()) {
    refuse(key, fmt::format("this is not a list of tables; write each as [[{}{}]]", impl_->path, key));
  }
  if (array->size() > maxCount) {
    refuse(key, fmt::format("there are {} of them; keep at most {}", array->size(), maxCount));
  }
  std::vector<TomlTable> result;
  for (size_t i = 0; i < array->size(); ++i) {
    result.push_back(
        TomlTable(impl_->child(array->get_as<toml::table>(i), fmt::format("{}{}[{}].", impl_->path, key, i))));
  }
  return result;
}

void TomlTable::done() const {
  for (const auto& [key, node] : *impl_->node) {
    if (std::find(impl_->known.begin(), impl_->known.end(), key.str()) == impl_->known.end()) {
      refuse(key.str(),
             fmt::format("the key is not known; remove it or spell it as one of: {}", fmt::join(impl_->known, ", ")));
    }
  }
}

}  // namespace gw
