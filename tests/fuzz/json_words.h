// What a parser of JSON asks for: the mutator takes keys, ranges and words from it.
#pragma once

#include "scene/read_log.h"

#include <string_view>
#include <vector>

namespace windrow::fuzz {

/// Defined by each target that the JSON mutator is linked to. The keys that the parser asks of this text; empty where it keeps no
/// list of them.
[[nodiscard]] std::vector<scene::KnownKey> known_keys(std::string_view text);

} // namespace windrow::fuzz
