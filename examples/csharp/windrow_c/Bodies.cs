// Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit.
using System;
using System.Runtime.InteropServices;

namespace Windrow
{
    public enum RegionKind { Sphere = 0, Capsule = 1, Box = 2, Cone = 3 }
    public enum LawKind { Force = 0, Drive = 1 }
    public enum MotorKind { Directional = 0, Wake = 1, Jet = 2, Vortex = 3, Omni = 4, Pressure = 5 }
    public enum ShapeKind { Sphere = 0, Capsule = 1, Block = 2, Cylinder = 3, Plate = 4, Mesh = 5, Voxels = 6,
        Ground = 7 }
    public enum Beyond { Edge = 0, Nothing = 1 }
    public enum Surface { FreeSlip = 0, NoSlip = 1 }
    public enum DragKind { Plant = 0, Belt = 1 }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct MotorId
    {
        public uint Slot, Generation, Owner;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Region
    {
        public RegionKind Kind;
        public float Radius;
        public Vec3 HalfAxis, HalfSize, Axis;
        public float StartRadius, EndRadius;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Law
    {
        public LawKind Kind;
        public float Acceleration, Speed, Rate;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct WakeLaw
    {
        public LawKind Kind;
        public float Strength, PerMetre, Entrainment;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Envelope
    {
        public float Attack, Hold, Decay, Delay;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Turbulence
    {
        public float Intensity, Length;
        public uint Seed;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct DirectionalMotor
    {
        public uint StructSize;
        public Vec3 Direction;
        public DVec3 Position;
        public Region Region;
        public Law Law;
        public Envelope Envelope;
        public Turbulence Turbulence;
        public static DirectionalMotor Default() { return Native.Filled<DirectionalMotor>(windrow_directional_motor_init); }
        [DllImport(Native.Library)] private static extern int windrow_directional_motor_init(out DirectionalMotor it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct WakeMotor
    {
        public uint StructSize;
        public float Radius;
        public DVec3 Position;
        public WakeLaw Law;
        public Envelope Envelope;
        public Turbulence Turbulence;
        public uint Reserved;
        public static WakeMotor Default() { return Native.Filled<WakeMotor>(windrow_wake_motor_init); }
        [DllImport(Native.Library)] private static extern int windrow_wake_motor_init(out WakeMotor it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct JetMotor
    {
        public uint StructSize;
        public Vec3 Direction;
        public DVec3 Position;
        public float Length, StartRadius, EndRadius;
        public Law Law;
        public Envelope Envelope;
        public Turbulence Turbulence;
        public static JetMotor Default() { return Native.Filled<JetMotor>(windrow_jet_motor_init); }
        [DllImport(Native.Library)] private static extern int windrow_jet_motor_init(out JetMotor it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VortexMotor
    {
        public uint StructSize;
        public Vec3 Axis;
        public DVec3 Position;
        public float Radius, HalfLength, Lift;
        public Law Law;
        public Envelope Envelope;
        public uint Reserved;
        public static VortexMotor Default() { return Native.Filled<VortexMotor>(windrow_vortex_motor_init); }
        [DllImport(Native.Library)] private static extern int windrow_vortex_motor_init(out VortexMotor it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct OmniMotor
    {
        public uint StructSize;
        public float Radius;
        public DVec3 Position;
        public float Speed;
        public Envelope Envelope;
        public uint Reserved;
        public static OmniMotor Default() { return Native.Filled<OmniMotor>(windrow_omni_motor_init); }
        [DllImport(Native.Library)] private static extern int windrow_omni_motor_init(out OmniMotor it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct PressureMotor
    {
        public uint StructSize;
        public float Radius;
        public DVec3 Position;
        public float Speed, Duration;
        public static PressureMotor Default() { return Native.Filled<PressureMotor>(windrow_pressure_motor_init); }
        [DllImport(Native.Library)] private static extern int windrow_pressure_motor_init(out PressureMotor it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Shape
    {
        public ShapeKind Kind;
        public float Radius, HalfLength, CellSize;
        public Vec3 HalfSize, HalfAxis, Scale;
        public Beyond Beyond;
        public IntPtr Mesh, Voxels, Heights;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct Obstacle
    {
        public uint StructSize;
        public Surface Surface;
        public DVec3 Position;
        public Quat Orientation;
        public Shape Shape;
        public static Obstacle Default() { return Native.Filled<Obstacle>(windrow_obstacle_init); }
        [DllImport(Native.Library)] private static extern int windrow_obstacle_init(out Obstacle it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct ObstacleId
    {
        public uint Slot, Generation, Owner;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct ObstacleForce
    {
        public uint StructSize;
        public Vec3 Force, Moment;
        public float Pressure;
        public int InBox;
        public static ObstacleForce Default() { return Native.Filled<ObstacleForce>(windrow_obstacle_force_init); }
        [DllImport(Native.Library)] private static extern int windrow_obstacle_force_init(out ObstacleForce it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct DragId
    {
        public uint Slot, Generation, Owner;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct PlantDrag
    {
        public uint StructSize;
        public float Radius;
        public DVec3 Position;
        public float Base, Height, Area;
        public uint Reserved;
        public static PlantDrag Default() { return Native.Filled<PlantDrag>(windrow_plant_drag_init); }
        [DllImport(Native.Library)] private static extern int windrow_plant_drag_init(out PlantDrag it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct BeltDrag
    {
        public uint StructSize;
        public float Width;
        public DVec3 Start, End;
        public float Height, Resistance;
        public static BeltDrag Default() { return Native.Filled<BeltDrag>(windrow_belt_drag_init); }
        [DllImport(Native.Library)] private static extern int windrow_belt_drag_init(out BeltDrag it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct DragForce
    {
        public uint StructSize;
        public Vec3 Force;
        public float InBox;
        public static DragForce Default() { return Native.Filled<DragForce>(windrow_drag_force_init); }
        [DllImport(Native.Library)] private static extern int windrow_drag_force_init(out DragForce it, uint size);
    }

    public static partial class Calls
    {
        [DllImport(Native.Library)]
        public static extern Region windrow_region_sphere(float radius);
        [DllImport(Native.Library)]
        public static extern Region windrow_region_capsule(Vec3 half_axis, float radius);
        [DllImport(Native.Library)]
        public static extern Region windrow_region_box(Vec3 half_size);
        [DllImport(Native.Library)]
        public static extern Region windrow_region_cone(Vec3 axis, float start_radius, float end_radius);
        [DllImport(Native.Library)]
        public static extern Law windrow_law_force(float acceleration);
        [DllImport(Native.Library)]
        public static extern Law windrow_law_drive(float speed, float rate);
        [DllImport(Native.Library)]
        public static extern WakeLaw windrow_wake_law_force(float strength);
        [DllImport(Native.Library)]
        public static extern WakeLaw windrow_wake_law_drive(float per_metre, float entrainment);
        [DllImport(Native.Library)]
        public static extern Result windrow_directional_motor_init(IntPtr motor, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_wake_motor_init(IntPtr motor, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_jet_motor_init(IntPtr motor, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_vortex_motor_init(IntPtr motor, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_omni_motor_init(IntPtr motor, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_pressure_motor_init(IntPtr motor, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_add_directional(IntPtr wind, IntPtr motor, IntPtr id);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_add_wake(IntPtr wind, IntPtr motor, IntPtr id);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_add_jet(IntPtr wind, IntPtr motor, IntPtr id);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_add_vortex(IntPtr wind, IntPtr motor, IntPtr id);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_add_omni(IntPtr wind, IntPtr motor, IntPtr id);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_add_pressure(IntPtr wind, IntPtr motor, IntPtr id);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_directional(IntPtr wind, MotorId id, IntPtr motor);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_wake(IntPtr wind, MotorId id, IntPtr motor);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_jet(IntPtr wind, MotorId id, IntPtr motor);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_vortex(IntPtr wind, MotorId id, IntPtr motor);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_omni(IntPtr wind, MotorId id, IntPtr motor);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_pressure(IntPtr wind, MotorId id, IntPtr motor);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_get_directional(IntPtr wind, MotorId id, IntPtr motor);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_get_wake(IntPtr wind, MotorId id, IntPtr motor);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_get_jet(IntPtr wind, MotorId id, IntPtr motor);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_get_vortex(IntPtr wind, MotorId id, IntPtr motor);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_get_omni(IntPtr wind, MotorId id, IntPtr motor);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_get_pressure(IntPtr wind, MotorId id, IntPtr motor);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_motor_kind(IntPtr wind, MotorId id, IntPtr kind);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_move_motor(IntPtr wind, MotorId id, DVec3 position);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_remove_motor(IntPtr wind, MotorId id);
        [DllImport(Native.Library)]
        public static extern int windrow_wind_motor_count(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_mesh_create(IntPtr vertices, ulong vertex_count, IntPtr indices,
            ulong triangle_count, IntPtr mesh);
        [DllImport(Native.Library)]
        public static extern void windrow_mesh_destroy(IntPtr mesh);
        [DllImport(Native.Library)]
        public static extern Result windrow_mesh_save(IntPtr mesh, IntPtr bytes);
        [DllImport(Native.Library)]
        public static extern Result windrow_mesh_load(IntPtr bytes, ulong size, IntPtr mesh);
        [DllImport(Native.Library)]
        public static extern float windrow_mesh_distance(IntPtr mesh, Vec3 point);
        [DllImport(Native.Library)]
        public static extern Result windrow_voxels_create(IVec3 cells, IntPtr closed, ulong count, IntPtr voxels);
        [DllImport(Native.Library)]
        public static extern void windrow_voxels_destroy(IntPtr voxels);
        [DllImport(Native.Library)]
        public static extern Result windrow_height_map_create(IVec2 corners, float spacing, IntPtr heights, ulong count,
            IntPtr map);
        [DllImport(Native.Library)]
        public static extern Result windrow_height_map_create_with_holes(IVec2 corners, float spacing, IntPtr heights,
            ulong count, IVec2 cells, IntPtr open, ulong cell_count, IntPtr map);
        [DllImport(Native.Library)]
        public static extern void windrow_height_map_destroy(IntPtr map);
        [DllImport(Native.Library)]
        public static extern float windrow_height_map_height(IntPtr map, Vec2 place);
        [DllImport(Native.Library)]
        public static extern Vec3 windrow_height_map_normal(IntPtr map, Vec2 place);
        [DllImport(Native.Library)]
        public static extern Shape windrow_shape_sphere(float radius);
        [DllImport(Native.Library)]
        public static extern Shape windrow_shape_capsule(Vec3 half_axis, float radius);
        [DllImport(Native.Library)]
        public static extern Shape windrow_shape_block(Vec3 half_size);
        [DllImport(Native.Library)]
        public static extern Shape windrow_shape_cylinder(float radius, float half_length);
        [DllImport(Native.Library)]
        public static extern Shape windrow_shape_plate(Vec2 half_size);
        [DllImport(Native.Library)]
        public static extern Shape windrow_shape_mesh(IntPtr mesh, float scale);
        [DllImport(Native.Library)]
        public static extern Shape windrow_shape_voxels(IntPtr voxels, float cell_size);
        [DllImport(Native.Library)]
        public static extern Shape windrow_shape_ground(IntPtr heights, Vec3 scale);
        [DllImport(Native.Library)]
        public static extern Result windrow_obstacle_init(IntPtr obstacle, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_add_obstacle(IntPtr wind, IntPtr obstacle, IntPtr id);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_obstacle(IntPtr wind, ObstacleId id, IntPtr obstacle);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_get_obstacle(IntPtr wind, ObstacleId id, IntPtr obstacle);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_move_obstacle(IntPtr wind, ObstacleId id, DVec3 position,
            IntPtr orientation, IntPtr spin);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_remove_obstacle(IntPtr wind, ObstacleId id);
        [DllImport(Native.Library)]
        public static extern int windrow_wind_obstacle_count(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_obstacle_force_init(IntPtr force, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_force_on(IntPtr wind, ObstacleId id, IntPtr force);
        [DllImport(Native.Library)]
        public static extern Result windrow_plant_drag_init(IntPtr plant, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_belt_drag_init(IntPtr belt, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_add_plant_drag(IntPtr wind, IntPtr plant, IntPtr id);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_add_belt_drag(IntPtr wind, IntPtr belt, IntPtr id);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_add_plants(IntPtr wind, IntPtr plants, ulong count, IntPtr ids);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_plant_drag(IntPtr wind, DragId id, IntPtr plant);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_set_belt_drag(IntPtr wind, DragId id, IntPtr belt);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_get_plant_drag(IntPtr wind, DragId id, IntPtr plant);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_get_belt_drag(IntPtr wind, DragId id, IntPtr belt);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_drag_kind(IntPtr wind, DragId id, IntPtr kind);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_remove_drag(IntPtr wind, DragId id);
        [DllImport(Native.Library)]
        public static extern int windrow_wind_drag_count(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_drag_force_init(IntPtr force, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_wind_drag_force_on(IntPtr wind, DragId id, IntPtr force);
    }
}
