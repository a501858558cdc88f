// Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit.
using System;
using System.Runtime.InteropServices;

namespace Windrow
{
    public enum Plant { Grass = 0, Wheat = 1, Reed = 2, Leaf = 3, Twig = 4, Branch = 5, SmallTrunk = 6, LargeTrunk = 7 }
    public enum SpringPlant { Grass = 0, Wheat = 1, Alfalfa = 2, Reed = 3, Leaf = 4, Twig = 5, Branch = 6, Trunk = 7 }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Drag
    {
        public uint StructSize;
        public float Length, Width, Rigidity, DragCoefficient, AirDensity, VogelExponent, VogelSpeed, MaxBend;
        public static Drag Default() { return Native.Filled<Drag>(windrow_drag_init); }
        [DllImport(Native.Library)] private static extern int windrow_drag_init(out Drag it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct PlantVertex
    {
        public Vec3 Position, Normal, Tangent;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct BladeSettings
    {
        public uint StructSize, Reserved;
        public IntPtr Stalk;
        public float LengthSpread, Width, TipWidth, Taper, AlongWind, StiffnessSpread, RestBend, RestBendSpread,
            RestCurve, ViewBend, Twist;
        public uint Reserved2;
        public static BladeSettings Default() { return Native.Filled<BladeSettings>(windrow_blade_settings_init); }
        [DllImport(Native.Library)] private static extern int windrow_blade_settings_init(out BladeSettings it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct ShellSettings
    {
        public uint StructSize;
        public int Shells, ReachesTip;
        public float Length, Spacing, Bias, Push, PushExponent, Droop, DroopShape, Sag;
        public Vec3 Down;
        public IntPtr Strand;
        public static ShellSettings Default() { return Native.Filled<ShellSettings>(windrow_shell_settings_init); }
        [DllImport(Native.Library)] private static extern int windrow_shell_settings_init(out ShellSettings it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Skin
    {
        public ulong Count;
        public IntPtr Positions, Normals;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct TreeClasses
    {
        public uint StructSize, Reserved;
        public IntPtr Trunk, Branch, Leaf;
        public static TreeClasses Default() { return Native.Filled<TreeClasses>(windrow_tree_classes_init); }
        [DllImport(Native.Library)] private static extern int windrow_tree_classes_init(out TreeClasses it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct TreePart
    {
        public Vec3 Root, Axis;
        public float Length, Stiffness;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct TreeBearers
    {
        public uint Trunk, Branch, Leaf;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct SpringClass
    {
        public double FrequencyHz, Damping;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct SpringStep
    {
        public double PlacePlace, PlaceVelocity, PlaceTarget, VelocityPlace, VelocityVelocity, VelocityTarget;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct FlutterClass
    {
        public double FrequencyHz;
        public float Most, Onset;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct SpringBatch
    {
        public ulong Count;
        public IntPtr Place, Velocity, TargetBefore, TargetNow, PlaceRemainder, VelocityRemainder, PlacePrevious;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct CascadeBatch
    {
        public ulong Rows;
        public IntPtr Value, BodyBefore, BodyNow, Remainder;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Pose
    {
        public DVec3 Position;
        public DVec4 Rotation;
        public double Scale;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct CascadeConfig
    {
        public uint StructSize;
        public int Stages;
        public double Lag;
        public static CascadeConfig Default() { return Native.Filled<CascadeConfig>(windrow_cascade_config_init); }
        [DllImport(Native.Library)] private static extern int windrow_cascade_config_init(out CascadeConfig it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct GroundConfig
    {
        public uint StructSize;
        public int Texels;
        public SpringClass Spring;
        public float TexelSize, Push, TrailFraction, TrailTime, TrampleTime, Clearance, BlendWidth, JumpSpeed;
        public int MaxWalkers;
        public uint Reserved;
        public static GroundConfig Default() { return Native.Filled<GroundConfig>(windrow_ground_config_init); }
        [DllImport(Native.Library)] private static extern int windrow_ground_config_init(out GroundConfig it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct GroundWalker
    {
        public DVec3 Position, Previous;
        public float FootHeight, PreviousFootHeight, Radius, Weight;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct GroundStep
    {
        public uint StructSize;
        public Vec2 WindLean;
        public uint Reserved;
        public double Duration;
        public ulong WalkerCount;
        public IntPtr Walkers;
        public static GroundStep Default() { return Native.Filled<GroundStep>(windrow_ground_step_init); }
        [DllImport(Native.Library)] private static extern int windrow_ground_step_init(out GroundStep it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct GroundSample
    {
        public Vec2 Lean;
        public float Trample, Trail;
    }

    public static partial class Calls
    {
        [DllImport(Native.Library)]
        public static extern Result windrow_drag_init(IntPtr drag, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_drag_of(Plant plant, IntPtr drag);
        [DllImport(Native.Library)]
        public static extern Result windrow_drag_validate(IntPtr drag);
        [DllImport(Native.Library)]
        public static extern Result windrow_drag_block_of(IntPtr drag, IntPtr block);
        [DllImport(Native.Library)]
        public static extern Result windrow_cauchy_number(IntPtr drag, double speed, IntPtr number);
        [DllImport(Native.Library)]
        public static extern Result windrow_bend_angle(IntPtr drag, float speed, IntPtr angle);
        [DllImport(Native.Library)]
        public static extern float windrow_rectangle_rigidity(float young, float width, float thickness);
        [DllImport(Native.Library)]
        public static extern float windrow_folded_rigidity(float young, float width, float thickness, float depth);
        [DllImport(Native.Library)]
        public static extern float windrow_rod_rigidity(float young, float diameter);
        [DllImport(Native.Library)]
        public static extern float windrow_tube_rigidity(float young, float outer_diameter, float inner_diameter);
        [DllImport(Native.Library)]
        public static extern UVec2 windrow_place_key(float x, float z);
        [DllImport(Native.Library)]
        public static extern float windrow_plant_yaw(UVec2 key);
        [DllImport(Native.Library)]
        public static extern float windrow_plant_stiffness(UVec2 key, float spread);
        [DllImport(Native.Library)]
        public static extern Result windrow_blade_settings_init(IntPtr settings, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_blades_create(IntPtr settings, IntPtr blades);
        [DllImport(Native.Library)]
        public static extern void windrow_blades_destroy(IntPtr blades);
        [DllImport(Native.Library)]
        public static extern Result windrow_blades_block(IntPtr blades, IntPtr block);
        [DllImport(Native.Library)]
        public static extern float windrow_blades_length(IntPtr blades, UVec2 key);
        [DllImport(Native.Library)]
        public static extern Vec3 windrow_blades_load(IntPtr blades, UVec2 key, Vec3 wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_blades_vertex(IntPtr blades, UVec2 key, Vec3 load, float h, float side,
            Vec3 view, IntPtr vertex);
        [DllImport(Native.Library)]
        public static extern Result windrow_blades_loads(IntPtr blades, ulong count, IntPtr keys, IntPtr winds,
            IntPtr loads, IntPtr parallel_for);
        [DllImport(Native.Library)]
        public static extern Result windrow_blades_vertices(IntPtr blades, ulong count, IntPtr keys, IntPtr roots,
            IntPtr loads, ulong rows, IntPtr heights, Vec3 view, IntPtr positions, IntPtr normals, IntPtr parallel_for);
        [DllImport(Native.Library)]
        public static extern Result windrow_shell_settings_init(IntPtr settings, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_shells_create(IntPtr settings, IntPtr shells);
        [DllImport(Native.Library)]
        public static extern void windrow_shells_destroy(IntPtr shells);
        [DllImport(Native.Library)]
        public static extern Result windrow_shells_block(IntPtr shells, IntPtr block);
        [DllImport(Native.Library)]
        public static extern float windrow_shells_height(IntPtr shells, int shell);
        [DllImport(Native.Library)]
        public static extern Vec3 windrow_shells_load(IntPtr shells, Vec3 normal, float map, Vec3 wind);
        [DllImport(Native.Library)]
        public static extern Vec3 windrow_shells_bent(IntPtr shells, Vec3 position, Vec3 normal, float h, float map,
            Vec3 load);
        [DllImport(Native.Library)]
        public static extern Vec3 windrow_shells_translated(IntPtr shells, Vec3 position, Vec3 normal, float h,
            float map, Vec3 direction);
        [DllImport(Native.Library)]
        public static extern Result windrow_shells_loads_many(IntPtr shells, IntPtr skin, IntPtr winds, IntPtr loads,
            IntPtr parallel_for);
        [DllImport(Native.Library)]
        public static extern Result windrow_shells_bent_many(IntPtr shells, IntPtr skin, float h, IntPtr loads,
            IntPtr positions, IntPtr parallel_for);
        [DllImport(Native.Library)]
        public static extern Result windrow_shells_translated_many(IntPtr shells, IntPtr skin, float h,
            IntPtr directions, IntPtr positions, IntPtr parallel_for);
        [DllImport(Native.Library)]
        public static extern Result windrow_tree_classes_init(IntPtr classes, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_tree_create(IntPtr classes, IntPtr tree);
        [DllImport(Native.Library)]
        public static extern void windrow_tree_destroy(IntPtr tree);
        [DllImport(Native.Library)]
        public static extern Result windrow_tree_block_of(IntPtr tree, IntPtr block);
        [DllImport(Native.Library)]
        public static extern Result windrow_tree_vertex(IntPtr tree, IntPtr trunk, IntPtr branch, IntPtr leaf,
            Vec3 wind, IntPtr rest, IntPtr bent);
        [DllImport(Native.Library)]
        public static extern Result windrow_tree_vertices(IntPtr tree, ulong part_count, IntPtr parts, IntPtr winds,
            ulong count, IntPtr rest_positions, IntPtr rest_normals, IntPtr bearers, IntPtr positions, IntPtr normals,
            IntPtr parallel_for);
        [DllImport(Native.Library)]
        public static extern Result windrow_spring_class_of(SpringPlant plant, IntPtr spring);
        [DllImport(Native.Library)]
        public static extern Result windrow_spring_step_make(IntPtr spring, double duration, IntPtr step);
        [DllImport(Native.Library)]
        public static extern Result windrow_spring_step_block(IntPtr step, IntPtr block);
        [DllImport(Native.Library)]
        public static extern Result windrow_swing_step_make(IntPtr spring, double duration, IntPtr block);
        [DllImport(Native.Library)]
        public static extern Result windrow_spring_bands(IntPtr spring, IntPtr bands);
        [DllImport(Native.Library)]
        public static extern Result windrow_swing_steps_make(IntPtr spring, double duration, IntPtr blocks);
        [DllImport(Native.Library)]
        public static extern Result windrow_flutter_step_make(IntPtr flutter, double time, double duration, IntPtr block);
        [DllImport(Native.Library)]
        public static extern Result windrow_springs_advance_float(IntPtr step, IntPtr batch, IntPtr parallel_for);
        [DllImport(Native.Library)]
        public static extern Result windrow_springs_advance_double(IntPtr step, IntPtr batch, IntPtr parallel_for);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascade_step_create(int stages, IntPtr step);
        [DllImport(Native.Library)]
        public static extern void windrow_cascade_step_destroy(IntPtr step);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascade_step_set(IntPtr step, double rate, double duration);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascades_advance_float(IntPtr step, IntPtr batch, IntPtr parallel_for);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascades_advance_double(IntPtr step, IntPtr batch, IntPtr parallel_for);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascade_config_init(IntPtr config, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascade_create(IntPtr config, IntPtr body, IntPtr cascade);
        [DllImport(Native.Library)]
        public static extern void windrow_cascade_destroy(IntPtr cascade);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascade_save(IntPtr cascade, IntPtr bytes);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascade_load(IntPtr bytes, ulong size, IntPtr cascade);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascade_advance(IntPtr cascade, double duration, IntPtr body);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascade_reset(IntPtr cascade, IntPtr body);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascade_move(IntPtr cascade, DVec3 offset);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascade_at(IntPtr cascade, double height, IntPtr pose);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascade_previous_at(IntPtr cascade, double height, IntPtr pose);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascade_shader_poses(IntPtr cascade, DVec3 anchor, IntPtr poses,
            IntPtr count);
        [DllImport(Native.Library)]
        public static extern Result windrow_cascade_previous_shader_poses(IntPtr cascade, DVec3 anchor, IntPtr poses,
            IntPtr count);
        [DllImport(Native.Library)]
        public static extern Result windrow_ground_config_init(IntPtr config, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_ground_step_init(IntPtr step, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_ground_create(IntPtr config, IntPtr parallel_for, IntPtr ground);
        [DllImport(Native.Library)]
        public static extern void windrow_ground_destroy(IntPtr ground);
        [DllImport(Native.Library)]
        public static extern Result windrow_ground_save(IntPtr ground, IntPtr bytes);
        [DllImport(Native.Library)]
        public static extern Result windrow_ground_load(IntPtr bytes, ulong size, IntPtr parallel_for, IntPtr ground);
        [DllImport(Native.Library)]
        public static extern Result windrow_ground_follow(IntPtr ground, DVec3 point);
        [DllImport(Native.Library)]
        public static extern Result windrow_ground_shift_origin(IntPtr ground, DVec3 offset);
        [DllImport(Native.Library)]
        public static extern Result windrow_ground_advance(IntPtr ground, IntPtr step, IntPtr wind_leans, ulong count);
        [DllImport(Native.Library)]
        public static extern int windrow_ground_walkers_left_out(IntPtr ground);
        [DllImport(Native.Library)]
        public static extern DVec2 windrow_ground_next_centre(IntPtr ground, IVec2 slot);
        [DllImport(Native.Library)]
        public static extern Result windrow_ground_at(IntPtr ground, DVec3 position, IntPtr sample);
        [DllImport(Native.Library)]
        public static extern Result windrow_ground_previous_at(IntPtr ground, DVec3 position, IntPtr sample);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_ground_texels(IntPtr ground, IntPtr count);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_ground_previous_texels(IntPtr ground, IntPtr count);
        [DllImport(Native.Library)]
        public static extern Result windrow_ground_block_of(IntPtr ground, DVec3 anchor, IntPtr block);
    }
}
