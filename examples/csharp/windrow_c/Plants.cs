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
}
