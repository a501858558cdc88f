#include "scene/read_log.h"

#include "fluid/core/message.h"

#include <algorithm>

namespace windrow::scene {

void ReadLog::reject(std::string_view path, std::string_view rest) {
    if (is_full())
        return count_fault();
    reject_as_is(detail::message(file_, ": ", path, " ", rest));
}

void ReadLog::reject_as_is(std::string sentence) {
    if (is_full())
        return count_fault();
    count_fault();
    if (!text_.empty())
        text_ += '\n';
    text_ += sentence;
}

void ReadLog::reject_lines(std::string_view lines) {
    while (!lines.empty()) {
        const std::size_t end = std::min(lines.find('\n'), lines.size());
        reject_as_is(detail::message(file_, ": ", lines.substr(0, end)));
        lines.remove_prefix(std::min(end + 1, lines.size()));
    }
}

void ReadLog::know(KnownKey key) {
    if (known_ != nullptr)
        known_->push_back(std::move(key));
}

Error ReadLog::error() const {
    if (count_ <= k_max_sentences)
        return Error{text_};
    return Error{detail::message(text_, "\n", file_, ": ", count_ - k_max_sentences, " more faults of this kind.")};
}

} // namespace windrow::scene
