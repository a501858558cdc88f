// What a run writes of a scene with bodies, read back with OpenVDB itself: the first file too.
#include "cli/console.h"
#include "fluid/vdb/vdb_export.h"
#include "tests/unit/command_outcome.h"

#include <fstream>
#include <gtest/gtest.h>
#include <openvdb/openvdb.h>

namespace windrow::cli {
namespace {

class VdbFramesTest : public test::FolderTest {
  protected:
    /// Runs a village of one house and a hill in a wind of 6 m/s.
    void run(std::vector<const char*> more) {
        openvdb::initialize();
        std::ofstream(folder / "house.json") << R"({"frames_per_second": 10,
            "air": {"cells": [20, 8, 16], "ambient": [6, 0, 0], "boundaries": {"y_low": "free_slip"}},
            "obstacles": [{"position": [0, 2, 0], "shape": {"block": {"half_size": [2, 2, 3]}}}],
            "picture": {"ground": {"in_air": true, "corner": [-20, -8, -20], "extent": [40, 40], "hills": {"height": 10, "length": 12}}}})";
        scene_ = in("house.json");
        out_ = in("out");
        more.insert(more.begin(), {scene_.c_str(), "--vdb", "--frames", "3", "--out", out_.c_str()});
        const CommandOutcome outcome = run_windrow("run", more);
        ASSERT_EQ(outcome.code, k_exit_well) << outcome.err;
    }
    template <class Grid>
    [[nodiscard]] typename Grid::Ptr read(int frame, const char* name) const {
        openvdb::io::File file((folder / "out" / ("vel_000" + std::to_string(frame) + ".vdb")).string());
        file.open();
        return file.hasGrid(name) ? openvdb::gridPtrCast<Grid>(file.readGrid(name)) : nullptr;
    }
    /// The value of the voxel around a place of the world.
    template <class Pointer>
    [[nodiscard]] static auto at(const Pointer& grid, openvdb::Vec3d place) {
        return grid->tree().getValue(grid->transform().worldToIndexCellCentered(place));
    }
    void expect_still_bodies(int frame) const {
        const auto inside = read<openvdb::FloatGrid>(frame, vdb::k_obstacle_grid);
        const auto air = read<openvdb::Vec3SGrid>(frame, "vel");
        ASSERT_TRUE(inside && air) << frame;
        int cells = 0, blown = 0;
        for (auto voxel = air->cbeginValueOn(); voxel; ++voxel) {
            const bool body = inside->tree().getValue(voxel.getCoord()) > 0.0f;
            cells += body ? 1 : 0;
            blown += body && voxel.getValue().length() > 0.0f ? 1 : 0;
        }
        EXPECT_GT(cells, 96) << "the house, and hills";
        EXPECT_EQ(blown, 0) << "frame " << frame;
    }

  private:
    std::string scene_, out_;
};

TEST_F(VdbFramesTest, EachFileHasTheObstaclesAndNoneIsBlownThrough) {
    run({});
    for (int frame = 0; frame < 3; ++frame)
        expect_still_bodies(frame);
    EXPECT_FLOAT_EQ(at(read<openvdb::Vec3SGrid>(0, "vel"), {-8.5, 6.5, 7.5}).x(), 6.0f) << "the air beside is the wind";
}

#if WINDROW_WITH_VULKAN
TEST_F(VdbFramesTest, OfADeviceToo) {
    run({"--backend", "vulkan"});
    for (int frame = 0; frame < 3; ++frame)
        expect_still_bodies(frame);
}
#endif

TEST_F(VdbFramesTest, FirstFileOfARegionToo) {
    run({"--grids", "speed,divergence"});
    const auto inside = read<openvdb::FloatGrid>(0, vdb::k_obstacle_grid), speed = read<openvdb::FloatGrid>(0, "speed");
    ASSERT_TRUE(inside && speed);
    EXPECT_EQ(at(inside, {0.5, 2.5, 0.5}), 1.0f);
    EXPECT_EQ(at(speed, {0.5, 2.5, 0.5}), 0.0f);
    EXPECT_FLOAT_EQ(at(speed, {-8.5, 6.5, 7.5}), 6.0f);
}

} // namespace
} // namespace windrow::cli
