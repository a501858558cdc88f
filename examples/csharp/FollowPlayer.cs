// Tutorial: the README's ten lines in C#. A dog runs beside a player through a breeze, and a leaf feels its wake.
//
//     mcs -out:follow_player.exe Windrow.cs FollowPlayer.cs windrow_c/*.cs && mono follow_player.exe
//
// Windrow.cs is the class, windrow_c the structs. Every error is an exception with the library's sentence.
using System;
using System.Globalization;
using Windrow;

internal static class FollowPlayer
{
    private static int Main(string[] arguments)
    {
        try
        {
            var config = Config.Default();
            config.Boundaries = Boundaries.OpenOverFloor();
            config.Ambient.X = 3.0f;
            if (arguments.Length > 0 && arguments[0] == "wrong") // to see the library's sentence
                config.CellSize = -1.0f;
            using (var wind = new Wind(config))
            {
                var wake = WakeMotor.Default();
                wake.Position = new DVec3(0.0, 0.5, 1.0);
                wake.Radius = 0.6f;
                var dog = wind.Add(wake);
                for (var frame = 0; frame < 60; ++frame)
                {
                    wind.Follow(new DVec3(frame / 20.0, 1.0, 0.0));
                    wind.Move(dog, new DVec3(frame / 8.0, 0.5, 1.0));
                    wind.Advance(1.0 / 60.0);
                }
                var leaf = wind.Velocity(new DVec3(4.0, 0.5, 1.0));
                Console.WriteLine(leaf.X.ToString("F2", CultureInfo.InvariantCulture) + " m/s at the leaf");
            }
            return 0;
        }
        catch (WindrowException error)
        {
            Console.Error.WriteLine(error.Message);
            return 2;
        }
    }
}
