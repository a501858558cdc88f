// Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit.
using System;
using System.Runtime.InteropServices;

namespace Windrow
{
    public enum Part { Coupling = 0, Vdb = 1, Vulkan = 2, Scene = 3 }
    public enum Result { Ok = 0, Rejected = -1, Stale = -2, OutOfMemory = -3, CannotWrite = -4, DiskFull = -5,
        Unsupported = -6, NotReady = -7, DeviceLost = -9, Unexpected = -8 }
    public enum Severity { Warning = 0, Error = 1 }
    public enum Axes { YUpRight = 0, YUpLeft = 1, ZUpRight = 2, ZUpLeft = 3 }
    public enum BoundaryKind { Open = 0, FreeSlip = 1, NoSlip = 2, Periodic = 3 }
    public enum Scheme { SecondOrder = 0, StableFluids = 1 }
    public enum Interpolation { Linear = 0, Cubic = 1, Cubic32 = 2 }
    public enum Simd { Best = 0, Baseline = 1, Avx2 = 2, Avx512 = 3 }
    public enum DiffusionMethod { None = 0, OnePass = 1, Implicit = 2 }
    public enum Frame { Now = 0, Previous = 1 }
    public enum Number { Float = 0, Double = 1 }
    public enum Texel { Half = 0, Float = 1 }
    public enum FieldFormat { Fga = 0, Vf = 1, Raw = 2, Npz = 3, Vti = 4 }
    public enum DebugKind { Box = 0, Motor = 1, Obstacle = 2, Arrow = 3 }
    public static partial class Constants
    {
        public const int FollowDefault = -1, FollowX = 1, FollowY = 2, FollowZ = 4, StageSources = 1,
            StageRelaxation = 2, StageDiffusion = 4, StageAdvection = 8, StageProjection = 16, StageAll = 31,
            MaxRows = 128;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Vec2
    {
        public float X, Y;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Vec3
    {
        public float X, Y, Z;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Vec4
    {
        public float X, Y, Z, W;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Quat
    {
        public float X, Y, Z, W;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct DVec2
    {
        public double X, Y;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct DVec3
    {
        public double X, Y, Z;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct DVec4
    {
        public double X, Y, Z, W;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct IVec2
    {
        public int X, Y;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct IVec3
    {
        public int X, Y, Z;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct UVec2
    {
        public uint X, Y;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct ParallelFor
    {
        public IntPtr Run, Context;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct SavedPart
    {
        public IntPtr Name, Bytes;
        public ulong Size;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Boundary
    {
        public BoundaryKind Kind;
        public Vec3 WallVelocity;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Boundaries
    {
        public Boundary XLow, XHigh, YLow, YHigh, ZLow, ZHigh;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct LogProfile
    {
        public uint StructSize;
        public float RoughnessLength, ReferenceHeight;
        public static LogProfile Default() { return Native.Filled<LogProfile>(windrow_log_profile_init); }
        [DllImport(Native.Library)] private static extern int windrow_log_profile_init(out LogProfile it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Gusts
    {
        public uint StructSize;
        public float Intensity, Length;
        public uint Seed;
        public IntPtr Tile;
        public static Gusts Default() { return Native.Filled<Gusts>(windrow_gusts_init); }
        [DllImport(Native.Library)] private static extern int windrow_gusts_init(out Gusts it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Canopy
    {
        public uint StructSize;
        public float Height, Drag;
        public static Canopy Default() { return Native.Filled<Canopy>(windrow_canopy_init); }
        [DllImport(Native.Library)] private static extern int windrow_canopy_init(out Canopy it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct RoughnessMap
    {
        public uint StructSize, Reserved;
        public IntPtr Lengths;
        public DVec3 Position;
        public Vec3 Scale;
        public uint Reserved2;
        public static RoughnessMap Default() { return Native.Filled<RoughnessMap>(windrow_roughness_map_init); }
        [DllImport(Native.Library)] private static extern int windrow_roughness_map_init(out RoughnessMap it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Roughness
    {
        public uint StructSize;
        public float Length, LongestMixing;
        public uint Reserved;
        public IntPtr Map;
        public static Roughness Default() { return Native.Filled<Roughness>(windrow_roughness_init); }
        [DllImport(Native.Library)] private static extern int windrow_roughness_init(out Roughness it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Rows
    {
        public uint StructSize;
        public float First;
        public int Uniform;
        public float Ratio, Top;
        public uint HeightCount;
        public IntPtr Heights;
        public static Rows Default() { return Native.Filled<Rows>(windrow_rows_init); }
        [DllImport(Native.Library)] private static extern int windrow_rows_init(out Rows it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Config
    {
        public uint StructSize;
        public IVec3 Cells;
        public float CellSize;
        public Boundaries Boundaries;
        public int FollowAxes;
        public DVec3 Centre;
        public Vec3 Ambient;
        public uint Reserved;
        public IntPtr Profile, Gusts, Canopy, Roughness, Rows;
        public float BlendWidth, Viscosity, RelaxationTime, SleepSpeed;
        public Scheme Scheme;
        public Interpolation Interpolation;
        public float MaxCfl;
        public int MaxSubsteps, PressureSolves;
        public uint Stages;
        public double TicksHz;
        public int TicksMaxPerCall;
        public Simd Simd;
        public ParallelFor ParallelFor;
        public double Floor;
        public float JumpSpeed;
        public uint Reserved2;
        public static Config Default() { return Native.Filled<Config>(windrow_config_init); }
        [DllImport(Native.Library)] private static extern int windrow_config_init(out Config it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Sampling
    {
        public uint StructSize;
        public float Strength, Limit, Detail, DetailLength;
        public static Sampling Default() { return Native.Filled<Sampling>(windrow_sampling_init); }
        [DllImport(Native.Library)] private static extern int windrow_sampling_init(out Sampling it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct AmbientSettings
    {
        public uint StructSize;
        public Vec3 Mean;
        public IntPtr Profile, Gusts;
        public double Ground;
        public static AmbientSettings Default() { return Native.Filled<AmbientSettings>(windrow_ambient_settings_init); }
        [DllImport(Native.Library)] private static extern int windrow_ambient_settings_init(out AmbientSettings it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct UniformGust
    {
        public uint StructSize;
        public float Mean, Amplitude, Period;
        public Vec3 Direction;
        public uint Reserved;
        public static UniformGust Default() { return Native.Filled<UniformGust>(windrow_uniform_gust_init); }
        [DllImport(Native.Library)] private static extern int windrow_uniform_gust_init(out UniformGust it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct WindowBlock
    {
        public Vec3 Origin;
        public float CellSize;
        public Vec3 Cells;
        public float Factor;
        public Vec3 PreviousOrigin;
        public float Rows;
        public Vec3 Ambient;
        public float Height;
        public Vec3 LowBoundaries;
        public float WallPerLength;
        public Vec3 HighBoundaries;
        public float WallPerLog;
        public Vec3 BlendCentre;
        public float BlendWidth;
        public Vec3 BlendReach;
        public float WallLowest;
        public Vec3 PreviousBlendCentre;
        public float WallFall;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct AxisBlock
    {
        public float TextureScale, TextureOffset, InnerScale, InnerOffset, EdgeScale, LowEdge, HighEdge, Smoothness;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct PlaceBlock
    {
        public AxisBlock X, Y, Z;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct AmbientBlock
    {
        public Vec3 Mean;
        public float GustStrength, RoughnessLength, ReferenceHeight, AnchorHeight, FeltStrength;
        public Vec3 GustTexel;
        public float GustTexels;
        public Vec3 GustFraction;
        public float LongestGust;
        public Vec3 GustAxes;
        public float FeltLimit;
        public Vec3 DetailTexel;
        public float DetailTexels;
        public Vec3 DetailFraction;
        public float DetailAmount;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct FrameBlock
    {
        public WindowBlock Window;
        public PlaceBlock Place, PreviousPlace;
        public AmbientBlock Ambient, PreviousAmbient;
        [MarshalAs(UnmanagedType.ByValArray, SizeConst = 128)] public float[] Heights;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct DragBlock
    {
        public Vec4 Load;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct BladeBlock
    {
        public Vec4 Size, Form, Own;
        public DragBlock Drag;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct ShellBlock
    {
        public Vec4 Form, Push, Sag;
        public DragBlock Drag;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct TreeBlock
    {
        public DragBlock Trunk, Branch, Leaf;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct SpringBlock
    {
        public Vec4 Place, Velocity;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct SwingBlock
    {
        public SpringBlock Spring, Smoothing;
        public Vec4 Parts;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct FlutterBlock
    {
        public Vec4 Motion, Now, Before;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct PoseBlock
    {
        public Vec4 Place, Rotation;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct GroundPlaceBlock
    {
        public Vec4 Corner, BlendZone, Slot;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct GroundBlock
    {
        public GroundPlaceBlock Now, Before;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct StageTimes
    {
        public double Sources, Ambient, Diffusion, Advection, Projection, Obstacles, Report, Total;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Diagnostics
    {
        public uint StructSize;
        public int Stepped, OutOfMemory, Regridded;
        public float MaxSpeed, Cfl;
        public int Substeps, SubstepsCapped;
        public float CarriedTime;
        public int MotorsInReach;
        public long LimitedCells, RepairedCells;
        public DiffusionMethod Diffusion;
        public float PressureResidual;
        public int PressureSolves, SealedSources;
        public double DivergenceRms, Energy;
        public int Asleep, MotorsLost;
        public StageTimes TimesMs;
        public int Jumps;
        public uint Reserved;
        public int FastTurns;
        public uint Reserved2;
        public int FillingObstacles;
        public uint Reserved3;
        public int SealedRooms;
        public uint Reserved4;
        public static Diagnostics Default() { return Native.Filled<Diagnostics>(windrow_diagnostics_init); }
        [DllImport(Native.Library)] private static extern int windrow_diagnostics_init(out Diagnostics it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Advance
    {
        public uint StructSize;
        public int Ticks;
        public double Dropped;
        public float Factor;
        public uint Reserved;
        public static Advance Default() { return Native.Filled<Advance>(windrow_advance_init); }
        [DllImport(Native.Library)] private static extern int windrow_advance_init(out Advance it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Box
    {
        public uint StructSize;
        public IVec3 Cells;
        public float CellSize;
        public Vec3 Size;
        public DVec3 Origin;
        public Boundaries Boundaries;
        public static Box Default() { return Native.Filled<Box>(windrow_box_init); }
        [DllImport(Native.Library)] private static extern int windrow_box_init(out Box it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Query
    {
        public uint StructSize;
        public Frame Frame;
        public ulong Count;
        public IntPtr Positions;
        public Number Number;
        public uint PositionStride;
        public DVec3 Anchor;
        public IntPtr Velocities;
        public uint VelocityStride, Reserved;
        public IntPtr Sampling;
        public static Query Default() { return Native.Filled<Query>(windrow_query_init); }
        [DllImport(Native.Library)] private static extern int windrow_query_init(out Query it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct DebugLine
    {
        public DVec3 Begin, End;
        public DebugKind Kind;
        public float Speed;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct DebugView
    {
        public uint StructSize;
        public int Box, Motors, Obstacles, Arrows;
        public float Seconds;
        public double Height;
        public static DebugView Default() { return Native.Filled<DebugView>(windrow_debug_view_init); }
        [DllImport(Native.Library)] private static extern int windrow_debug_view_init(out DebugView it, uint size);
    }

    public static partial class Calls
    {
        [DllImport(Native.Library)]
        public static extern uint windrow_version();
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_version_string();
        [DllImport(Native.Library)]
        public static extern int windrow_has_part(Part part);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_last_error();
        [DllImport(Native.Library)]
        public static extern void windrow_set_logger(IntPtr logger, IntPtr user);
        [DllImport(Native.Library)]
        public static extern Result windrow_set_allocator(IntPtr allocate, IntPtr release, IntPtr user);
        [DllImport(Native.Library)]
        public static extern ulong windrow_allocated_bytes();
        [DllImport(Native.Library)]
        public static extern Result windrow_set_axes(Axes axes, double unit);
        [DllImport(Native.Library)]
        public static extern Result windrow_axes_matrix(IntPtr matrix);
        [DllImport(Native.Library)]
        public static extern Result windrow_thread_pool_create(int threads, IntPtr pool);
        [DllImport(Native.Library)]
        public static extern void windrow_thread_pool_destroy(IntPtr pool);
        [DllImport(Native.Library)]
        public static extern int windrow_thread_pool_size(IntPtr pool);
        [DllImport(Native.Library)]
        public static extern ParallelFor windrow_thread_pool_parallel_for(IntPtr pool);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_bytes_data(IntPtr bytes);
        [DllImport(Native.Library)]
        public static extern ulong windrow_bytes_size(IntPtr bytes);
        [DllImport(Native.Library)]
        public static extern void windrow_bytes_destroy(IntPtr bytes);
        [DllImport(Native.Library)]
        public static extern Result windrow_parts_join(IntPtr parts, ulong count, IntPtr file);
        [DllImport(Native.Library)]
        public static extern Result windrow_parts_find(IntPtr bytes, ulong size,
            [MarshalAs(UnmanagedType.LPUTF8Str)] string name, IntPtr part, IntPtr part_size);
        [DllImport(Native.Library)]
        public static extern Boundaries windrow_boundaries_all(BoundaryKind kind);
        [DllImport(Native.Library)]
        public static extern Boundaries windrow_boundaries_open_over_floor();
        [DllImport(Native.Library)]
        public static extern Result windrow_log_profile_init(IntPtr profile, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_gusts_init(IntPtr gusts, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_canopy_init(IntPtr canopy, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_roughness_map_init(IntPtr map, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_roughness_init(IntPtr roughness, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_rows_init(IntPtr rows, uint struct_size);
        [DllImport(Native.Library)]
        public static extern int windrow_simd_runs(Simd level);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_simd_name(Simd level);
        [DllImport(Native.Library)]
        public static extern Result windrow_config_init(IntPtr config, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_config_validate(IntPtr config);
        [DllImport(Native.Library)]
        public static extern Result windrow_sampling_init(IntPtr sampling, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_sampling_validate(IntPtr sampling);
        [DllImport(Native.Library)]
        public static extern Result windrow_gust_tile_bake(uint seed, IntPtr tile);
        [DllImport(Native.Library)]
        public static extern void windrow_gust_tile_destroy(IntPtr tile);
        [DllImport(Native.Library)]
        public static extern Result windrow_gust_tile_save(IntPtr tile, IntPtr bytes);
        [DllImport(Native.Library)]
        public static extern Result windrow_gust_tile_load(IntPtr bytes, ulong size, IntPtr tile);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_gust_tile_texels(IntPtr tile, IntPtr count);
        [DllImport(Native.Library)]
        public static extern Result windrow_ambient_settings_init(IntPtr settings, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_ambient_wind_create(IntPtr settings, IntPtr ambient);
        [DllImport(Native.Library)]
        public static extern Result windrow_ambient_wind_of(IntPtr wind, int frame, IntPtr ambient);
        [DllImport(Native.Library)]
        public static extern void windrow_ambient_wind_destroy(IntPtr ambient);
        [DllImport(Native.Library)]
        public static extern Result windrow_ambient_wind_advance(IntPtr ambient, double dt);
        [DllImport(Native.Library)]
        public static extern Result windrow_ambient_wind_set_mean(IntPtr ambient, Vec3 mean);
        [DllImport(Native.Library)]
        public static extern Result windrow_ambient_wind_set_ground(IntPtr ambient, double height);
        [DllImport(Native.Library)]
        public static extern Result windrow_ambient_wind_set_phase(IntPtr ambient, DVec3 phase);
        [DllImport(Native.Library)]
        public static extern DVec3 windrow_ambient_wind_phase(IntPtr ambient);
        [DllImport(Native.Library)]
        public static extern double windrow_ambient_wind_period(IntPtr ambient);
        [DllImport(Native.Library)]
        public static extern Vec3 windrow_ambient_wind_mean(IntPtr ambient);
        [DllImport(Native.Library)]
        public static extern double windrow_ambient_wind_ground(IntPtr ambient);
        [DllImport(Native.Library)]
        public static extern float windrow_ambient_wind_profile_at(IntPtr ambient, double height);
        [DllImport(Native.Library)]
        public static extern Result windrow_ambient_wind_velocity(IntPtr ambient, DVec3 position, IntPtr velocity);
        [DllImport(Native.Library)]
        public static extern Result windrow_ambient_wind_felt(IntPtr ambient, DVec3 position, IntPtr sampling,
            IntPtr velocity);
        [DllImport(Native.Library)]
        public static extern Result windrow_ambient_wind_block(IntPtr ambient, DVec3 anchor, IntPtr sampling,
            IntPtr block);
        [DllImport(Native.Library)]
        public static extern Result windrow_ambient_wind_tile(IntPtr ambient, IntPtr tile);
        [DllImport(Native.Library)]
        public static extern Result windrow_uniform_gust_init(IntPtr gust, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_uniform_gust_velocity(IntPtr gust, double time, IntPtr velocity);
        [DllImport(Native.Library)]
        public static extern Result windrow_diagnostics_init(IntPtr diagnostics, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_advance_init(IntPtr advance, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_box_init(IntPtr box, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_create(IntPtr config, IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_create_inside(IntPtr config, IntPtr outer, IntPtr wind);
        [DllImport(Native.Library)]
        public static extern void windrow_wind_destroy(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_save(IntPtr wind, IntPtr bytes);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_load(IntPtr bytes, ulong size, IntPtr parallel_for, IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_load_inside(IntPtr bytes, ulong size, IntPtr parallel_for,
            IntPtr outer, IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_record_to(IntPtr wind, IntPtr log);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_config(IntPtr wind, IntPtr config);
        [DllImport(Native.Library)]
        public static extern ulong windrow_wind_memory_bytes(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_step(IntPtr wind, double dt, IntPtr diagnostics);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_advance(IntPtr wind, double dt, IntPtr advance, IntPtr last);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_follow(IntPtr wind, DVec3 point);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_floor(IntPtr wind, double height);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_shift_origin(IntPtr wind, DVec3 offset);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_box(IntPtr wind, IntPtr box);
        [DllImport(Native.Library)]
        public static extern DVec3 windrow_wind_origin(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern ulong windrow_wind_cell_count(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_ambient(IntPtr wind, Vec3 ambient);
        [DllImport(Native.Library)]
        public static extern Vec3 windrow_wind_ambient(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_gusts(IntPtr wind, IntPtr gusts);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_boundaries(IntPtr wind, IntPtr boundaries);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_velocity(IntPtr wind, IntPtr velocity_at, IntPtr user);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_field(IntPtr wind, IntPtr cells, ulong count);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_reset(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_velocity(IntPtr wind, DVec3 position, IntPtr velocity);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_felt(IntPtr wind, DVec3 position, IntPtr sampling, IntPtr velocity);
        [DllImport(Native.Library)]
        public static extern Result windrow_query_init(IntPtr query, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_sample(IntPtr wind, IntPtr query);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_write_vectors(IntPtr wind, Frame frame, Texel texel, IntPtr texels,
            ulong count);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_write_axes(IntPtr wind, Frame frame, Texel texel, IntPtr x, IntPtr y,
            IntPtr z, ulong count);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_write_obstacles(IntPtr wind, IntPtr cells, ulong count);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_write_pressure(IntPtr wind, IntPtr cells, ulong count);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_field(IntPtr wind, Frame frame, IntPtr cells, IntPtr count,
            IntPtr origin);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_write_field(IntPtr wind,
            [MarshalAs(UnmanagedType.LPUTF8Str)] string path, FieldFormat format, double time);
        [DllImport(Native.Library)]
        public static extern ushort windrow_to_half(float value);
        [DllImport(Native.Library)]
        public static extern float windrow_from_half(ushort half);
        [DllImport(Native.Library)]
        public static extern Result windrow_debug_view_init(IntPtr view, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_debug_lines(IntPtr wind, IntPtr view, IntPtr draw, IntPtr user);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_window_block(IntPtr wind, DVec3 anchor, IntPtr block);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_frame_block(IntPtr wind, DVec3 anchor, IntPtr sampling, IntPtr block);
        [DllImport(Native.Library)]
        public static extern Result windrow_event_log_create(IntPtr log);
        [DllImport(Native.Library)]
        public static extern void windrow_event_log_destroy(IntPtr log);
        [DllImport(Native.Library)]
        public static extern ulong windrow_event_log_count(IntPtr log);
        [DllImport(Native.Library)]
        public static extern int windrow_event_log_complete(IntPtr log);
        [DllImport(Native.Library)]
        public static extern Result windrow_event_log_clear(IntPtr log);
        [DllImport(Native.Library)]
        public static extern Result windrow_event_log_to_bytes(IntPtr log, IntPtr bytes);
        [DllImport(Native.Library)]
        public static extern Result windrow_event_log_from_bytes(IntPtr bytes, ulong size, IntPtr log);
        [DllImport(Native.Library)]
        public static extern Result windrow_event_log_replay(IntPtr log, IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_tracer_create(IntPtr wind, IntPtr parallel_for, IntPtr tracer);
        [DllImport(Native.Library)]
        public static extern void windrow_tracer_destroy(IntPtr tracer);
        [DllImport(Native.Library)]
        public static extern Result windrow_tracer_save(IntPtr tracer, IntPtr bytes);
        [DllImport(Native.Library)]
        public static extern Result windrow_tracer_load(IntPtr bytes, ulong size, IntPtr wind, IntPtr parallel_for,
            IntPtr tracer);
        [DllImport(Native.Library)]
        public static extern Result windrow_tracer_step(IntPtr tracer, IntPtr wind, double dt);
        [DllImport(Native.Library)]
        public static extern Result windrow_tracer_blow(IntPtr tracer, DVec3 point, float radius);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_tracer_cells(IntPtr tracer, IntPtr count);
    }
}
