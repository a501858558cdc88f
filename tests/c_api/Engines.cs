// A host with the axes and the unit of an engine, by EngineAxes: the cells are where the files for that engine have them, and a vortex turns
// as the engine's own rotations do. Prints a line a check; the first fault ends it with 1.
using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using Windrow;

internal static class Engines
{
    private static IntPtr Kept<T>(T value)
    {
        var place = Marshal.AllocHGlobal(Marshal.SizeOf(typeof(T)));
        Marshal.StructureToPtr(value, place, false);
        return place;
    }
    private static void Check(Result result) { Native.Check((int)result); }
    private static void Expect(bool holds, string what)
    {
        Console.WriteLine((holds ? "well: " : "FAULT: ") + what);
        if (!holds)
            Environment.Exit(1);
    }
    private static bool Near(double a, double b) { return Math.Abs(a - b) <= 1e-4 * (1.0 + Math.Abs(b)); }

    private static IntPtr Made(EngineAxes axes, Vec3 ambient, DVec3 centre, EngineAxes vortex)
    {
        var config = Config.Default();
        config.Cells.X = 10;
        config.Cells.Y = 6;
        config.Cells.Z = 8;
        config.Ambient = ambient;
        config.Centre = centre;
        var handle = Marshal.AllocHGlobal(64);
        Check(Calls.windrow_wind_create(Kept(config), handle));
        var wind = Marshal.ReadIntPtr(handle);
        if (vortex != null)
        {
            var motor = VortexMotor.Default();
            motor.Axis = axes.AxisIn(0.0f, 1.0f, 0.0f);
            Check(Calls.windrow_wind_add_vortex(wind, Kept(motor), handle));
            for (var step = 0; step < 30; ++step)
                Check(Calls.windrow_wind_step(wind, 1.0 / 60.0, IntPtr.Zero));
        }
        return wind;
    }
    private static Vec3 Velocity(IntPtr wind, DVec3 place)
    {
        var room = Marshal.AllocHGlobal(16);
        Check(Calls.windrow_wind_velocity(wind, place, room));
        return (Vec3)Marshal.PtrToStructure(room, typeof(Vec3));
    }

    private static int Main(string[] arguments)
    {
        var folder = arguments[0];
        // A host in centimetres, z up, left-handed: 3 m/s along its x, 1 along its y, 0.5 up; the box about (200, 100, 50).
        var unreal = EngineAxes.Unreal;
        var wind = Made(unreal, unreal.VelocityIn(300.0f, 100.0f, 50.0f), unreal.PointIn(200.0, 100.0, 50.0), null);
        var file = Path.Combine(folder, "engine.fga");
        Check(Calls.windrow_wind_write_field(wind, file, FieldFormat.Fga, 0.0));
        var numbers = File.ReadAllText(file).Split(new[] {',', '\n'}, StringSplitOptions.RemoveEmptyEntries)
            .Select(word => double.Parse(word, CultureInfo.InvariantCulture)).Take(12).ToArray();
        var low = unreal.PointOut(Calls.windrow_wind_origin(wind));
        Expect(Near(low.X, numbers[3]) && Near(low.Y, numbers[4]) && Near(low.Z, numbers[5]),
               "the low corner is where Unreal's file has it");
        var felt = unreal.VelocityOut(Velocity(wind, unreal.PointIn(low.X + 50.0, low.Y + 50.0, low.Z + 50.0)));
        Expect(Near(felt.X, 300.0) && Near(felt.Y, 100.0) && Near(felt.Z, 50.0), "a velocity comes back in cm/s");
        Expect(Near(felt.X, numbers[9]) && Near(felt.Y, numbers[10]) && Near(felt.Z, numbers[11]), "as Unreal's file has it");

        var unity = EngineAxes.Unity;
        wind = Made(unity, unity.VelocityIn(1.0f, 0.25f, 3.0f), unity.PointIn(0.0, 0.0, 0.0), null);
        file = Path.Combine(folder, "engine.vf");
        Check(Calls.windrow_wind_write_field(wind, file, FieldFormat.Vf, 0.0));
        var bytes = File.ReadAllBytes(file);
        felt = unity.VelocityOut(Velocity(wind, unity.PointIn(0.0, 0.0, 0.0)));
        Expect(felt.X == BitConverter.ToSingle(bytes, 10) && felt.Z == BitConverter.ToSingle(bytes, 18) && Near(felt.Z, 3.0),
               "a velocity is as Unity's file has it");

        // A quarter turn about Unity's up takes forward, z, to the right, x; beside it on the right the air goes back.
        wind = Made(unity, new Vec3(), new DVec3(0.0, 0.0, 0.0), unity);
        Expect(unity.VelocityOut(Velocity(wind, unity.PointIn(2.0, 0.0, 0.0))).Z < -0.1, "a vortex turns as Unity's rotations do");
        var godot = EngineAxes.Godot;
        wind = Made(godot, new Vec3(), new DVec3(0.0, 0.0, 0.0), godot);
        Expect(godot.VelocityOut(Velocity(wind, godot.PointIn(2.0, 0.0, 0.0))).Z < -0.1, "and as Godot's do");
        var blender = EngineAxes.Blender;
        var up = blender.PointIn(1.0, 2.0, 3.0);
        Expect(up.X == 1.0 && up.Y == 3.0 && up.Z == -2.0, "Blender's z is up, as in VDB files with z up");
        return 0;
    }
}
