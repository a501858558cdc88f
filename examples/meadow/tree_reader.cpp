#include "examples/meadow/tree_reader.h"

#include <string>

namespace meadow {

std::vector<nlohmann::json> read_trees(windrow::scene::JsonObject& picture) {
    constexpr std::size_t k_most_stands = 256;
    const auto items = picture.array("trees", k_most_stands);
    for (std::size_t i = 0; i < items.size(); ++i) // refuses what is no object
        (void)windrow::scene::JsonObject(items[i], picture.path() + ".trees[" + std::to_string(i) + "]",
                                         picture.pattern() + ".trees[]", picture.log());
    return {items.begin(), items.end()};
}

} // namespace meadow
