#include "scene/frame_files.h"

#include "fluid/core/message.h"
#include "scene/number_text.h"

#include <algorithm>
#include <system_error>
#include <vector>

namespace windrow::scene {

std::string FrameFiles::name(std::int64_t frame) const {
    std::string number = detail::message(frame);
    const auto width = static_cast<std::size_t>(digits);
    number.insert(0, number.size() < width ? width - number.size() : 0, '0');
    return prefix + number + suffix;
}

bool FrameFiles::is_of_another_run(std::string_view text, std::int64_t last) const {
    constexpr std::size_t k_least_digits = 4;
    if (!text.starts_with(prefix) || !text.ends_with(suffix) || text.size() < prefix.size() + suffix.size() + k_least_digits)
        return false;
    const auto digits_in = text.substr(prefix.size(), text.size() - prefix.size() - suffix.size());
    if (!std::all_of(digits_in.begin(), digits_in.end(), [](char letter) { return letter >= '0' && letter <= '9'; }))
        return false;
    const auto number = parse_whole_number(digits_in);
    return number && (*number > last || text != name(*number));
}

std::string clear_other_frames(const std::filesystem::path& folder, std::span<const FrameFiles> kept, std::int64_t last,
                               Extent extent) {
    std::vector<std::filesystem::path> others;
    std::error_code fault;
    for (auto entry = std::filesystem::directory_iterator(folder, fault);
         !fault && entry != std::filesystem::directory_iterator(); entry.increment(fault)) {
        const std::string name = entry->path().filename().string();
        std::error_code unreadable;
        if (std::any_of(kept.begin(), kept.end(), [&](const FrameFiles& files) { return files.is_of_another_run(name, last); }) &&
            entry->is_regular_file(unreadable))
            others.push_back(entry->path());
    }
    if (others.empty())
        return {};
    std::sort(others.begin(), others.end());
    const char* const frames = others.size() == 1 ? " frame" : " frames";
    if (extent == Extent::part)
        return detail::message(folder.string(), " holds ", others.size(), frames,
                               " of another run, which this run does not replace: remove those that you do not want.");
    for (const std::filesystem::path& file : others)
        if (!std::filesystem::remove(file, fault) || fault)
            return detail::message(file.string(), " is a frame of another run, and cannot be removed (", fault.message(),
                                   "): remove it.");
    return detail::message("removed ", others.size(), frames, " of a longer run, from ", others.front().string(), " on.");
}

} // namespace windrow::scene
