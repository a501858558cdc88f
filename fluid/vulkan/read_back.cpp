#include "fluid/vulkan/read_back.h"

#include "fluid/textures.h"
#include "fluid/view_place.h"

namespace windrow::vulkan {

glm::vec3 HalfView::velocity(glm::dvec3 position) const {
    const Box& box = place_.box();
    return windrow::detail::wind_at(
        windrow::detail::place_in(box, place_.window(), place_.blend_zone(), place_.ambient(), position),
        [&](int i, int j, int k) {
            const glm::u16vec4 cell = cells_[box.index(i, j, k)];
            return glm::vec3(from_half(cell.x), from_half(cell.y), from_half(cell.z));
        });
}

} // namespace windrow::vulkan
