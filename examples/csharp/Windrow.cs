// A class of Windrow by P/Invoke, to take along: the wind, wakes, queries. The structs have all fields of c_api/config.h and
// c_api/motors.h in their order; the init functions fill them with defaults.
using System;
using System.Runtime.InteropServices;

namespace Windrow
{
    [StructLayout(LayoutKind.Sequential)]
    public struct Vec3
    {
        public float X, Y, Z;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct DVec3
    {
        public double X, Y, Z;
        public DVec3(double x, double y, double z) { X = x; Y = y; Z = z; }
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct Boundary
    {
        public int Kind;
        public Vec3 WallVelocity;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct Boundaries
    {
        public Boundary XLow, XHigh, YLow, YHigh, ZLow, ZHigh;

        public static Boundaries OpenOverFloor() { return Native.windrow_boundaries_open_over_floor(); }
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct Config
    {
        public uint StructSize;
        public int CellsX, CellsY, CellsZ;
        public float CellSize;
        public Boundaries Boundaries;
        public int FollowAxes;
        public DVec3 Centre;
        public Vec3 Ambient;
        public uint Reserved;
        public IntPtr Profile, Gusts, Canopy, Roughness, Rows;
        public float BlendWidth, Viscosity, RelaxationTime, SleepSpeed;
        public int Scheme, Interpolation;
        public float MaxCfl;
        public int MaxSubsteps, PressureSolves;
        public uint Stages;
        public double TicksHz;
        public int TicksMaxPerCall, Simd;
        public IntPtr Run, Context;

        public static Config Default()
        {
            Config config;
            Native.Check(Native.windrow_config_init(out config, (uint)Marshal.SizeOf(typeof(Config))));
            return config;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct WakeMotor
    {
        public uint StructSize;
        public float Radius;
        public DVec3 Position;
        public int LawKind;
        public float Strength, PerMetre, Entrainment;
        public float Attack, Hold, Decay, Delay;
        public float TurbulenceIntensity, TurbulenceLength;
        public uint TurbulenceSeed, Reserved;

        public static WakeMotor Default()
        {
            WakeMotor motor;
            Native.Check(Native.windrow_wake_motor_init(out motor, (uint)Marshal.SizeOf(typeof(WakeMotor))));
            return motor;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct MotorId
    {
        public uint Slot, Generation, Owner;
    }

    /// The library's sentence: field, value, fix.
    public sealed class WindrowException : Exception
    {
        public WindrowException(string sentence) : base(sentence) { }
    }

    /// The wind in a box that follows a player. One thread at a time may use it.
    public sealed class Wind : IDisposable
    {
        private IntPtr wind;

        public Wind(Config config) { Native.Check(Native.windrow_wind_create(ref config, out wind)); }

        public MotorId Add(WakeMotor motor)
        {
            MotorId id;
            Native.Check(Native.windrow_wind_add_wake(wind, ref motor, out id));
            return id;
        }
        public void Move(MotorId id, DVec3 position) { Native.Check(Native.windrow_wind_move_motor(wind, id, position)); }
        public void Remove(MotorId id) { Native.Check(Native.windrow_wind_remove_motor(wind, id)); }
        public void Follow(DVec3 point) { Native.Check(Native.windrow_wind_follow(wind, point)); }
        public void Advance(double seconds) { Native.Check(Native.windrow_wind_advance(wind, seconds, IntPtr.Zero, IntPtr.Zero)); }
        public Vec3 Velocity(DVec3 position)
        {
            Vec3 velocity;
            Native.Check(Native.windrow_wind_velocity(wind, position, out velocity));
            return velocity;
        }

        public void Dispose()
        {
            Native.windrow_wind_destroy(wind);
            wind = IntPtr.Zero;
            GC.SuppressFinalize(this);
        }
        ~Wind() { Native.windrow_wind_destroy(wind); }
    }

    internal static class Native
    {
        private const string Library = "libwindrow.so.0.1";

        [DllImport(Library)] internal static extern IntPtr windrow_last_error();
        [DllImport(Library)] internal static extern Boundaries windrow_boundaries_open_over_floor();
        [DllImport(Library)] internal static extern int windrow_config_init(out Config config, uint size);
        [DllImport(Library)] internal static extern int windrow_wake_motor_init(out WakeMotor motor, uint size);
        [DllImport(Library)] internal static extern int windrow_wind_create(ref Config config, out IntPtr wind);
        [DllImport(Library)] internal static extern void windrow_wind_destroy(IntPtr wind);
        [DllImport(Library)] internal static extern int windrow_wind_follow(IntPtr wind, DVec3 point);
        [DllImport(Library)] internal static extern int windrow_wind_add_wake(IntPtr wind, ref WakeMotor motor, out MotorId id);
        [DllImport(Library)] internal static extern int windrow_wind_move_motor(IntPtr wind, MotorId id, DVec3 position);
        [DllImport(Library)] internal static extern int windrow_wind_remove_motor(IntPtr wind, MotorId id);
        [DllImport(Library)] internal static extern int windrow_wind_advance(IntPtr wind, double dt, IntPtr advance, IntPtr last);
        [DllImport(Library)] internal static extern int windrow_wind_velocity(IntPtr wind, DVec3 position, out Vec3 velocity);

        internal static void Check(int result)
        {
            if (result != 0)
                throw new WindrowException(Marshal.PtrToStringAnsi(windrow_last_error()));
        }
    }
}
