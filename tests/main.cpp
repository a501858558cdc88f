// The main function of each program of tests. Without --gtest_filter a program runs what `./dev test` is for: no test whose name
// begins with Long, and under AddressSanitizer no test of ten seconds and more, unless WINDROW_TIER is all.
#include "tests/tier.h"

#include <gtest/gtest.h>
#include <string>

namespace {

// Shorter tests run the same code, one or two of each of these kinds.
constexpr const char* k_slow_under_asan =
    ":*32x16x32*:*GainNoEnergyByThemselves*:*TenThousandSteps*:*FiveMinutes*:*OfAThousandMetresASecond*:*UniformWindStays*"
    ":Replay.OfARandom*:StoryBits.*:Bits.*:WindowLarge.*:OpenSides.*:ForcedFlow.*:GustFront.*:MotorFlows.*:AdvectionTrace.*"
    ":TaylorGreen.*:TaylorGreen3D.*:SpectralReference.*:WindBarriers.*:WindStorms.*:Walls.*:Poisson.*:Flicker.*:HardCases.*"
    ":OpposedMotors.*:AirParity.*:Checkerboard.*:RandomStories.*:UnevenSteps.*:MotorOrder.*:Shelter.*:GroundWalkers.WhoStops*"
    ":GroundWalkers.InACrowd*:WindSubsteps.ATickRecords*:WindSubsteps.Obstacles*:WindBoxes.OfTheDefault*:Rooms.WallsAlone*"
    ":Rooms.KeepTheAir*:ObstacleForces.AreNormal*:ObstacleForces.ABallThatSpeeds*:ObstacleStability.Plates*"
    ":ObstacleStability.BodiesOfEvery*:ObstacleStability.Hills*:ObstacleFlows.OneSolve*:Terrain.*"
    ":QueryList.ThePlaceInTheTile*:Sleep.WakingEquals*:Sleep.FollowsAndIsSampled*:Sleep.TheStepThatFalls*:Sleep."
    "CostsNextToNothing"
    ":RequiredMemory.IsThat*:WindChanges.AWindThatIsCut*:MotorKinds.Widening*:MotorKinds.FollowTheirClosed*:Ticks.ThirtyTicks*"
    ":WindStories.OfAirThatNeverSleeps"
    ":*OfTheCpu/*_rests:*OfTheCpu/*_moves:*OfTheCpu/*_turns:*OfTheCpu/thin_wall*:*OfTheCpu/fast_air*:*OfTheCpu/"
    "random_2*:*OfTheCpu/random_3*"
    ":*OfTheCpu/random_4*:*OfTheCpu/random_5*:*OfTheCpu/random_6*:*OfTheCpu/random_7*:*OfTheCpu/random_8*:*OfTheCpu/random_9*";

} // namespace

int main(int count, char** arguments) {
    testing::InitGoogleTest(&count, arguments);
    if (GTEST_FLAG_GET(filter) == "*") {
        std::string without = "-Long*:*.Long*";
#ifdef __SANITIZE_ADDRESS__
        if (!windrow::test::whole_sweeps())
            without += k_slow_under_asan;
#endif
        GTEST_FLAG_SET(filter, without);
    }
    return RUN_ALL_TESTS();
}
