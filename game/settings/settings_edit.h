// Changing values in the text of a settings file as an editor would: comments, order, unknown keys and the player's own
// way of writing a number stay.
#pragma once

#include <optional>
#include <string>

#include "game/settings/settings_text.h"

namespace gw {

// `text`, of which `read` was read, so that reading it gives `now` and nothing is wrong in it any more. A key that it
// lacks goes behind the others of its section. None when it is no TOML, or has its sections in a way of its own.
std::optional<std::string> editSettings(const std::string& text, const ReadSettings& read, const Settings& now);

}  // namespace gw
