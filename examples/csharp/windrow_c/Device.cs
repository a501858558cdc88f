// Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit.
using System;
using System.Runtime.InteropServices;

namespace Windrow
{
    public enum VdbForm { OneVector = 0, ThreeScalars = 1 }
    public enum VdbPrecision { Full = 0, Half = 1 }
    public enum VdbUp { Y = 0, Z = 1 }
    public enum VdbFormat { Openvdb = 0, Nanovdb = 1 }
    public enum VulkanTextureSet { Vectors = 0, Axes = 1, Both = 2 }
    public enum VulkanReadBack { None = 0, Cells = 1, Halves = 2, Box = 3, Points = 4 }
    public enum WindLeans { Everywhere = 0, EachTexel = 1 }
    public static partial class Constants
    {
        public const int VulkanMaxBindings = 8;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VdbOptions
    {
        public uint StructSize;
        public VdbForm Form;
        public IntPtr Name;
        public VdbPrecision Precision;
        public VdbUp Up;
        public double Time;
        public int Frame;
        public VdbFormat Format;
        public static VdbOptions Default() { return Native.Filled<VdbOptions>(windrow_vdb_options_init); }
        [DllImport(Native.Library)] private static extern int windrow_vdb_options_init(out VdbOptions it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VdbScalar
    {
        public IntPtr Name, Units, Values;
        public float Outside;
        public uint Reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VdbVector
    {
        public IntPtr Name, Units, Values;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VdbGrid
    {
        public uint StructSize;
        public IVec3 Cells;
        public DVec3 Origin;
        public Vec3 Outside;
        public float CellSize;
        public ulong Count;
        public IntPtr Field, Obstacle;
        public float CellHeight;
        public uint ScalarCount, VectorCount, Reserved;
        public IntPtr Scalars, Vectors;
        public static VdbGrid Default() { return Native.Filled<VdbGrid>(windrow_vdb_grid_init); }
        [DllImport(Native.Library)] private static extern int windrow_vdb_grid_init(out VdbGrid it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VdbFilm
    {
        public uint StructSize;
        public int HasRegion;
        public DVec3 Low, High;
        public double Margin;
        public float VoxelSize;
        public int Speed, Vorticity;
        public uint ScalarCount;
        public IntPtr Scalars;
        public static VdbFilm Default() { return Native.Filled<VdbFilm>(windrow_vdb_film_init); }
        [DllImport(Native.Library)] private static extern int windrow_vdb_film_init(out VdbFilm it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VulkanMemory
    {
        public ulong Memory, Offset;
        public IntPtr Mapped;
        public ulong User;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VulkanHost
    {
        public uint StructSize, QueueFamily;
        public IntPtr Instance, PhysicalDevice, Device, GetInstanceProcAddr, AllocationCallbacks;
        public ulong PipelineCache;
        public IntPtr PipelineStore, ReaderQueueFamilies;
        public uint ReaderQueueFamilyCount, ReaderStages, SharedBytes, PipelineFlags;
        public IntPtr Allocate, Release, MemoryUser, PipelineCreated, PipelineUser;
        public static VulkanHost Default() { return Native.Filled<VulkanHost>(windrow_vulkan_host_init); }
        [DllImport(Native.Library)] private static extern int windrow_vulkan_host_init(out VulkanHost it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VulkanRequirements
    {
        public uint StructSize, ApiVersion, SharedBytes, Invocations, StorageBuffers, StorageImages;
        public static VulkanRequirements Default() { return Native.Filled<VulkanRequirements>(windrow_vulkan_requirements_init); }
        [DllImport(Native.Library)] private static extern int windrow_vulkan_requirements_init(out VulkanRequirements it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VulkanDeviceFacts
    {
        public uint StructSize;
        public int Software;
        public IntPtr Name, Driver, ApiVersion, Trouble;
        public static VulkanDeviceFacts Default() { return Native.Filled<VulkanDeviceFacts>(windrow_vulkan_device_facts_init); }
        [DllImport(Native.Library)] private static extern int windrow_vulkan_device_facts_init(out VulkanDeviceFacts it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VulkanDeviceSettings
    {
        public uint StructSize;
        public int Device, Validation, GpuValidation;
        public uint Queue, QueueWithout;
        public int ComputeQueue;
        public uint ExtensionCount;
        public IntPtr Extensions, Wished, Next, GetInstanceProcAddr, OnMessage, MessageUser;
        public static VulkanDeviceSettings Default() { return Native.Filled<VulkanDeviceSettings>(windrow_vulkan_device_settings_init); }
        [DllImport(Native.Library)] private static extern int windrow_vulkan_device_settings_init(out VulkanDeviceSettings it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VulkanSettings
    {
        public uint StructSize;
        public Texel Texel;
        public VulkanTextureSet Textures;
        public int FramesInFlight, Gusts, Timestamps;
        public VulkanReadBack Queries;
        public IVec3 ReadCells;
        public int ReadPoints, Forces;
        public uint ExportTextures;
        public int Obstacles;
        public static VulkanSettings Default() { return Native.Filled<VulkanSettings>(windrow_vulkan_settings_init); }
        [DllImport(Native.Library)] private static extern int windrow_vulkan_settings_init(out VulkanSettings it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VulkanFrame
    {
        public uint StructSize;
        public int Slot;
        public double Dt;
        public IntPtr Around;
        public ulong PointCount;
        public IntPtr Points;
        public int Save;
        public uint Reserved;
        public static VulkanFrame Default() { return Native.Filled<VulkanFrame>(windrow_vulkan_frame_init); }
        [DllImport(Native.Library)] private static extern int windrow_vulkan_frame_init(out VulkanFrame it, uint size);
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VulkanTexture
    {
        public ulong Image, View;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VulkanTextures
    {
        public VulkanTexture Vectors;
        [MarshalAs(UnmanagedType.ByValArray, SizeConst = 3)] public VulkanTexture[] Axes;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VulkanExportedImage
    {
        public ulong Image, Memory, Offset, Size;
        public uint HandleType;
        public int Format;
        public uint Width, Height, Depth, Reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VulkanSetContent
    {
        public VulkanTextures Now, Before;
        public ulong Sampler, Block, BlockOffset, Tile;
    }

    [StructLayout(LayoutKind.Sequential)]
    public partial struct VulkanPass
    {
        public IntPtr Name;
        public int Dispatches;
        public uint Reserved;
        public double Us;
    }
}
