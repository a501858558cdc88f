#include "vegetation/render/frame_block.h"

#include "vegetation/render/light_numerics.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace windrow::vegetation::render {
namespace {

constexpr glm::vec3 k_wavelengths{0.68f, 0.55f, 0.44f}; // [um]
constexpr float k_haze_asymmetry = 0.76f; // of continental haze; the sky around the sun is brighter the nearer it is to 1
constexpr float k_casters = 60.0f;        // [m] how far before the view things may stand and still cast a shadow into it

numerics::WindrowSky shared(const SkyBlock& sky) {
    return {sky.sun, sky.rayleigh, sky.haze};
}

} // namespace

glm::mat4 view_projection(const Camera& camera, float aspect, glm::dvec3 anchor) {
    glm::mat4 projection = glm::perspectiveRH_ZO(glm::radians(camera.view_deg), aspect, camera.near, camera.far);
    projection[1][1] = -projection[1][1];
    const glm::dmat4 view = glm::lookAtRH(camera.position - anchor, camera.target - anchor, glm::dvec3(0.0, 1.0, 0.0));
    return projection * glm::mat4(view);
}

SkyBlock sky_block(const Sun& sun) {
    const float up = glm::radians(sun.elevation_deg), around = glm::radians(sun.azimuth_deg);
    SkyBlock sky;
    sky.sun = {std::cos(up) * std::cos(around), std::sin(up), std::cos(up) * std::sin(around), glm::radians(sun.radius_deg)};
    for (int channel = 0; channel < 3; ++channel) {
        sky.rayleigh[channel] = numerics::windrow_rayleigh_depth(k_wavelengths[channel]);
        sky.haze[channel] = numerics::windrow_haze_depth(k_wavelengths[channel], sun.haze);
    }
    sky.rayleigh.w = sun.irradiance;
    sky.haze.w = k_haze_asymmetry;
    return sky;
}

glm::vec3 sun_irradiance(const SkyBlock& sky) {
    return numerics::windrow_sun_irradiance(shared(sky));
}

glm::vec3 sky_irradiance(const SkyBlock& sky) {
    constexpr int rows = 32, columns = 64;
    glm::dvec3 sum(0.0);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const float mu = (static_cast<float>(row) + 0.5f) / rows; // even in the cosine: even in solid angle
            const float across = std::sqrt(1.0f - mu * mu);
            const float turn = 2.0f * glm::pi<float>() * (static_cast<float>(column) + 0.5f) / columns;
            const glm::vec3 direction(across * std::cos(turn), mu, across * std::sin(turn));
            sum += glm::dvec3(numerics::windrow_sky_radiance(shared(sky), direction) * mu);
        }
    return glm::vec3(sum * (2.0 * glm::pi<double>() / (rows * columns)));
}

CloudBlock cloud_block(const Clouds& clouds, glm::dvec3 anchor, double time) {
    const glm::dvec2 here(anchor.x, anchor.z);
    const glm::dvec2 cell = (here - glm::dvec2(clouds.drift) * time) / static_cast<double>(clouds.size);
    CloudBlock block;
    block.place = glm::vec4(glm::vec2(cell), static_cast<float>(clouds.height - anchor.y), 1.0f / clouds.size);
    block.form = {clouds.cover, clouds.depth, 0.72f, 0.0f}; // 0.72: much of a droplet's 0.85 is lost in many scatterings
    return block;
}

ShadowView shadow_view(const Camera& camera, float aspect, glm::dvec3 anchor, const SkyBlock& sky, float from, float to,
                       int texels) {
    // The smallest ball around the slice whose middle lies on the line of sight.
    const float tangent = std::tan(0.5f * glm::radians(camera.view_deg));
    const float corner = tangent * tangent * (1.0f + aspect * aspect); // squared, a metre ahead
    const float middle = glm::min(0.5f * (from + to) * (1.0f + corner), to);
    const float radius = std::sqrt((to - middle) * (to - middle) + corner * to * to);
    const glm::vec3 eye(camera.position - anchor);
    const glm::vec3 ahead(glm::normalize(camera.target - camera.position));
    const glm::vec3 centre = eye + middle * ahead;

    const glm::vec3 to_sun(sky.sun);
    const glm::vec3 guide = std::abs(to_sun.y) > 0.99f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    const glm::mat4 turn = glm::lookAtRH(to_sun, glm::vec3(0.0f), guide); // its origin is a unit toward the sun
    glm::vec3 seen(turn * glm::vec4(centre, 1.0f));
    const float texel = 2.0f * radius / static_cast<float>(texels);
    seen.x = std::floor(seen.x / texel) * texel;
    seen.y = std::floor(seen.y / texel) * texel;
    const glm::mat4 box = glm::orthoRH_ZO(seen.x - radius, seen.x + radius, seen.y - radius, seen.y + radius,
                                          -seen.z - radius - k_casters, -seen.z + radius);
    return {box * turn, texel};
}

bool sees(const glm::mat4& view, glm::vec3 middle, float radius) {
    const auto row = [&](int n) { return glm::vec4(view[0][n], view[1][n], view[2][n], view[3][n]); };
    const glm::vec4 x = row(0), y = row(1), z = row(2), w = row(3);
    for (const glm::vec4& plane : {w + x, w - x, w + y, w - y, z, w - z})
        if (glm::dot(glm::vec3(plane), middle) + plane.w < -radius * glm::length(glm::vec3(plane)))
            return false;
    return true;
}

} // namespace windrow::vegetation::render
