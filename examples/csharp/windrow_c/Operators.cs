// Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit.
using System;
using System.Runtime.InteropServices;

namespace Windrow
{

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Transport
    {
        public uint StructSize;
        public float Dt;
        public IntPtr Carried, Velocity, VelocityOld, History;
        public float HistoryScale, Extrapolation, Relaxation;
        public Interpolation Interpolation;
        public static Transport Default() { return Native.Filled<Transport>(windrow_transport_init); }
        [DllImport(Native.Library)] private static extern int windrow_transport_init(out Transport it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct ScalarTransport
    {
        public uint StructSize;
        public float Dt;
        public IntPtr Carried, Velocity;
        public float Outside;
        public int Clamped;
        public Interpolation Interpolation;
        public uint Reserved;
        public static ScalarTransport Default() { return Native.Filled<ScalarTransport>(windrow_scalar_transport_init); }
        [DllImport(Native.Library)] private static extern int windrow_scalar_transport_init(out ScalarTransport it, uint size);
    }

    public static partial class Calls
    {
        [DllImport(Native.Library)]
        public static extern Result windrow_workspace_create(IntPtr config, IntPtr work);
        [DllImport(Native.Library)]
        public static extern void windrow_workspace_destroy(IntPtr work);
        [DllImport(Native.Library)]
        public static extern ulong windrow_workspace_cell_count(IntPtr work);
        [DllImport(Native.Library)]
        public static extern ulong windrow_workspace_memory_bytes(IntPtr work);
        [DllImport(Native.Library)]
        public static extern Result windrow_workspace_set_boundaries(IntPtr work, IntPtr boundaries);
        [DllImport(Native.Library)]
        public static extern Result windrow_workspace_set_ambient(IntPtr work, Vec3 ambient);
        [DllImport(Native.Library)]
        public static extern Result windrow_workspace_set_obstacles(IntPtr work, IntPtr obstacles, IntPtr velocities,
            IntPtr spins, ulong count);
        [DllImport(Native.Library)]
        public static extern Result windrow_workspace_impulse_on(IntPtr work, ulong obstacle, IntPtr impulse);
        [DllImport(Native.Library)]
        public static extern Result windrow_transport_init(IntPtr transport, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_advect(IntPtr work, IntPtr transport, IntPtr result, ulong count);
        [DllImport(Native.Library)]
        public static extern Result windrow_scalar_transport_init(IntPtr transport, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_advect_scalar(IntPtr work, IntPtr transport, IntPtr result, ulong count);
        [DllImport(Native.Library)]
        public static extern Result windrow_diffuse(IntPtr work, IntPtr field, float viscosity, float dt, IntPtr result,
            IntPtr method, ulong count);
        [DllImport(Native.Library)]
        public static extern Result windrow_workspace_reserve_diffusion(IntPtr work);
        [DllImport(Native.Library)]
        public static extern Result windrow_divergence(IntPtr work, IntPtr velocity, IntPtr result, ulong count);
        [DllImport(Native.Library)]
        public static extern Result windrow_solve_poisson(IntPtr work, IntPtr rhs_then_phi, ulong count);
        [DllImport(Native.Library)]
        public static extern Result windrow_project(IntPtr work, IntPtr velocity, IntPtr gradient, IntPtr expansion,
            ulong count);
        [DllImport(Native.Library)]
        public static extern Result windrow_scene_load([MarshalAs(UnmanagedType.LPUTF8Str)] string path,
            IntPtr parallel_for, IntPtr scene);
        [DllImport(Native.Library)]
        public static extern Result windrow_scene_parse([MarshalAs(UnmanagedType.LPUTF8Str)] string text, ulong size,
            [MarshalAs(UnmanagedType.LPUTF8Str)] string path, IntPtr parallel_for, IntPtr scene);
        [DllImport(Native.Library)]
        public static extern void windrow_scene_destroy(IntPtr scene);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_scene_wind(IntPtr scene);
        [DllImport(Native.Library)]
        public static extern int windrow_scene_outer_count(IntPtr scene);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_scene_outer_wind(IntPtr scene, int place);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_write_scene(IntPtr wind,
            [MarshalAs(UnmanagedType.LPUTF8Str)] string path, double duration, double tick_hz);
        [DllImport(Native.Library)]
        public static extern Result windrow_scene_step(IntPtr scene, IntPtr diagnostics);
        [DllImport(Native.Library)]
        public static extern Result windrow_scene_advance(IntPtr scene, double dt, IntPtr advance);
        [DllImport(Native.Library)]
        public static extern double windrow_scene_time(IntPtr scene);
        [DllImport(Native.Library)]
        public static extern double windrow_scene_duration(IntPtr scene);
        [DllImport(Native.Library)]
        public static extern double windrow_scene_frames_per_second(IntPtr scene);
        [DllImport(Native.Library)]
        public static extern int windrow_scene_motor_count(IntPtr scene);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_scene_motor_name(IntPtr scene, int place);
        [DllImport(Native.Library)]
        public static extern int windrow_scene_obstacle_count(IntPtr scene);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_scene_obstacle_name(IntPtr scene, int place);
        [DllImport(Native.Library)]
        public static extern Result windrow_scene_motor(IntPtr scene, [MarshalAs(UnmanagedType.LPUTF8Str)] string name,
            IntPtr id);
        [DllImport(Native.Library)]
        public static extern Result windrow_scene_obstacle(IntPtr scene,
            [MarshalAs(UnmanagedType.LPUTF8Str)] string name, IntPtr id);
        [DllImport(Native.Library)]
        public static extern Result windrow_scene_save(IntPtr scene, IntPtr bytes);
        [DllImport(Native.Library)]
        public static extern Result windrow_scene_restore(IntPtr scene, IntPtr bytes, ulong size);
    }
}
