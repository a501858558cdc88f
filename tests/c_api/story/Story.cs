// The story of story_test.py in C#, by the structs and calls of examples/csharp/windrow_c.
using System;
using System.Runtime.InteropServices;
using Windrow;

internal static class Story
{
    private static IntPtr Kept<T>(T value)
    {
        var place = Marshal.AllocHGlobal(Marshal.SizeOf(typeof(T)));
        Marshal.StructureToPtr(value, place, false);
        return place;
    }
    private static void Check(Result result) { Native.Check((int)result); }

    private static void Main()
    {
        var gusts = Gusts.Default();
        gusts.Intensity = 0.2f;
        var config = Config.Default();
        config.Cells.X = 24;
        config.Cells.Y = 12;
        config.Cells.Z = 20;
        config.CellSize = 0.75f;
        config.Boundaries = Boundaries.OpenOverFloor();
        config.Ambient.X = 3.0f;
        config.Ambient.Z = 1.0f;
        config.Gusts = Kept(gusts);
        config.Simd = Simd.Baseline;
        var handle = Marshal.AllocHGlobal(64);
        Check(Calls.windrow_wind_create(Kept(config), handle));
        var wind = Marshal.ReadIntPtr(handle);
        var block = Obstacle.Default();
        block.Position = new DVec3(2.0, 1.0, 0.5);
        var half = new Vec3();
        half.X = 0.5f;
        half.Y = 1.0f;
        half.Z = 0.8f;
        block.Shape = Calls.windrow_shape_block(half);
        Check(Calls.windrow_wind_add_obstacle(wind, Kept(block), handle));
        var jet = JetMotor.Default();
        jet.Position = new DVec3(-3.0, 1.5, 0.0);
        Check(Calls.windrow_wind_add_jet(wind, Kept(jet), handle));
        var id = (MotorId)Marshal.PtrToStructure(handle, typeof(MotorId));
        for (var frame = 0; frame < 60; ++frame)
        {
            Check(Calls.windrow_wind_follow(wind, new DVec3(frame / 20.0, 1.0, 0.0)));
            Check(Calls.windrow_wind_move_motor(wind, id, new DVec3(frame / 16.0 - 3.0, 1.5, 0.0)));
            Check(Calls.windrow_wind_advance(wind, 1.0 / 60.0, IntPtr.Zero, IntPtr.Zero));
        }
        Check(Calls.windrow_wind_save(wind, handle));
        var saved = Marshal.ReadIntPtr(handle);
        var bytes = new byte[Calls.windrow_bytes_size(saved)];
        Marshal.Copy(Calls.windrow_bytes_data(saved), bytes, 0, bytes.Length);
        var hash = 0xcbf29ce484222325UL;
        foreach (var one in bytes)
            hash = unchecked((hash ^ one) * 0x100000001b3UL);
        Console.WriteLine(hash.ToString("x16"));
        Calls.windrow_bytes_destroy(saved);
        Calls.windrow_wind_destroy(wind);
    }
}
