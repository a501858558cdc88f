// A host with the axes and the unit of an engine, by windrow_set_axes: the cells are where the files for that engine have them, and a vortex turns
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

    private static IntPtr Made(Vec3 ambient, DVec3 centre, bool vortex)
    {
        var config = Config.Default(); // in the host's unit
        config.Cells.X = 10;
        config.Cells.Y = 6;
        config.Cells.Z = 8;
        config.Ambient = ambient;
        config.Centre = centre;
        var handle = Marshal.AllocHGlobal(64);
        Check(Calls.windrow_wind_create(Kept(config), handle));
        var wind = Marshal.ReadIntPtr(handle);
        if (vortex)
        {
            var motor = VortexMotor.Default();
            motor.Axis = Of(0.0f, 1.0f, 0.0f);
            Check(Calls.windrow_wind_add_vortex(wind, Kept(motor), handle));
            for (var step = 0; step < 30; ++step)
                Check(Calls.windrow_wind_step(wind, 1.0 / 60.0, IntPtr.Zero));
        }
        return wind;
    }
    private static Vec3 Of(float x, float y, float z)
    {
        var v = new Vec3();
        v.X = x;
        v.Y = y;
        v.Z = z;
        return v;
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
        Check(Calls.windrow_set_axes(Axes.ZUpLeft, 0.01));
        Expect(Near(WakeMotor.Default().Radius, 50.0), "a default is in Unreal's centimetres");
        var wind = Made(Of(300.0f, 100.0f, 50.0f), new DVec3(200.0, 100.0, 50.0), false);
        var file = Path.Combine(folder, "engine.fga");
        Check(Calls.windrow_wind_write_field(wind, file, FieldFormat.Fga, 0.0));
        var numbers = File.ReadAllText(file).Split(new[] {',', '\n'}, StringSplitOptions.RemoveEmptyEntries)
            .Select(word => double.Parse(word, CultureInfo.InvariantCulture)).Take(12).ToArray();
        var low = Calls.windrow_wind_origin(wind);
        Expect(numbers[0] == 10 && numbers[1] == 6 && numbers[2] == 8, "the cells are those of Unreal's file");
        Expect(Near(low.X, numbers[3]) && Near(low.Y, numbers[4]) && Near(low.Z, numbers[5]),
               "the low corner is where Unreal's file has it");
        var felt = Velocity(wind, new DVec3(low.X + 50.0, low.Y + 50.0, low.Z + 50.0));
        Expect(Near(felt.X, 300.0) && Near(felt.Y, 100.0) && Near(felt.Z, 50.0), "a velocity comes back in cm/s");
        Expect(Near(felt.X, numbers[9]) && Near(felt.Y, numbers[10]) && Near(felt.Z, numbers[11]), "as Unreal's file has it");

        Check(Calls.windrow_set_axes(Axes.YUpLeft, 1.0));
        wind = Made(Of(1.0f, 0.25f, 3.0f), new DVec3(0.0, 0.0, 0.0), false);
        file = Path.Combine(folder, "engine.vf");
        Check(Calls.windrow_wind_write_field(wind, file, FieldFormat.Vf, 0.0));
        var bytes = File.ReadAllBytes(file);
        felt = Velocity(wind, new DVec3(0.0, 0.0, 0.0));
        Expect(felt.X == BitConverter.ToSingle(bytes, 10) && felt.Z == BitConverter.ToSingle(bytes, 18) && Near(felt.Z, 3.0),
               "a velocity is as Unity's file has it");

        // A quarter turn about Unity's up takes forward, z, to the right, x; beside it on the right the air goes back.
        wind = Made(new Vec3(), new DVec3(0.0, 0.0, 0.0), true);
        Expect(Velocity(wind, new DVec3(2.0, 0.0, 0.0)).Z < -0.1, "a vortex turns as Unity's rotations do");
        Check(Calls.windrow_set_axes(Axes.YUpRight, 1.0));
        wind = Made(new Vec3(), new DVec3(0.0, 0.0, 0.0), true);
        Expect(Velocity(wind, new DVec3(2.0, 0.0, 0.0)).Z < -0.1, "and as Godot's do");
        return 0;
    }
}
