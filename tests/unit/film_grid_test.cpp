// A file that covers more than the box: the wind of velocity() everywhere, and grids to look at.
#include "fluid/vdb/film_grid.h"
#include "fluid/wind.h"
#include "tests/figure.h"
#include "tests/unit/vdb_fixture.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Interpolation.h>
#if __has_include(<nanovdb/util/IO.h>)
#include <nanovdb/util/GridChecksum.h>
#include <nanovdb/util/GridValidator.h>
#include <nanovdb/util/IO.h>
#endif

namespace {

namespace fs = std::filesystem;
using namespace windrow;
using namespace windrow::vdb_test;

template <class GridType>
typename GridType::Ptr read_grid(const fs::path& file, const std::string& name) {
    openvdb::initialize();
    openvdb::io::File archive(file.string());
    archive.open();
    return openvdb::gridPtrCast<GridType>(archive.readGrid(name));
}

Wind windy(const Config& config) {
    auto wind = Wind::create(config);
    EXPECT_TRUE(wind) << wind.error();
    EXPECT_TRUE(wind->motors().add(
        DirectionalMotor{.position = {0.0, 2.0, 0.0}, .region = Sphere{.radius = 2.0f}, .law = Drive{.speed = 9.0f}}));
    for (int n = 0; n < 20; ++n)
        (void)wind->step(1.0 / 60.0);
    return *std::move(wind);
}

Config box_of(std::optional<LogProfile> profile, float gusts) {
    return {.cells = {16, 8, 12},
            .boundaries = Boundaries::open_over_floor(),
            .centre = {0.0, 4.0, 0.0},
            .ambient = {3.0f, 0.0f, 1.0f},
            .profile = profile,
            .gusts = {.intensity = gusts, .length = 24.0f}};
}

glm::vec3 trilinear(const openvdb::Vec3SGrid& grid, glm::dvec3 p) {
    const auto v = openvdb::tools::BoxSampler::sample(grid.tree(), grid.worldToIndex({p.x, p.y, p.z}));
    return {v[0], v[1], v[2]};
}

bool within(const Wind& wind, glm::dvec3 p, double margin) {
    const glm::dvec3 low = wind.origin() - margin, high = wind.origin() + wind.view().window().size() + margin;
    return p.x > low.x && p.y > low.y && p.z > low.z && p.x < high.x && p.y < high.y && p.z < high.z;
}

// The largest difference of the file from velocity() at 1,000 points of the region outside of the box, over the mean wind. A point
// is at least half a voxel within the region, where a read meets voxels alone, `least` [m] above the floor and `skin` off the box.
double apart_outside(const Wind& wind, double margin, float voxel, double least, bool at_centres, double skin = 0.0) {
    const OwnFolder folder;
    const vdb::Region region = vdb::region_around(wind.view(), margin, voxel);
    const auto film = vdb::film_grid(wind.view(), {.region = region});
    EXPECT_TRUE(film);
    EXPECT_TRUE(vdb::write(film->grid, folder / "film.vdb"));
    const auto grid = read_grid<openvdb::Vec3SGrid>(folder / "film.vdb", "vel");
    std::mt19937 random(11);
    const glm::dvec3 low = region.low + 0.5 * double(voxel), high = region.high - 0.5 * double(voxel);
    double apart = 0.0;
    for (int points = 0; points < 1000;) {
        glm::dvec3 p;
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = std::uniform_real_distribution<double>(low[axis], high[axis])(random);
        if (at_centres) {
            const auto c = grid->indexToWorld(openvdb::Coord::round(grid->worldToIndex({p.x, p.y, p.z})));
            p = {c[0], c[1], c[2]};
        }
        if (within(wind, p, skin) || p.y < wind.origin().y + least)
            continue;
        ++points;
        apart = std::max(apart, double(glm::length(trilinear(*grid, p) - wind.velocity(p))));
    }
    return apart / double(glm::length(wind.ambient()));
}

TEST(FilmGrid, OutsideOfTheBoxItHoldsTheAmbientWind) {
    const Wind uniform = windy(box_of({}, 0.0f)), profile = windy(box_of(LogProfile{}, 0.0f)),
               gusty = windy(box_of(LogProfile{}, 0.3f));
    // At voxels nothing is left but the rounding of floats and of places.
    for (const Wind* wind : {&uniform, &profile, &gusty})
        WINDROW_EXPECT_FIGURE("film_grid/at_voxels", apart_outside(*wind, 8.0, 1.0f, 0.0, true), 2e-6);
    // Within a cell of the box the wind of the box fades to ambient in a straight line. A read across its ends is off by a quarter of
    // the change of a voxel: of what the air at the border differs from ambient, most at the roof, which no blend zone ends.
    constexpr double k_faded = 1.5;
    WINDROW_EXPECT_FIGURE("film_grid/uniform", apart_outside(uniform, 8.0, 1.0f, 0.0, false, k_faded), 1e-6);
    float border = 0.0f;
    for (int i = 0; i < 16; ++i)
        for (int k = 0; k < 12; ++k)
            border = std::max(border, glm::length(glm::vec3(uniform.field()[uniform.box().index(i, 7, k)]) - uniform.ambient()));
    WINDROW_EXPECT_FIGURE("film_grid/uniform/beside_the_box", apart_outside(uniform, 8.0, 1.0f, 0.0, false),
                          0.25 * double(border) / double(glm::length(uniform.ambient())) + 1e-6);
    // Between voxels h^2 u'' / 8 of a log profile is h^2 / (8 z^2 ln(10 m / z0)): 1e-3 at 1.5 m for voxels of 0.25 m is 6e-4.
    WINDROW_EXPECT_FIGURE("film_grid/profile/voxels_of_0.25_m/above_1.5_m",
                          apart_outside(profile, 4.0, 0.25f, 1.5, false, k_faded), 1e-3);
    test::figure("film_grid/profile/voxels_of_1_m/above_1.5_m", apart_outside(profile, 8.0, 1.0f, 1.5, false, k_faded));
    // Gusts are linear between texels of 2 m: the error is that of a kink, of first order or better.
    const double coarse = test::figure("film_grid/gusts/voxels_of_1_m", apart_outside(gusty, 8.0, 1.0f, 2.0, false, k_faded));
    const double fine = test::figure("film_grid/gusts/voxels_of_0.25_m", apart_outside(gusty, 4.0, 0.25f, 2.0, false, k_faded));
    EXPECT_LT(fine, coarse / 2.0);
}

TEST(FilmGrid, NothingJumpsAtTheBox) {
    const Wind wind = windy(box_of(LogProfile{}, 0.3f));
    const auto film = vdb::film_grid(wind.view(), {.region = vdb::region_around(wind.view(), 5.0)});
    ASSERT_TRUE(film);
    const glm::ivec3 cells = film->grid.cells;
    EXPECT_EQ(cells, glm::ivec3(26, 13, 22)) << "no margin below the floor";
    EXPECT_EQ(film->grid.origin, wind.origin() - glm::dvec3(5.0, 0.0, 5.0));
    const auto at = [&](int i, int j, int k) {
        return glm::vec3(film->velocity[Box{.cells = cells, .boundaries = {}}.index(i, j, k)]);
    };
    // In the middle of the box its cells, which the blend zone does not touch.
    for (int i = 6; i < 10; ++i)
        EXPECT_LT(glm::length(at(i + 5, 2, 11) - glm::vec3(wind.field()[wind.box().index(i, 2, 6)])), 1e-5f);
    // Across the side of the box the wind changes no more than the fastest change between two cells of ambient wind and blend.
    for (int j = 0; j < 8; ++j)
        for (int k = 8; k < 14; ++k) {
            const glm::vec3 outermost = at(20, j, k), outside = at(21, j, k);
            const glm::vec3 change = wind.velocity({8.5, j + 0.5, k - 10.5}) - wind.velocity({7.5, j + 0.5, k - 10.5});
            EXPECT_LT(glm::length(outside - outermost - change), 1e-5f);
            EXPECT_LT(glm::length(change), 0.5f);
        }
}

// A rigid turn about a slanted axis has the vorticity of twice its rate everywhere.
TEST(FilmGrid, VorticityIsTheCurl) {
    auto wind = Wind::create({.cells = {16, 12, 14}, .cell_size = 0.5f, .blend_width = 0.0f});
    ASSERT_TRUE(wind);
    const glm::dvec3 spin(0.3, -0.7, 1.1);
    wind->set_velocity([&](glm::dvec3 x) { return glm::vec3(glm::cross(spin, x)); });
    const OwnFolder folder;
    for (const vdb::UpAxis up : {vdb::UpAxis::y, vdb::UpAxis::z}) {
        const glm::dvec3 middle(0.0), size(1.5);
        const auto film =
            vdb::film_grid(wind->view(), {.region = vdb::Region{.low = middle - size, .high = middle + size, .voxel_size = 0.5f},
                                          .speed = true,
                                          .vorticity = true});
        ASSERT_TRUE(film) << film.error();
        ASSERT_TRUE(vdb::write(film->grid, folder / "spin.vdb", {.up = up}));
        const auto vorticity = read_grid<openvdb::Vec3SGrid>(folder / "spin.vdb", "vorticity");
        const glm::dvec3 wanted = 2.0 * (up == vdb::UpAxis::y ? spin : glm::dvec3(spin.x, -spin.z, spin.y));
        EXPECT_EQ(vorticity->activeVoxelCount(), 216u);
        for (auto voxel = vorticity->cbeginValueOn(); voxel; ++voxel)
            EXPECT_LT(glm::length(glm::dvec3((*voxel)[0], (*voxel)[1], (*voxel)[2]) - wanted), 1e-4);
        const auto speed = read_grid<openvdb::FloatGrid>(folder / "spin.vdb", "speed");
        const auto velocity = read_grid<openvdb::Vec3SGrid>(folder / "spin.vdb", "vel");
        for (auto voxel = speed->cbeginValueOn(); voxel; ++voxel)
            EXPECT_NEAR(*voxel, velocity->tree().getValue(voxel.getCoord()).length(), 1e-5);
        EXPECT_EQ(vorticity->metaValue<std::string>("windrow_units"), "vorticity 1/s, length m, time s");
        EXPECT_EQ(speed->metaValue<std::string>("windrow_units"), "speed m/s, length m, time s");
    }
}

TEST(FilmGrid, ScalarsOfCellsComeToTheirPlaces) {
    const Wind wind = windy(box_of({}, 0.0f));
    std::vector<float> ramp(wind.box().cell_count()), inside(ramp.size(), 0.0f);
    for (int k = 0; k < 12; ++k)
        for (int j = 0; j < 8; ++j)
            for (int i = 0; i < 16; ++i)
                ramp[wind.box().index(i, j, k)] = static_cast<float>(i + 10 * j + 100 * k);
    inside[wind.box().index(5, 0, 3)] = 1.0f;
    const std::vector<vdb::CellScalar> scalars{{"density", "1", ramp}};
    const OwnFolder folder;
    const auto film =
        vdb::film_grid(wind.view(), {.region = vdb::region_around(wind.view(), 3.0), .obstacle = inside, .scalars = scalars});
    ASSERT_TRUE(film);
    ASSERT_TRUE(vdb::write(film->grid, folder / "a.vdb", {.form = vdb::Form::three_scalars, .up = vdb::UpAxis::z}));
    const auto density = read_grid<openvdb::FloatGrid>(folder / "a.vdb", "density"),
               body = read_grid<openvdb::FloatGrid>(folder / "a.vdb", "obstacle");
    // The centre of cell (8, 3, 6) is (0.5, 3.5, 0.5), turned (0.5, -0.5, 3.5).
    EXPECT_NEAR(openvdb::tools::PointSampler::sample(density->tree(), density->worldToIndex({0.5, -0.5, 3.5})), 638.0f, 1e-3f);
    EXPECT_EQ(openvdb::tools::PointSampler::sample(density->tree(), density->worldToIndex({-10.5, -0.5, 3.5})), 0.0f);
    EXPECT_EQ(openvdb::tools::PointSampler::sample(body->tree(), body->worldToIndex({-2.5, 2.5, 0.5})), 1.0f);
    double volume = 0.0;
    for (auto voxel = body->cbeginValueOn(); voxel; ++voxel)
        volume += static_cast<double>(*voxel);
    EXPECT_EQ(volume, 1.0);
}

// Beyond the cells a reader finds one value: that of the middle's height, not that of 10 m.
TEST(FilmGrid, TheBackgroundIsTheWindOfTheMiddle) {
    const Wind wind = windy(box_of(LogProfile{}, 0.3f));
    const vdb::VelocityGrid cells = vdb::grid_of(wind);
    const float wanted = std::log((4.0f + 0.03f) / 0.03f) / std::log((10.0f + 0.03f) / 0.03f);
    EXPECT_NEAR(cells.outside.x / 3.0f, wanted, 1e-5f);
    EXPECT_NEAR(cells.outside.z, wanted, 1e-5f);
}

TEST(FilmGrid, RejectionsNameWhatIsWrong) {
    const Wind wind = windy(box_of({}, 0.0f));
    const std::vector<float> few(3);
    const std::vector<vdb::CellScalar> scalars{{"density", "1", few}};
    const auto reason = [&](const vdb::FilmSettings& settings) {
        const auto film = vdb::film_grid(wind.view(), settings);
        EXPECT_FALSE(film);
        return film ? std::string() : film.error();
    };
    EXPECT_NE(reason({.region = vdb::Region{.low = {1, 1, 1}, .high = {1, 2, 2}}}).find("give a low corner"), std::string::npos);
    EXPECT_NE(reason({.region = vdb::region_around(wind.view(), 4000.0)}).find("voxels along x"), std::string::npos);
    EXPECT_NE(reason({.region = vdb::Region{.low = {0, 0, 0}, .high = {1, 2, 2}, .voxel_size = -1.0f}}).find("voxel_size is -1"),
              std::string::npos);
    EXPECT_NE(reason({.scalars = scalars}).find("density holds 3 values"), std::string::npos);
    const OwnFolder folder;
    auto film = *vdb::film_grid(wind.view(), {.speed = true});
    film.grid.scalars[0].name = "vel";
    EXPECT_NE(vdb::write(film.grid, folder / "a.vdb").error().find("two grids are named \"vel\""), std::string::npos);
    film.grid.scalars[0].name = "speed";
    film.scalars[0][7] = std::nanf("");
    EXPECT_NE(vdb::write(film.grid, folder / "a.vdb").error().find("speed holds NaN"), std::string::npos);
    EXPECT_EQ(folder.entries(), 0);
}

#if __has_include(<nanovdb/util/IO.h>)
TEST(FilmGrid, NanoVdbHoldsTheSame) {
    ASSERT_TRUE(vdb::has_nanovdb());
    const OwnFolder folder;
    const WindBox air = random_air({20, 9, 13});
    std::vector<float> speed;
    for (const glm::vec4& u : air.field)
        speed.push_back(glm::length(glm::vec3(u)));
    vdb::VelocityGrid grid = air.grid();
    grid.origin = {100.0, 2.0, -3.0};
    grid.scalars.push_back({"speed", "m/s", speed, 0.0f});
    const vdb::Sequence sequence{.folder = folder.path(), .options = {.format = vdb::Format::nanovdb}};
    ASSERT_TRUE(sequence.write(grid, 7, 1.0));
    EXPECT_EQ(folder.entries(), 1);
    const auto handles = nanovdb::io::readGrids((folder / "wind_0007.nvdb").string());
    ASSERT_EQ(handles.size(), 2u);
    const auto* const vectors = handles[0].grid<nanovdb::Vec3f>();
    const auto* const floats = handles[1].grid<float>();
    ASSERT_TRUE(vectors != nullptr && floats != nullptr);
    EXPECT_TRUE(nanovdb::isValid(*vectors));
    EXPECT_TRUE(nanovdb::isValid(*floats));
    EXPECT_STREQ(vectors->gridName(), "vel");
    EXPECT_EQ(vectors->activeVoxelCount(), air.field.size());
    int differing = 0;
    const auto velocity = vectors->getAccessor();
    const auto number = floats->getAccessor();
    air.for_each([&](int i, int j, int k) {
        const nanovdb::Vec3f v = velocity.getValue({i, j, k});
        const glm::vec3 u = air.at(i, j, k);
        differing += v[0] != u.x || v[1] != u.y || v[2] != u.z || number.getValue({i, j, k}) != glm::length(u);
    });
    EXPECT_EQ(differing, 0);
    const auto centre = vectors->indexToWorld(nanovdb::Vec3d(0.0, 0.0, 0.0));
    EXPECT_NEAR(centre[0], 100.5, 1e-12);
    // An old file stays where the new one cannot be written whole.
    const std::string before = text_of(folder / "wind_0007.nvdb");
    const test::FileSizeLimit limit(before.size() / 2);
    EXPECT_EQ(sequence.write(grid, 7, 1.0).problem(), vdb::Problem::disk_full);
    EXPECT_EQ(text_of(folder / "wind_0007.nvdb"), before);
}
#endif

} // namespace
