#include "vegetation/trees/leaf_cards.h"

#include "coupling/chance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace windrow::vegetation::trees {
namespace {

using windrow::detail::Chance;

constexpr float k_golden = 2.39996323f; // [rad]
constexpr std::size_t k_spread = 400;   // cards that are chosen by distance; more are too many to tell one from another

LeafCard card_on(const TreeSettings& s, const shape::Cluster& cluster, std::uint32_t number, int n, Chance& chance) {
    const glm::vec3 axis = cluster.axis;
    const glm::vec3 guide = std::abs(axis.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
    const glm::vec3 x = glm::normalize(glm::cross(guide, axis)), y = glm::cross(axis, x);
    const bool needles = s.leaf_form == LeafForm::needles;
    const bool last = n + 1 == s.leaves;
    const float turn = k_golden * static_cast<float>(n) + 2.4f * static_cast<float>(number) + chance.around(0.4f);
    const float t = (static_cast<float>(n) + 0.5f) / static_cast<float>(s.leaves);
    const float angle = last ? 0.1f : needles ? chance.between(0.35f, 0.7f) : chance.between(0.6f, 1.15f);
    glm::vec3 side = std::cos(turn) * x + std::sin(turn) * y;
    side.y *= needles ? 0.35f : 0.7f; // leaves and sprays spread out more than up and down
    LeafCard card;
    card.along =
        std::cos(angle) * axis + std::sin(angle) * side - glm::vec3(0.0f, 0.6f * s.leaf_droop, 0.0f) + chance.vector(0.12f);
    card.along = glm::normalize(card.along + 1e-3f * axis);
    card.root = cluster.root + axis * (cluster.length * (last ? 1.0f : t));
    // Lies rather flat, its face to the sky, tilted by chance.
    const glm::vec3 face = glm::normalize(glm::vec3(0.0f, 1.0f, 0.0f) + chance.vector(needles ? 0.5f : 0.9f) + 1e-3f * x);
    const glm::vec3 across = glm::cross(face, card.along);
    card.across = glm::length(across) > 1e-3f ? glm::normalize(across) : x;
    const float size = chance.between(0.75f, 1.2f);
    card.length = s.leaf_length * size;
    card.width = s.leaf_width * size * chance.between(0.85f, 1.15f);
    card.chance = chance.around(1.0f);
    card.cluster = number;
    return card;
}

} // namespace

std::vector<LeafCard> leaf_cards(const TreeSettings& s, const shape::Shape& shape) {
    Chance chance(s.seed, 3);
    std::vector<LeafCard> cards;
    cards.reserve(shape.clusters.size() * static_cast<std::size_t>(s.leaves));
    for (std::size_t cluster = 0; cluster < shape.clusters.size(); ++cluster)
        for (int n = 0; n < s.leaves; ++n)
            cards.push_back(card_on(s, shape.clusters[cluster], static_cast<std::uint32_t>(cluster), n, chance));
    return cards;
}

std::vector<std::uint32_t> keeping_order(const std::vector<LeafCard>& cards, std::uint32_t seed) {
    std::vector<std::uint32_t> order(cards.size());
    std::iota(order.begin(), order.end(), 0u);
    Chance chance(seed, 4);
    for (std::size_t n = order.size(); n > 1; --n)
        std::swap(order[n - 1], order[static_cast<std::size_t>(chance.share() * static_cast<float>(n)) % n]);
    std::vector<float> nearest(order.size(), std::numeric_limits<float>::max()); // squared, to those that are chosen
    for (std::size_t chosen = 0; chosen + 1 < std::min(order.size(), k_spread); ++chosen) {
        const glm::vec3 last = cards[order[chosen]].middle();
        std::size_t farthest = chosen + 1;
        for (std::size_t n = chosen + 1; n < order.size(); ++n) {
            const glm::vec3 apart = cards[order[n]].middle() - last;
            nearest[n] = std::min(nearest[n], glm::dot(apart, apart));
            if (nearest[n] > nearest[farthest])
                farthest = n;
        }
        std::swap(order[chosen + 1], order[farthest]);
        std::swap(nearest[chosen + 1], nearest[farthest]);
    }
    return order;
}

std::vector<glm::vec3> homes(const std::vector<LeafCard>& cards, const std::vector<std::uint32_t>& order, std::size_t count) {
    const std::size_t first = std::min(count, order.size());
    std::vector<glm::vec3> sums(first, glm::vec3(0.0f));
    std::vector<float> counts(first, 0.0f);
    for (const LeafCard& card : cards) {
        std::size_t nearest = 0;
        float least = std::numeric_limits<float>::max();
        for (std::size_t n = 0; n < first; ++n) {
            const glm::vec3 apart = cards[order[n]].middle() - card.middle();
            if (glm::dot(apart, apart) < least) {
                least = glm::dot(apart, apart);
                nearest = n;
            }
        }
        sums[nearest] += card.middle();
        counts[nearest] += 1.0f;
    }
    for (std::size_t n = 0; n < first; ++n)
        sums[n] = counts[n] > 0.0f ? sums[n] / counts[n] - cards[order[n]].middle() : glm::vec3(0.0f);
    return sums;
}

} // namespace windrow::vegetation::trees
