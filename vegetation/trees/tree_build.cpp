// From a shape to triangles: tubes around stems, kites for leaves, parts that bear them, light within the crown.
#include "coupling/chance.h"
#include "vegetation/trees/crown_light.h"
#include "vegetation/trees/leaf_cards.h"
#include "vegetation/trees/tree_model.h"
#include "vegetation/trees/tree_shape.h"
#include "vegetation/trees/tree_wind.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace windrow::vegetation::trees {
namespace {

using windrow::detail::Chance;

constexpr std::uint32_t k_none = windrow::Tree::PartIndices::k_none;
constexpr float k_coverage = 0.7f;      // of a card that its leaves cover, about
constexpr std::size_t k_far_cards = 40; // that each stand for a part of the crown afar
constexpr float k_outward = 0.6f;       // share of the crown's own normal in a leaf's: crowns are lit as a whole

std::uint32_t bits(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

class Builder {
  public:
    explicit Builder(const TreeSettings& settings)
        : settings_(settings), shape_(shape::grow(settings)), cards_(leaf_cards(settings, shape_)), light_(absorbers(cards_)) {}

    TreeModel build() {
        add_trunk();
        add_limb_parts();
        add_stems();
        add_leaves();
        bound();
        return std::move(model_);
    }

  private:
    static std::vector<Absorber> absorbers(const std::vector<LeafCard>& cards) {
        std::vector<Absorber> made;
        made.reserve(cards.size());
        for (const LeafCard& card : cards)
            made.emplace_back(card.middle(), 0.5f * k_coverage * card.length * card.width);
        return made;
    }

    // Vertices of a tube; the number of the first.
    std::uint32_t add_rings(const shape::Stem& stem, int sides, std::uint32_t limb, float radius) {
        const auto first = static_cast<std::uint32_t>(model_.vertices.size());
        const std::size_t rings = stem.points.size();
        glm::vec3 x(1.0f, 0.0f, 0.0f);
        float way = 0.0f;
        for (std::size_t n = 0; n < rings; ++n) {
            const glm::vec3 from = stem.points[n == 0 ? 0 : n - 1], to = stem.points[std::min(n + 1, rings - 1)];
            const glm::vec3 along = glm::normalize(to - from);
            if (n > 0)
                way += glm::length(stem.points[n] - stem.points[n - 1]);
            // The last ring's x, turned with the stem: rings do not twist.
            x -= glm::dot(x, along) * along;
            x = glm::length(x) > 1e-2f ? glm::normalize(x) : glm::normalize(glm::cross(along, glm::vec3(0.3f, 0.5f, 0.8f)));
            const glm::vec3 y = glm::cross(along, x);
            const glm::vec4 open = light_.fit(stem.points[n]);
            for (int side = 0; side < sides; ++side) {
                const float share = static_cast<float>(side) / static_cast<float>(sides);
                const float turn = glm::two_pi<float>() * share;
                const glm::vec3 normal = std::cos(turn) * x + std::sin(turn) * y;
                model_.vertices.push_back({.position = glm::vec4(stem.points[n] + stem.radii[n] * normal, radius),
                                           .normal = glm::vec4(normal, 1.0f - std::abs(2.0f * share - 1.0f)),
                                           .centre = glm::vec4(stem.points[n], way),
                                           .open = open,
                                           .home = glm::vec4(0.0f),
                                           .parts = {limb, k_none, bits(0.0f), 0u}});
            }
        }
        return first;
    }

    // Quads between two rings of which every `step`-th vertex counts.
    void add_quads(std::uint32_t low, std::uint32_t high, int sides, int step) {
        for (int side = 0; side < sides; side += step) {
            const auto a = static_cast<std::uint32_t>(side), b = static_cast<std::uint32_t>((side + step) % sides);
            for (const std::uint32_t index : {low + a, high + a, low + b, low + b, high + a, high + b})
                model_.indices.push_back(index);
        }
    }

    IndexRange since(std::uint32_t first) const { return {first, static_cast<std::uint32_t>(model_.indices.size()) - first}; }

    void add_trunk() {
        constexpr int sides = shape::k_trunk_sides;
        model_.parts.push_back({{0.0f, 0.0f, 0.0f, settings_.height}, {0.0f, 1.0f, 0.0f, 1.0f}});
        const std::uint32_t first = add_rings(shape_.trunk, sides, k_none, -1.0f); // it never shrinks
        find_coarse(first);
        const auto ring = [&](int n) { return first + static_cast<std::uint32_t>(n * sides); };
        for (std::size_t n = 1; n < shape::k_coarse_rings.size(); ++n)
            add_quads(ring(shape::k_coarse_rings[n - 1]), ring(shape::k_coarse_rings[n]), sides, 2);
        model_.coarse_trunk = since(0);
        model_.trunk.first = static_cast<std::uint32_t>(model_.indices.size());
        for (int n = 1; n < shape::k_trunk_rings; ++n)
            add_quads(ring(n - 1), ring(n), sides, 1);
        model_.trunk = since(model_.trunk.first);
    }

    // Where each vertex of the trunk is on the coarse one: between the coarse rings below and above it, by height, and between
    // its neighbours where the coarse ring has no vertex.
    void find_coarse(std::uint32_t first) {
        constexpr int sides = shape::k_trunk_sides;
        const auto at = [&](int ring, int side) -> ModelVertex& {
            return model_.vertices[first + static_cast<std::uint32_t>(ring * sides + (side + sides) % sides)];
        };
        for (std::size_t n = 1; n < shape::k_coarse_rings.size(); ++n) {
            const int low = shape::k_coarse_rings[n - 1], high = shape::k_coarse_rings[n];
            for (int ring = n == 1 ? low : low + 1; ring <= high; ++ring) {
                const float y = at(ring, 0).centre.y, y_low = at(low, 0).centre.y, y_high = at(high, 0).centre.y;
                const float t = (y - y_low) / std::max(y_high - y_low, 1e-6f);
                const auto coarse = [&](int side) {
                    return glm::vec3(at(low, side).position) * (1.0f - t) + glm::vec3(at(high, side).position) * t;
                };
                for (int side = 0; side < sides; ++side) {
                    const glm::vec3 to = side % 2 == 0 ? coarse(side) : 0.5f * (coarse(side - 1) + coarse(side + 1));
                    at(ring, side).home = glm::vec4(to - glm::vec3(at(ring, side).position), 0.0f);
                }
            }
        }
    }

    void add_limb_parts() {
        for (const shape::Stem& limb : shape_.limbs) {
            const glm::vec3 chord = limb.points.back() - limb.points.front();
            const float length = std::max(glm::length(chord), 1e-3f);
            const glm::vec3 axis = glm::length(chord) > 1e-3f ? chord / length : glm::vec3(0.0f, 1.0f, 0.0f);
            model_.parts.push_back(
                {glm::vec4(limb.points.front(), length), glm::vec4(axis, limb_stiffness(settings_, length, limb.radii.front()))});
        }
    }

    void add_stems() {
        struct Listed {
            const shape::Stem* stem = nullptr;
            int sides = 4;
        };
        std::vector<Listed> listed;
        for (const shape::Stem& limb : shape_.limbs)
            listed.push_back({&limb, shape::k_limb_sides});
        for (const shape::Stem& branch : shape_.branches)
            listed.push_back({&branch, shape::k_branch_sides});
        std::stable_sort(listed.begin(), listed.end(),
                         [](const Listed& a, const Listed& b) { return a.stem->radii.front() > b.stem->radii.front(); });
        model_.stems.first = static_cast<std::uint32_t>(model_.indices.size());
        const auto before = static_cast<std::uint32_t>(model_.vertices.size());
        for (const Listed& each : listed) {
            const auto sides = static_cast<std::uint32_t>(each.sides);
            const auto limb = static_cast<std::uint32_t>(each.stem->limb) + 1u; // part 0 is the trunk
            const std::uint32_t first = add_rings(*each.stem, each.sides, limb, each.stem->radii.front());
            for (std::uint32_t n = 1; n < each.stem->points.size(); ++n)
                add_quads(first + (n - 1) * sides, first + n * sides, each.sides, 1);
            model_.stem_radii.push_back(each.stem->radii.front());
            model_.stem_ends.push_back(static_cast<std::uint32_t>(model_.indices.size()) - model_.stems.first);
            model_.stem_vertices.push_back(static_cast<std::uint32_t>(model_.vertices.size()) - before);
        }
        model_.stems = since(model_.stems.first);
    }

    // The twig's part, made when the first leaf needs it.
    std::uint32_t twig(std::uint32_t cluster, std::vector<std::uint32_t>& parts) {
        if (parts[cluster] == k_none) {
            const shape::Cluster& held = shape_.clusters[cluster];
            parts[cluster] = static_cast<std::uint32_t>(model_.parts.size());
            // Stiffness by chance, so that a crown does not nod as one.
            Chance chance(settings_.seed + cluster, 5);
            const float stiffness = chance.between(0.6f, 1.7f) * (settings_.leaf_form == LeafForm::needles ? 3.0f : 1.0f);
            model_.parts.push_back({glm::vec4(held.root, held.length), glm::vec4(held.axis, stiffness)});
        }
        return parts[cluster];
    }

    void add_leaves() {
        const std::vector<std::uint32_t> order = keeping_order(cards_, settings_.seed);
        const std::vector<glm::vec3> moved = homes(cards_, order, k_far_cards);
        std::vector<std::uint32_t> twigs(shape_.clusters.size(), k_none);
        model_.leaves.first = static_cast<std::uint32_t>(model_.indices.size());
        for (std::size_t n = 0; n < order.size(); ++n) {
            const LeafCard& card = cards_[order[n]];
            const std::uint32_t part = twig(card.cluster, twigs);
            const auto limb = static_cast<std::uint32_t>(shape_.clusters[card.cluster].limb) + 1u;
            add_card(card, static_cast<float>(n) / static_cast<float>(order.size()), limb, part,
                     n < moved.size() ? moved[n] : glm::vec3(0.0f));
            model_.leaf_parts.push_back(static_cast<std::uint32_t>(model_.parts.size()));
        }
        model_.leaves = since(model_.leaves.first);
    }

    void add_card(const LeafCard& card, float rank, std::uint32_t limb, std::uint32_t part, glm::vec3 home) {
        const glm::vec4 open = light_.fit(card.middle());
        const glm::vec3 out =
            glm::length(glm::vec3(open)) > 1e-3f ? glm::normalize(glm::vec3(open)) : glm::vec3(0.0f, 1.0f, 0.0f);
        glm::vec3 face = glm::cross(card.along, card.across);
        face = glm::dot(face, out) < 0.0f ? -face : face;
        const auto first = static_cast<std::uint32_t>(model_.vertices.size());
        const auto add = [&](float u, float v) {
            // The sides hang a little: a fold.
            const glm::vec3 at = card.root + u * card.length * card.along + 0.5f * v * card.width * card.across -
                                 0.12f * std::abs(v) * card.width * face;
            const glm::vec3 tilted = glm::normalize(face + 0.45f * v * card.across);
            const glm::vec3 blend = (1.0f - k_outward) * tilted + k_outward * out;
            model_.vertices.push_back({.position = glm::vec4(at, rank),
                                       .normal = glm::vec4(glm::length(blend) > 1e-3f ? glm::normalize(blend) : out, u),
                                       .centre = glm::vec4(card.middle(), v),
                                       .open = open,
                                       .home = glm::vec4(home, 0.0f),
                                       .parts = {limb, part, bits(card.chance), bits(card.length)}});
        };
        add(0.0f, 0.0f);
        add(0.5f, -1.0f);
        add(0.5f, 1.0f);
        add(1.0f, 0.0f);
        for (const std::uint32_t corner : {0u, 1u, 3u, 0u, 3u, 2u})
            model_.indices.push_back(first + corner);
    }

    void bound() {
        glm::vec3 low(0.0f), high(0.0f);
        for (const ModelVertex& vertex : model_.vertices) {
            low = glm::min(low, glm::vec3(vertex.position));
            high = glm::max(high, glm::vec3(vertex.position));
        }
        model_.middle = 0.5f * (low + high);
        for (const ModelVertex& vertex : model_.vertices)
            model_.radius = std::max(model_.radius, glm::length(glm::vec3(vertex.position) - model_.middle));
        model_.wind_reach = settings_.height;
    }

    const TreeSettings& settings_;
    shape::Shape shape_;
    std::vector<LeafCard> cards_;
    CrownLight light_;
    TreeModel model_{};
};

} // namespace

windrow::Result<TreeModel> build(const TreeSettings& settings) {
    if (auto judged = validate(settings); !judged)
        return judged.failure();
    return Builder(settings).build();
}

} // namespace windrow::vegetation::trees
