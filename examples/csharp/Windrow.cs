// A class of Windrow by P/Invoke, to take along: the wind, wakes, queries. All structs and choices of the C headers are in windrow_c;
// Default() fills a struct.
using System;
using System.Runtime.InteropServices;

namespace Windrow
{
    public partial struct DVec3
    {
        public DVec3(double x, double y, double z) { X = x; Y = y; Z = z; }
    }

    public partial struct Boundaries
    {
        public static Boundaries OpenOverFloor() { return Native.windrow_boundaries_open_over_floor(); }
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
        internal const string Library = "libwindrow.so.0.1";

        [DllImport(Library)] internal static extern IntPtr windrow_last_error();
        [DllImport(Library)] internal static extern Boundaries windrow_boundaries_open_over_floor();
        [DllImport(Library)] internal static extern int windrow_wind_create(ref Config config, out IntPtr wind);
        [DllImport(Library)] internal static extern void windrow_wind_destroy(IntPtr wind);
        [DllImport(Library)] internal static extern int windrow_wind_follow(IntPtr wind, DVec3 point);
        [DllImport(Library)] internal static extern int windrow_wind_add_wake(IntPtr wind, ref WakeMotor motor, out MotorId id);
        [DllImport(Library)] internal static extern int windrow_wind_move_motor(IntPtr wind, MotorId id, DVec3 position);
        [DllImport(Library)] internal static extern int windrow_wind_remove_motor(IntPtr wind, MotorId id);
        [DllImport(Library)] internal static extern int windrow_wind_advance(IntPtr wind, double dt, IntPtr advance, IntPtr last);
        [DllImport(Library)] internal static extern int windrow_wind_velocity(IntPtr wind, DVec3 position, out Vec3 velocity);

        internal delegate int Init<T>(out T it, uint size);
        /// A struct with the library's defaults.
        internal static T Filled<T>(Init<T> init)
        {
            T it;
            Check(init(out it, (uint)Marshal.SizeOf(typeof(T))));
            return it;
        }

        internal static void Check(int result)
        {
            if (result != 0)
                throw new WindrowException(Marshal.PtrToStringAnsi(windrow_last_error()));
        }
    }
}
