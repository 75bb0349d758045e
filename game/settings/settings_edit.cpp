#include "game/settings/settings_edit.h"

#include <fmt/format.h>
#include <utf8.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "game/settings/settings_lines.h"
#include "host/platform/toml_library.h"

namespace gw {

namespace {

// Collects changes of a text by places in it, then makes them all.
class TextEdits {
 public:
  explicit TextEdits(const std::string& text) : text_(text) {
    lines_.push_back(0);
    for (size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1)) lines_.push_back(at + 1);
    newline_ = text.find("\r\n") == std::string::npos ? "\n" : "\r\n";
  }

  // toml++ counts lines and code points from 1.
  size_t place(const toml::source_position& position) const {
    const size_t line = lines_.at(std::min<size_t>(position.line, lines_.size()) - 1);
    const char *at = text_.data() + line, *const end = text_.data() + text_.size();
    for (size_t column = 1; column < position.column && at < end; ++column) utf8::next(at, end);
    return size_t(at - text_.data());
  }

  void replace(size_t begin, size_t end, std::string by) { edits_.push_back({begin, end, std::move(by)}); }

  // `text` is a line of its own.
  void insertAfterLine(size_t line, const std::string& text) {
    if (line < lines_.size()) return replace(lines_[line], lines_[line], text + newline_);
    replace(text_.size(), text_.size(), newline_ + text);  // the last line has no end
  }

  void append(const std::string& text) { appended_ += text + newline_; }

  std::string result() {
    std::stable_sort(edits_.begin(), edits_.end(), [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
    std::string made;
    size_t at = 0;
    for (const Edit& edit : edits_) {
      made.append(text_, at, edit.begin - at);
      made += edit.by;
      at = edit.end;
    }
    made.append(text_, at, std::string::npos);
    if (!appended_.empty() && !made.empty() && made.back() != '\n') made += newline_;
    return made + appended_;
  }

 private:
  struct Edit {
    size_t begin, end;
    std::string by;
  };
  const std::string& text_;
  std::vector<size_t> lines_;  // where each begins
  const char* newline_;
  std::vector<Edit> edits_;
  std::string appended_;
};

class Editor {
 public:
  Editor(const std::string& text, const toml::table& document) : text_(text), document_(document), edits_(text) {}

  void put(const SettingsLine& line) {
    const toml::table* table = document_[line.section].as_table();
    if (const toml::node* node = table ? table->get(line.key) : nullptr) {
      edits_.replace(edits_.place(node->source().begin), edits_.place(node->source().end), line.value);
      return;
    }
    const std::string pair = fmt::format("{} = {}", line.key, line.value);
    const size_t start = table ? edits_.place(table->source().begin) : text_.size();
    const char first = start < text_.size() ? text_[start] : '\n';
    if (first == '{') {
      size_t end = edits_.place(table->source().end) - 1;
      const char* space = text_[end - 1] == ' ' ? "" : " ";
      while (text_[end - 1] == ' ') --end;
      edits_.replace(end, end, (table->empty() ? " " : ", ") + pair + space);
    } else if (first == '[' && isHeaderOf(line.section, start)) {
      edits_.insertAfterLine(std::max(table->source().begin.line, lastLine(*table)), pair);
    } else if (table && first != '[') {
      edits_.insertAfterLine(lastLine(*table), line.section + "." + pair);
    } else {
      if (appended_ != line.section) {
        edits_.append("");
        edits_.append(fmt::format("[{}]", line.section));
        appended_ = line.section;
      }
      edits_.append(pair);
    }
  }

  std::string result() { return edits_.result(); }

 private:
  // Of the values that stand in it, not in a table below it; 0: none does.
  static uint32_t lastLine(const toml::table& table) {
    uint32_t last = 0;
    for (const auto& [key, node] : table) {
      if (!node.is_table() && !node.is_array_of_tables()) last = std::max<uint32_t>(last, node.source().end.line);
    }
    return last;
  }

  // And not that of [section.more], which makes the section too.
  bool isHeaderOf(const std::string& section, size_t start) const {
    const size_t end = text_.find(']', start);
    std::string name = text_.substr(start + 1, end == std::string::npos ? end : end - start - 1);
    std::erase_if(name, [](char c) { return c == ' ' || c == '\t' || c == '"' || c == '\''; });
    return name == section;
  }

  const std::string& text_;
  const toml::table& document_;
  TextEdits edits_;
  std::string appended_;  // the section that was begun at the end
};

std::string edited(const std::string& text, const ReadSettings& read, const Settings& now) {
  const toml::table document = toml::parse(std::string_view(text));
  Editor editor(text, document);
  const std::vector<SettingsLine> old = settingsLines(read.settings), wanted = settingsLines(now);
  for (size_t i = 0; i < wanted.size(); ++i) {
    const std::string key = fmt::format("{}.{}", wanted[i].section, wanted[i].key);
    const bool wrong = std::find(read.wrong.begin(), read.wrong.end(), key) != read.wrong.end();
    if (wrong || !(old[i] == wanted[i])) editor.put(wanted[i]);
  }
  return editor.result();
}

}  // namespace

std::optional<std::string> editSettings(const std::string& text, const ReadSettings& read, const Settings& now) {
  if (read.damaged && read.wrong.empty()) return std::nullopt;  // nothing was understood
  std::string made;
  try {
    made = edited(text, read, now);
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
  const ReadSettings again = readSettings(made, "");
  if (again.damaged || !(again.settings == now) || again.unknown != read.unknown) return std::nullopt;
  return made;
}

}  // namespace gw
