// The export to OpenVDB, read back with OpenVDB: values, places, names and rejections.

#include "fluid/vdb/vdb_export.h"
#include "fluid/wind.h"
#include "tests/unit/vdb_fixture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Interpolation.h>

namespace {

namespace fs = std::filesystem;
using namespace windrow;
using namespace windrow::vdb_test;
using vdb::Problem;

template <class GridType>
typename GridType::Ptr read(const fs::path& file, const std::string& name) {
    openvdb::initialize();
    openvdb::io::File archive(file.string());
    archive.open();
    return openvdb::gridPtrCast<GridType>(archive.readGrid(name));
}

std::vector<std::string> grid_names(const fs::path& file) {
    openvdb::initialize();
    openvdb::io::File archive(file.string());
    archive.open();
    std::vector<std::string> names;
    for (auto name = archive.beginName(); name != archive.endName(); ++name)
        names.push_back(*name);
    return names;
}

bool same_bits(float a, float b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// --- Values ----------------------------------------------------------------------------------------------------------

TEST(VdbExport, VectorsComeBackToTheBit) {
    const OwnFolder folder;
    WindBox air = random_air({13, 9, 21});
    air.field[0] = {-0.0f, std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max(), 0.0f};
    ASSERT_TRUE(vdb::write(air.grid(), folder / "a.vdb"));

    EXPECT_EQ(grid_names(folder / "a.vdb"), std::vector<std::string>{"vel"});
    const auto grid = read<openvdb::Vec3SGrid>(folder / "a.vdb", "vel");
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->getVectorType(), openvdb::VEC_CONTRAVARIANT_RELATIVE);
    EXPECT_EQ(grid->getGridClass(), openvdb::GRID_UNKNOWN);
    EXPECT_FALSE(grid->saveFloatAsHalf());
    EXPECT_EQ(grid->activeVoxelCount(), 13u * 9u * 21u);
    EXPECT_EQ(grid->evalActiveVoxelBoundingBox(), openvdb::CoordBBox({0, 0, 0}, {12, 8, 20}));
    int differing = 0;
    air.for_each([&](int i, int j, int k) {
        const openvdb::Vec3s value = grid->tree().getValue({i, j, k});
        for (int axis = 0; axis < 3; ++axis)
            differing += !same_bits(value[axis], air.at(i, j, k)[axis]);
    });
    EXPECT_EQ(differing, 0);
}

// Rows of a box become voxels as thick as the lowest row, linear in height between them, at their own places.
TEST(VdbExport, RowsBecomeVoxelsOfOneSize) {
    const OwnFolder folder;
    Config config{
        .cells = {6, 10, 5}, .boundaries = Boundaries::open_over_floor(), .centre = {1.0, 7.0, 2.0}, .rows = Rows{.first = 0.5f}};
    config.rows->ratio = 1.3f;
    auto wind = Wind::create(config);
    ASSERT_TRUE(wind) << wind.error();
    wind->set_velocity([](glm::dvec3 x) { return glm::vec3(0.5 * x.y, 1.0, 2.0 * x.x - x.y); });
    ASSERT_TRUE(wind->obstacles().add({.position = {1.0, wind->origin().y + 1.0, 2.0}, .shape = Block{{1.6f, 1.0f, 1.6f}}}));
    (void)wind->step(1e-6);
    for (const vdb::UpAxis up : {vdb::UpAxis::y, vdb::UpAxis::z}) {
        ASSERT_TRUE(vdb::write(vdb::grid_of(*wind), folder / "rows.vdb", {.up = up}));
        const auto grid = read<openvdb::Vec3SGrid>(folder / "rows.vdb", "vel");
        ASSERT_TRUE(grid);
        const auto size = grid->voxelSize();
        const int upward = up == vdb::UpAxis::y ? 1 : 2;
        EXPECT_NEAR(size[upward], 0.5, 1e-6);
        EXPECT_NEAR(size[0], 1.0, 1e-9);
        const double top = wind->view().window().size().y;
        EXPECT_EQ(grid->evalActiveVoxelDim()[upward], static_cast<int>(std::ceil(top / 0.5 - 1e-6)));
        const WindView shown = wind->view(); // a file holds the cells themselves
        const WindView cells(shown.box(), shown.window(), shown.blend_zone(), shown.ambient(), shown.field());
        double worst = 0.0;
        for (auto voxel = grid->cbeginValueOn(); voxel; ++voxel) {
            const auto world = grid->indexToWorld(voxel.getCoord());
            const glm::dvec3 place =
                up == vdb::UpAxis::y ? glm::dvec3(world[0], world[1], world[2]) : glm::dvec3(world[0], world[2], -world[1]);
            const glm::vec3 u = cells.velocity(place);
            const openvdb::Vec3s& v = *voxel;
            const glm::vec3 found = up == vdb::UpAxis::y ? glm::vec3(v[0], v[1], v[2]) : glm::vec3(v[0], v[2], -v[1]);
            worst = std::max(worst, static_cast<double>(glm::length(found - u)));
        }
        EXPECT_LT(worst, 1e-4);
        const auto inside = read<openvdb::FloatGrid>(folder / "rows.vdb", vdb::k_obstacle_grid);
        ASSERT_TRUE(inside);
        double volume = 0.0;
        for (auto voxel = inside->cbeginValueOn(); voxel; ++voxel)
            volume += static_cast<double>(*voxel) * size[0] * size[1] * size[2];
        EXPECT_NEAR(volume, 4.0 * 2.0 * 4.0, 4.0 * 0.5 * 4.0); // of whole cells along x and z
    }
}

TEST(VdbExport, ThreeScalarsComeBackToTheBit) {
    const OwnFolder folder;
    const WindBox air = random_air({10, 8, 5});
    ASSERT_TRUE(vdb::write(air.grid(), folder / "a.vdb", {.name = "velocity", .form = vdb::Form::three_scalars}));

    EXPECT_EQ(grid_names(folder / "a.vdb"), (std::vector<std::string>{"velocity.x", "velocity.y", "velocity.z"}));
    for (int axis = 0; axis < 3; ++axis) {
        const auto grid = read<openvdb::FloatGrid>(folder / "a.vdb", std::string("velocity.") + "xyz"[axis]);
        ASSERT_TRUE(grid);
        EXPECT_EQ(grid->activeVoxelCount(), 10u * 8u * 5u);
        int differing = 0;
        air.for_each([&](int i, int j, int k) {
            differing += !same_bits(grid->tree().getValue({i, j, k}), air.at(i, j, k)[axis]);
        });
        EXPECT_EQ(differing, 0) << "xyz"[axis];
    }
}

TEST(VdbExport, HalfIsWithinItsElevenBits) {
    const OwnFolder folder;
    const WindBox air = random_air({16, 16, 16});
    for (const vdb::Form form : {vdb::Form::one_vector, vdb::Form::three_scalars}) {
        ASSERT_TRUE(vdb::write(air.grid(), folder / "half.vdb", {.form = form, .precision = vdb::Precision::half}));
        double worst = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            openvdb::Vec3SGrid::Ptr vectors;
            openvdb::FloatGrid::Ptr scalars;
            if (form == vdb::Form::one_vector)
                vectors = read<openvdb::Vec3SGrid>(folder / "half.vdb", "vel");
            else
                scalars = read<openvdb::FloatGrid>(folder / "half.vdb", std::string("vel.") + "xyz"[axis]);
            EXPECT_TRUE(vectors ? vectors->saveFloatAsHalf() : scalars->saveFloatAsHalf());
            air.for_each([&](int i, int j, int k) {
                const double value = vectors ? vectors->tree().getValue({i, j, k})[axis] : scalars->tree().getValue({i, j, k});
                const double cell = air.at(i, j, k)[axis];
                worst = std::max(worst, std::abs(value - cell) / std::abs(cell));
            });
        }
        EXPECT_LE(worst, std::ldexp(1.0, -11));
        EXPECT_GT(worst, std::ldexp(1.0, -13)); // Not stored in full behind the reader's back.
    }
    // Half the bytes of the values; random ones do not compress, and the tables around them are the same.
    ASSERT_TRUE(vdb::write(air.grid(), folder / "half.vdb", {.precision = vdb::Precision::half}));
    ASSERT_TRUE(vdb::write(air.grid(), folder / "full.vdb"));
    EXPECT_GT(fs::file_size(folder / "full.vdb"), fs::file_size(folder / "half.vdb") + air.field.size() * 3 * 2 * 9 / 10);
}

TEST(VdbExport, UniformWindKeepsEveryVoxelInALeaf) {
    const OwnFolder folder;
    for (const glm::vec3 wind : {glm::vec3(0.0f), glm::vec3(3.0f, 0.0f, -1.0f)})
        for (const glm::ivec3 cells : {glm::ivec3(32, 16, 32), glm::ivec3(1, 1, 1), glm::ivec3(17, 1, 9)}) {
            const WindBox air = uniform_air(cells, wind);
            vdb::VelocityGrid uniform = air.grid();
            uniform.outside = wind;
            ASSERT_TRUE(vdb::write(uniform, folder / "u.vdb"));
            const auto grid = read<openvdb::Vec3SGrid>(folder / "u.vdb", "vel");
            EXPECT_EQ(grid->activeVoxelCount(), air.field.size());
            EXPECT_EQ(grid->tree().activeLeafVoxelCount(), air.field.size());
            EXPECT_EQ(grid->tree().activeTileCount(), 0u);
            EXPECT_EQ(grid->evalActiveVoxelDim(), openvdb::Coord(cells.x, cells.y, cells.z));
            EXPECT_EQ(grid->background(), openvdb::Vec3s(wind.x, wind.y, wind.z));
        }
}

// --- Places ----------------------------------------------------------------------------------------------------------

TEST(VdbExport, WorldPointsMeetTheirCellsAMillionMetresAway) {
    const OwnFolder folder;
    for (const vdb::UpAxis up : {vdb::UpAxis::y, vdb::UpAxis::z}) {
        WindBox air = uniform_air({11, 7, 18}, glm::vec3(1.0f));
        air.cell_size = 0.3f;
        air.origin = {1e6 + 0.1, -40.7, -1e6 - 0.2};
        ASSERT_TRUE(vdb::write(air.grid(), folder / "far.vdb", {.up = up}));
        const auto grid = read<openvdb::Vec3SGrid>(folder / "far.vdb", "vel");
        EXPECT_EQ(grid->voxelSize(), openvdb::Vec3d(double(0.3f)));
        double worst_cells = 0.0;
        air.for_each([&](int i, int j, int k) {
            const glm::dvec3 p = air.centre(i, j, k);
            const bool y_up = up == vdb::UpAxis::y;
            const openvdb::Vec3d index =
                grid->worldToIndex(y_up ? openvdb::Vec3d(p.x, p.y, p.z) : openvdb::Vec3d(p.x, -p.z, p.y));
            const openvdb::Vec3d cell = y_up ? openvdb::Vec3d(i, j, k) : openvdb::Vec3d(i, 17 - k, j);
            worst_cells = std::max(worst_cells, (index - cell).length());
        });
        EXPECT_LT(worst_cells, 1e-6);
    }
}

TEST(VdbExport, ZUpTurnsPlacesAndVelocitiesAlike) {
    const OwnFolder folder;
    WindBox air = random_air({6, 4, 9});
    air.cell_size = 0.5f;
    air.origin = {10.0, 20.0, 30.0};
    air.field[Box{.cells = air.cells, .boundaries = {}}.index(1, 2, 3)] = {1.0f, 2.0f, 3.0f, 0.0f};
    ASSERT_TRUE(vdb::write(air.grid(), folder / "z.vdb", {.up = vdb::UpAxis::z}));
    const auto grid = read<openvdb::Vec3SGrid>(folder / "z.vdb", "vel");

    // The centre of cell (1, 2, 3) is (10.75, 21.25, 31.75); turned, that is (10.75, -31.75, 21.25), and (1, 2, 3) m/s is (1, -3,
    // 2).
    const openvdb::Vec3s known = openvdb::tools::PointSampler::sample(grid->tree(), grid->worldToIndex({10.75, -31.75, 21.25}));
    EXPECT_EQ(known, openvdb::Vec3s(1.0f, -3.0f, 2.0f));
    EXPECT_EQ(grid->evalActiveVoxelDim(), openvdb::Coord(6, 9, 4));
    EXPECT_GT(grid->transform().baseMap()->determinant(), 0.0);
    int differing = 0;
    air.for_each([&](int i, int j, int k) {
        const glm::dvec3 p = air.centre(i, j, k);
        const glm::vec3 u = air.at(i, j, k);
        const auto value = openvdb::tools::PointSampler::sample(grid->tree(), grid->worldToIndex({p.x, -p.z, p.y}));
        differing += value != openvdb::Vec3s(u.x, -u.z, u.y);
    });
    EXPECT_EQ(differing, 0);
}

// --- Names -----------------------------------------------------------------------------------------------------------

TEST(VdbExport, GridsTellTimeFrameUnitsAndMaker) {
    const OwnFolder folder;
    const WindBox air = uniform_air({8, 8, 8}, glm::vec3(1.0f));
    for (const vdb::Form form : {vdb::Form::one_vector, vdb::Form::three_scalars}) {
        ASSERT_TRUE(vdb::write(air.grid(), folder / "m.vdb", {.form = form, .up = vdb::UpAxis::z, .time = 1.5, .frame = 36}));
        for (const std::string& name : grid_names(folder / "m.vdb")) {
            openvdb::io::File archive((folder / "m.vdb").string());
            archive.open();
            const auto grid = archive.readGrid(name);
            EXPECT_EQ(grid->metaValue<double>("windrow_time"), 1.5);
            EXPECT_EQ(grid->metaValue<openvdb::Int32>("windrow_frame"), 36);
            EXPECT_EQ(grid->metaValue<std::string>("windrow_units"), "velocity m/s, length m, time s");
            EXPECT_EQ(grid->metaValue<std::string>("windrow_up_axis"), "z");
            EXPECT_EQ(grid->getCreator().substr(0, 7), "windrow");
            // What readers list without loading the voxels.
            EXPECT_EQ(grid->metaValue<openvdb::Int64>("file_voxel_count"), 512);
        }
    }
}

TEST(VdbExport, AReaderCanListGridsWithoutLoadingThem) {
    const OwnFolder folder;
    ASSERT_TRUE(vdb::write(uniform_air({8, 8, 8}, glm::vec3(1.0f)).grid(), folder / "a.vdb"));
    openvdb::initialize();
    openvdb::io::File archive((folder / "a.vdb").string());
    archive.open();
    EXPECT_TRUE(archive.readGridMetadata("vel"));
    EXPECT_TRUE(archive.hasBloscCompression());
    EXPECT_EQ(text_of(folder / "a.vdb")[20], 1); // The header's flag that a table of grids follows.
}

TEST(VdbExport, SequenceOfTenFrames) {
    const OwnFolder folder;
    const vdb::Sequence sequence{.folder = folder.path(), .prefix = "wind_", .options = {.name = "v"}};
    for (int frame = 1; frame <= 10; ++frame) {
        const WindBox air = uniform_air({9, 5, 7}, glm::vec3(float(frame), 0.0f, 0.0f));
        ASSERT_TRUE(sequence.write(air.grid(), frame, frame / 24.0));
    }
    EXPECT_EQ(folder.entries(), 10);
    for (int frame = 1; frame <= 10; ++frame) {
        const fs::path file = folder / ((frame < 10 ? "wind_000" : "wind_00") + std::to_string(frame) + ".vdb");
        EXPECT_EQ(file, sequence.path(frame));
        const auto grid = read<openvdb::Vec3SGrid>(file, "v");
        EXPECT_EQ(grid->tree().getValue({4, 2, 3}), openvdb::Vec3s(float(frame), 0.0f, 0.0f));
        EXPECT_EQ(grid->metaValue<openvdb::Int32>("windrow_frame"), frame);
        EXPECT_EQ(grid->metaValue<double>("windrow_time"), frame / 24.0);
    }
}

TEST(VdbExport, SequenceRejectsNamesThatReadersCannotCount) {
    const OwnFolder folder;
    const WindBox air = uniform_air({2, 2, 2}, glm::vec3(0.0f));
    const auto rejection = [&](const vdb::Sequence& sequence, int frame) {
        const vdb::WriteResult written = sequence.write(air.grid(), frame, 0.0);
        EXPECT_EQ(written.problem(), Problem::rejected);
        return written.error();
    };
    EXPECT_NE(rejection({.folder = folder.path()}, -1).find("frame is -1"), std::string::npos);
    EXPECT_NE(rejection({.folder = folder.path(), .digits = 0}, 1).find("digits is 0"), std::string::npos);
    EXPECT_NE(rejection({.folder = folder.path(), .prefix = "fan2"}, 1).find("prefix is \"fan2\""), std::string::npos);
    EXPECT_NE(rejection({.folder = folder.path(), .prefix = "a/b_"}, 1).find("prefix is \"a/b_\""), std::string::npos);
    EXPECT_EQ(folder.entries(), 0);
}

// --- Rejections --------------------------------------------------------------------------------------------------------

TEST(VdbExport, RejectionsNameTheFieldAndLeaveNothing) {
    const OwnFolder folder;
    const WindBox air = uniform_air({4, 3, 2}, glm::vec3(1.0f));
    const float infinity = std::numeric_limits<float>::infinity();
    const auto expect = [&](const char* part, auto change) {
        WindBox changed = air;
        vdb::Options options;
        vdb::VelocityGrid grid = changed.grid();
        change(grid, options, changed.field);
        const vdb::WriteResult written = vdb::write(grid, folder / "a.vdb", options);
        EXPECT_EQ(written.problem(), Problem::rejected) << part;
        EXPECT_NE(written.error().find(part), std::string::npos) << written.error();
        EXPECT_EQ(folder.entries(), 0);
    };
    using Grid = vdb::VelocityGrid;
    using Field = std::vector<glm::vec4>;
    expect("name is \"\"", [](Grid&, vdb::Options& options, Field&) { options.name = ""; });
    expect("name is \"a/b\"", [](Grid&, vdb::Options& options, Field&) { options.name = "a/b"; });
    expect("time is nan", [](Grid&, vdb::Options& options, Field&) { options.time = std::nan(""); });
    expect("origin is (inf, 0, 0)", [&](Grid& grid, vdb::Options&, Field&) { grid.origin.x = infinity; });
    expect("outside is", [&](Grid& grid, vdb::Options&, Field&) { grid.outside.z = infinity; });
    expect("cell_size is 0", [](Grid& grid, vdb::Options&, Field&) { grid.cell_size = 0.0f; });
    expect("cells is (4, 0, 2)", [](Grid& grid, vdb::Options&, Field&) { grid.cells.y = 0; });
    expect("field holds 24 values and cells is (4, 3, 3), 36 in all",
           [](Grid& grid, vdb::Options&, Field&) { grid.cells.z = 3; });
    expect("in 2 cells, the first (1, 2, 0)", [&](Grid&, vdb::Options&, Field& field) {
        field[9].y = infinity;
        field[23].x = std::nanf("");
    });
    expect("precision is half and the wind reaches 70000 m/s", [](Grid&, vdb::Options& options, Field& field) {
        options.precision = vdb::Precision::half;
        field[5].z = -70000.0f;
    });

    WindBox nothing_right = air;
    vdb::VelocityGrid grid = nothing_right.grid();
    grid.cell_size = -1.0f;
    const std::string reasons = vdb::write(grid, "", {.name = "", .time = infinity}).error();
    EXPECT_EQ(std::count(reasons.begin(), reasons.end(), '\n'), 3) << reasons;
}

// --- Obstacles -------------------------------------------------------------------------------------------------------

TEST(VdbExport, MarksTheCellsInsideObstacles) {
    const OwnFolder folder;
    auto wind = Wind::create({.cells = {12, 8, 10}, .centre = {6.0, 4.0, 5.0}, .ambient = {2.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(wind);
    (void)wind->step(0.05);
    const auto written = [&](const std::string& name, const vdb::Options& options) {
        EXPECT_TRUE(vdb::write(vdb::grid_of(*wind), folder / name, options));
        return folder / name;
    };
    EXPECT_EQ(grid_names(written("none.vdb", {})), std::vector<std::string>{"vel"});
    ASSERT_TRUE(wind->obstacles().add({.position = {100.0, 0.0, 0.0}}));
    ASSERT_TRUE(wind->obstacles().add({.position = {2.3, 4.0, 5.0}, .shape = Plate{}}));
    (void)wind->step(0.05);
    EXPECT_EQ(grid_names(written("far.vdb", {})), std::vector<std::string>{"vel"}) << "a plate has no inside";

    const ObstacleId house = *wind->obstacles().add({.position = {5.0, 2.0, 4.0}, .shape = Block{{2.0f, 1.0f, 3.0f}}});
    (void)wind->step(0.05);
    const auto inside = [](int i, int j, int k) { return i >= 3 && i < 7 && j >= 1 && j < 3 && k >= 1 && k < 7; };
    for (const vdb::UpAxis up : {vdb::UpAxis::y, vdb::UpAxis::z})
        for (const vdb::Form form : {vdb::Form::one_vector, vdb::Form::three_scalars}) {
            const fs::path file = written("house.vdb", {.form = form, .up = up});
            EXPECT_EQ(grid_names(file).size(), form == vdb::Form::one_vector ? 2u : 4u);
            const auto grid = read<openvdb::FloatGrid>(file, "obstacle");
            ASSERT_TRUE(grid);
            EXPECT_EQ(grid->activeVoxelCount(), 12u * 8u * 10u);
            EXPECT_EQ(grid->background(), 0.0f);
            int wrong = 0;
            for (int k = 0; k < 10; ++k)
                for (int j = 0; j < 8; ++j)
                    for (int i = 0; i < 12; ++i) {
                        const openvdb::Coord voxel = up == vdb::UpAxis::y ? openvdb::Coord(i, j, k) : openvdb::Coord(i, 9 - k, j);
                        wrong += grid->tree().getValue(voxel) != (inside(i, j, k) ? 1.0f : 0.0f);
                    }
            EXPECT_EQ(wrong, 0);
        }
    ASSERT_TRUE(wind->follow({7.0, 4.0, 5.0})); // the cells move with the box, before the next step too
    EXPECT_EQ(read<openvdb::FloatGrid>(written("moved.vdb", {}), "obstacle")->tree().getValue({1, 1, 1}), 0.0f);
    EXPECT_EQ(read<openvdb::FloatGrid>(written("moved.vdb", {}), "obstacle")->tree().getValue({2, 1, 1}), 1.0f);
    ASSERT_TRUE(wind->obstacles().remove(house));
    (void)wind->step(0.05);
    EXPECT_EQ(grid_names(written("gone.vdb", {})), std::vector<std::string>{"vel"});
}

TEST(VdbExport, RejectsAMaskThatIsNone) {
    const OwnFolder folder;
    const WindBox air = uniform_air({2, 2, 2}, {1.0f, 0.0f, 0.0f});
    vdb::VelocityGrid grid = air.grid();
    grid.obstacle = {1.0f, 0.0f};
    EXPECT_EQ(vdb::write(grid, folder / "a.vdb").error(), "obstacle holds 2 values and field 8: give as many, or none.");
    grid.obstacle.assign(8, 2.0f);
    EXPECT_EQ(vdb::write(grid, folder / "a.vdb").error(),
              "obstacle holds values beyond 0 to 1: give 1 inside obstacles and 0 in the air.");
    EXPECT_EQ(vdb::write(air.grid(), folder / "a.vdb", {.name = "obstacle"}).error(),
              "name is \"obstacle\", the grid of the cells inside obstacles: give another, such as vel.");
}

} // namespace
