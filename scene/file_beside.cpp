#include "scene/file_beside.h"

#include "fluid/input_file.h"
#include "fluid/message.h"
#include "scene/json_document.h"

namespace windrow::scene {

std::optional<std::filesystem::path> file_beside(JsonObject& object, const char* key, const std::filesystem::path& folder) {
    const std::string name = object.text(key, "");
    const auto value = object.value().find(key);
    if (value == object.value().end() || !value->is_string())
        return std::nullopt;
    if (detail::is_name_inside(name))
        return folder / std::filesystem::path(name).lexically_normal();
    object.refuse(key, detail::message("is ", quote_json(*value),
                                       ": name a file in the scene's folder, relative to it, so that the folder can be handed on "
                                       "as a whole."));
    return std::nullopt;
}

} // namespace windrow::scene
