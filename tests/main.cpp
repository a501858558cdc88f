// The main function of each program of tests. Without --gtest_filter a program runs what `./dev test` is for: no test whose name
// begins with Long, none of k_left_to_all, and under AddressSanitizer none of k_slow_under_asan, unless WINDROW_TIER is all.
#include "tests/tier.h"

#include <cstdio>
#include <gtest/gtest.h>
#include <string>

namespace {

// Tests of some seconds. What stays is behind each: the same code in a smaller form, or on another scene.
constexpr const char* k_left_to_all[] = {
    "BodiesThatMove.APropellerTurns*:*ThinWalls.PushWhatTheySweep/mesh",  // its moment, what is counted; the other shapes
    "*OfTheCpu/fast_air_in_small_cells:WindParity.UnevenSteps*",          // WindCalls.ManySubSteps; WindStories, Forces
    "WindStorms.PartNoFaster*",                                           // WindStorms.AgreeTickByTick
    "WindObstacles.AVentAndAFan*:WindObstacles.AWalkAlongFences*",        // block_beside_drives, random_0; tiles, AWalkOverHills
    "Scenes/FrameRate.*/gusts_fan:FrameRateOfASlideShow.*",               // GrassSwing, FrameRateUntouched; Golden at 6 fps
    "*PictureBackends.*/fur_ball:*PictureBackends.*/grove",               // that of the fan in gusts
    "*AirBackends.*/wolf:*AirBackends.*/wake:*AirBackends.*/meadow",      // that of the train
    "*Repeat.*/grove:*Repeat.*/steady_trail:*Repeat.*/far_hills",         // those of the fan and of the slice
    "CoatGaps.TheWalkBetweenLayersClosesTheS*:CoatCost.FragmentsAPixel*", // the same walk: gaps of a plane, the order of layers
    "Terrain.AWalkOfAKilometre*",                                         // Terrain.IsTheSame*, WindObstacles.AWalkOverHills
    "WindBarriers.*AmongObstacles",                                       // WindBarriers.EachIsMissedWhereItIsLeftOut
    "StrandsOutside.OfTheBunny",                                          // StrandsOutside.NoTuftJumps
};

// Tests of four seconds and more. Shorter ones run the same code, one or two of each of these kinds.
constexpr const char* k_slow_under_asan[] = {
    "*32x16x32*:*GainNoEnergyByThemselves*:*TenThousandSteps*:*FiveMinutes*:*OfAThousandMetresASecond*",
    "Replay.OfARandom*:Bits.*:WindowLarge.*:WindBarriers.*:WindStorms.*:HardCases.*:OpposedMotors.*:AirParity.*",
    "Checkerboard.*:RandomStories.*:UnevenSteps.*:MotorOrder.*:Shelter.*:GroundWalkers.WhoStops*",
    "GroundWalkers.InACrowd*:WindSubsteps.ATickRecords*:WindSubsteps.Obstacles*:WindBoxes.OfTheDefault*",
    "Rooms.WallsAlone*:Rooms.KeepTheAir*:ObstacleStability.Plates*:ObstacleStability.BodiesOfEvery*",
    "ObstacleStability.Hills*:QueryList.ThePlaceInTheTile*:Sleep.WakingEquals*:Sleep.FollowsAndIsSampled*",
    "Sleep.TheStepThatFalls*:Sleep.CostsNextToNothing:RequiredMemory.IsThat*:WindChanges.AWindThatIsCut*",
    "MotorKinds.Widening*:MotorKinds.FollowTheirClosed*:Ticks.ThirtyTicks*:WindStories.OfAirThatNeverSleeps",
    "*OfTheCpu/*_rests:*OfTheCpu/*_moves:*OfTheCpu/*_turns:*OfTheCpu/thin_wall*",
    "*OfTheCpu/random_2*:*OfTheCpu/random_3*:*OfTheCpu/random_4*:*OfTheCpu/random_5*:*OfTheCpu/random_6*",
    "*OfTheCpu/random_7*:*OfTheCpu/random_8*:*OfTheCpu/random_9*",
    "SceneCost.TextThatIs*:SceneCost.ManyNames*:Schema.ReaderTakesEvery*:MotorRejection.WhatIsTaken*:Query.IsContinuous*:"
    "GustTile.Stands*",
    "Sleep.NothingThatIsSeen*:WindStories.OfAirThatSleeps:GroundRecovery.TrailFades*:GroundRecovery.NothingIsLeft*",
    "Window.AMillionMetres*",
    "TiledGround.FourTilesAreOneMapWherever*:WindInShaders.HardwareFiltering*:SharedPipelines.AreLookedFor*",
    "WindObstacles.ASteadyWind*:WindObstacles.ViscousAir*",
    "WindParity.ThinBoxes:WindCalls.ManySubSteps:WindSubsteps.AStorm*",
    "GroundHoles.AreTheSame*:TiledGround.AnyTiles*:SceneCost.UnknownKeys:SceneCost.OneTable*:Mesh.WindingNumbers*",
    "WindObstacles.ABallThat*:WindObstacles.TheClassic*:WindObstacles.AWalkOver*",
    "WindObstacles.InMemory*:*OfTheCpu/matrix*:*OfTheCpu/piston:*OfTheCpu/ball_moves*:*OfTheCpu/random_1*",
    "*SurfaceReadings.AreThoseOfTheCpu/*",
    "WindCalls.ViscosityInEvery*:WindCalls.StagesLeftOut:WindSaves.ContinueToTheBit:WindInFlight.EveryFrame*",
    "BlendZone.AWalkPast*:VoxelGrid.ASegment*:Ground.WindowShifts*:CascadeStep.IsTheSame*:Tree.PartsStay*",
    "*MotorCrowd.EqualsTheSum*/3000:WorkGrowth.OfMeshes:Ticks.StatesAt*",
    "TiledGround.SmallTiles*:Together.AForm*:Together.MovesAs*:Together.CloseWhatOne*:Wholes.CloseWhat*:Wholes.HaveThe*",
    "Wake.TheWholeStep*:GroundHoles.CloseWhat*:GroundRecovery.TrailOutlives*:PlantChance.DoesNotRepeat*",
    "Window.AShiftOfTheOrigin*:SceneWakes.AirBehindAFurred*",
};

} // namespace

int main(int count, char** arguments) {
    testing::InitGoogleTest(&count, arguments);
    const bool chosen = GTEST_FLAG_GET(filter) != "*";
    bool leaves_out_slow = false;
#ifdef __SANITIZE_ADDRESS__
    leaves_out_slow = !windrow::test::whole_sweeps();
#endif
    if (!chosen) {
        std::string filter = "-Long*:*.Long*";
        if (!windrow::test::whole_sweeps())
            for (const char* const patterns : k_left_to_all)
                (filter += ':') += patterns;
        if (leaves_out_slow)
            for (const char* const patterns : k_slow_under_asan)
                (filter += ':') += patterns;
        GTEST_FLAG_SET(filter, filter);
    }
    const int failed = RUN_ALL_TESTS();
    // A part of a program without tests would pass whatever is wrong.
    if (!chosen && !leaves_out_slow && testing::UnitTest::GetInstance()->test_to_run_count() == 0) {
        std::puts("No test ran: give the program fewer runs (tests/CMakeLists.txt), or more tests.");
        return 1;
    }
    return failed;
}
