// Blocks that together are one block (fluid/solids/wholes.h).
#include "tests/figure.h"
#include "tests/unit/drawn_ground.h"

#include <random>

namespace windrow {
namespace {

using namespace test;

// A block in pieces of one size, around a place.
std::vector<PlacedObstacle> pieces_of(glm::vec3 size, glm::ivec3 pieces, glm::vec3 place,
                                      const glm::mat3& axes = glm::mat3(1.0f)) {
    std::vector<PlacedObstacle> all;
    const glm::vec3 piece = size / glm::vec3(pieces);
    for (int z = 0; z < pieces.z; ++z)
        for (int y = 0; y < pieces.y; ++y)
            for (int x = 0; x < pieces.x; ++x) {
                PlacedObstacle one;
                one.shape = Block{.half_size = 0.5f * piece};
                one.position = place + axes * (piece * (glm::vec3(x, y, z) + 0.5f) - 0.5f * size);
                one.axes = axes;
                one.slot = static_cast<std::uint32_t>(all.size());
                all.push_back(one);
            }
    return all;
}

PlacedObstacle whole_of(glm::vec3 size, glm::vec3 place, const glm::mat3& axes = glm::mat3(1.0f)) {
    return pieces_of(size, glm::ivec3(1), place, axes)[0];
}

// Drawn one by one, two pieces close a third of a face that the block closes whole. Pieces come and go, too.
TEST(Wholes, CloseWhatOneBlockCloses) {
    std::mt19937 chance(11);
    double worst = 0.0, worst_kept = 0.0;
    std::size_t inside = 0, inside_apart = 0;
    for (int n = 0; n < 60; ++n) {
        const auto part = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(chance); };
        glm::vec3 size, place;
        for (int axis = 0; axis < 3; ++axis) { // in this order
            size[axis] = part(0.4f, 9.0f);
            place[axis] = 12.0f + part(0.0f, 1.0f);
        }
        const float angle = n % 2 == 0 ? 0.0f : part(0.0f, 3.0f);
        const glm::mat3 axes(glm::mat3_cast(glm::angleAxis(angle, glm::normalize(glm::vec3(0.2f, 1.0f, 0.1f)))));
        std::vector<PlacedObstacle> pieces = pieces_of(size, {1 + n % 3, 1 + n / 3 % 3, 1 + n / 9 % 4}, place, axes);
        const Drawn whole = drawn_from(std::vector{whole_of(size, place, axes)}), cut = drawn_from(pieces);
        worst = std::max(worst, apart(whole, cut));
        inside += whole.inside.size();
        for (const std::uint32_t cell : whole.inside)
            inside_apart += cut.inside.contains(cell) ? 0 : 1;
        Solids solids(box_of(), box_of().cells.x);
        solids.place(pieces);
        const PlacedObstacle last = pieces.back();
        pieces.pop_back();
        for (PlacedObstacle& piece : pieces)
            piece.position -= glm::vec3(2.0f, 0.0f, -1.0f);
        solids.place(pieces, {2, 0, -1});
        worst_kept = std::max(worst_kept, apart(drawn_by(solids), drawn_from(pieces)));
        pieces.insert(pieces.begin(), last);
        pieces[0].position -= glm::vec3(2.0f, 0.0f, -1.0f);
        solids.place(pieces);
        worst_kept = std::max(worst_kept, apart(drawn_by(solids), drawn_from(pieces)));
    }
    figure("wholes/closed_apart", worst);
    EXPECT_LE(worst, 3e-3); // places are rounded to 1/4096 of a cell
    EXPECT_LE(worst_kept, 3e-3);
    EXPECT_LE(inside_apart, inside / 1000);
}

// A house, a tower, a wall: at cells' faces and beside them, with seams through cells' centres, pieces down to a cell.
TEST(Wholes, HaveTheWindAndTheForceOfOneBlock) {
    struct Case {
        glm::vec3 size;
        glm::ivec3 pieces;
    };
    double worst = 0.0, worst_force = 0.0;
    for (const auto& [size, pieces] :
         {Case{glm::vec3(4.0f), {2, 1, 1}}, Case{glm::vec3(4.0f), {4, 4, 4}}, Case{{6.0f, 3.0f, 6.0f}, {2, 1, 2}},
          Case{{0.6f, 4.0f, 12.0f}, {1, 4, 12}}, Case{glm::vec3(5.0f), {5, 5, 5}}})
        for (const float shift : {0.0f, 0.31f, 0.77f}) {
            const glm::vec3 place = glm::vec3(16.0f, 0.5f * size.y, 14.0f) + shift * glm::vec3(1.0f, 0.0f, 0.7f);
            Wind winds[] = {wind_over({}), wind_over({})};
            std::vector<ObstacleId> ids[2];
            for (int many = 0; many < 2; ++many)
                for (const PlacedObstacle& piece : pieces_of(size, many == 0 ? glm::ivec3(1) : pieces, place)) {
                    const auto id = winds[many].obstacles().add(standing(piece, winds[many].origin()));
                    ASSERT_TRUE(id) << id.error();
                    ids[many].push_back(*id);
                }
            glm::dvec3 force[2] = {};
            for (int many = 0; many < 2; ++many) {
                for (int n = 0; n < 12; ++n)
                    winds[many].step(1.0 / 60.0);
                for (const ObstacleId id : ids[many])
                    force[many] += glm::dvec3(winds[many].force_on(id)->force);
            }
            worst = std::max(worst, largest_apart(winds[0].field(), winds[1].field()) / 6.0);
            worst_force = std::max(worst_force, glm::distance(force[0], force[1]) / glm::length(force[0]));
        }
    figure("wholes/wind_apart", worst);
    figure("wholes/force_apart", worst_force);
    EXPECT_LE(worst, 1e-4);
    EXPECT_LE(worst_force, 1e-4);
}

// A wall through the whole box, whose parts come and go with it.
TEST(Wholes, StayOneBlockWhileTheBoxMoves) {
    const glm::vec3 size(3.4f, 4.0f, 60.0f), place(18.31f, 2.0f, 14.0f);
    Wind winds[] = {wind_over({}), wind_over({})};
    for (int many = 0; many < 2; ++many)
        for (const PlacedObstacle& piece : pieces_of(size, {1, 1, many == 0 ? 1 : 7}, place))
            ASSERT_TRUE(winds[many].obstacles().add(standing(piece, winds[many].origin())));
    const glm::dvec3 middle = winds[0].origin() + 0.5 * glm::dvec3(winds[0].box().size());
    for (int n = 0; n < 40; ++n)
        for (Wind& wind : winds) {
            ASSERT_TRUE(wind.follow(middle + glm::dvec3(0.0, 0.0, 0.3 * n)));
            wind.step(1.0 / 60.0);
        }
    const double apart = largest_apart(winds[0].field(), winds[1].field()) / 6.0;
    figure("wholes/wind_apart_while_the_box_moves", apart);
    EXPECT_LE(apart, 1e-4);
}

} // namespace
} // namespace windrow
