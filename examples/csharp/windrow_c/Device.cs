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
        public IntPtr Extensions, Wished, Next, GetInstanceProcAddr, OnMessage, MessageUser, InstanceExtensions;
        public uint InstanceExtensionCount, Reserved;
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

    public static partial class Calls
    {
        [DllImport(Native.Library)]
        public static extern int windrow_vdb_has_nanovdb();
        [DllImport(Native.Library)]
        public static extern Result windrow_vdb_options_init(IntPtr options, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_vdb_write(IntPtr wind, [MarshalAs(UnmanagedType.LPUTF8Str)] string path,
            IntPtr options);
        [DllImport(Native.Library)]
        public static extern Result windrow_vdb_write_frame(IntPtr wind,
            [MarshalAs(UnmanagedType.LPUTF8Str)] string folder, [MarshalAs(UnmanagedType.LPUTF8Str)] string prefix,
            int digits, int frame, double time, IntPtr options);
        [DllImport(Native.Library)]
        public static extern Result windrow_vdb_grid_init(IntPtr grid, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_vdb_write_grid(IntPtr grid,
            [MarshalAs(UnmanagedType.LPUTF8Str)] string path, IntPtr options);
        [DllImport(Native.Library)]
        public static extern Result windrow_vdb_film_init(IntPtr film, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_vdb_write_film(IntPtr wind, IntPtr film,
            [MarshalAs(UnmanagedType.LPUTF8Str)] string path, IntPtr options);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_host_init(IntPtr host, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_requirements_init(IntPtr requirements, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_require_features(IntPtr features);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_check(IntPtr instance, IntPtr physical_device,
            IntPtr get_instance_proc_addr);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_vulkan_result_name(int result);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_pipeline_store_create(IntPtr host, IntPtr store);
        [DllImport(Native.Library)]
        public static extern void windrow_vulkan_pipeline_store_destroy(IntPtr store);
        [DllImport(Native.Library)]
        public static extern ulong windrow_vulkan_pipeline_store_count(IntPtr store);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_device_facts_init(IntPtr facts, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_device_list_create(IntPtr list);
        [DllImport(Native.Library)]
        public static extern void windrow_vulkan_device_list_destroy(IntPtr list);
        [DllImport(Native.Library)]
        public static extern int windrow_vulkan_device_list_count(IntPtr list);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_device_list_get(IntPtr list, int index, IntPtr facts);
        [DllImport(Native.Library)]
        public static extern int windrow_vulkan_has_validation_layer();
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_device_settings_init(IntPtr settings, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_device_create(IntPtr settings, IntPtr device);
        [DllImport(Native.Library)]
        public static extern void windrow_vulkan_device_destroy(IntPtr device);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_device_host(IntPtr device, int compute, IntPtr host);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_vulkan_device_queue(IntPtr device, int compute);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_device_get_facts(IntPtr device, IntPtr facts);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_vulkan_device_features(IntPtr device);
        [DllImport(Native.Library)]
        public static extern int windrow_vulkan_device_messages(IntPtr device);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_device_run(IntPtr device, IntPtr record, IntPtr user);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_device_submit(IntPtr device, int slot, IntPtr record, IntPtr user);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_device_wait(IntPtr device);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_settings_init(IntPtr settings, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_frame_init(IntPtr frame, uint struct_size);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_required_bytes(IntPtr host, IntPtr config, IntPtr settings,
            IntPtr memory, IntPtr reserved);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_required_bytes_inside(IntPtr host, IntPtr config,
            IntPtr settings, IntPtr outer, IntPtr memory, IntPtr reserved);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_create(IntPtr host, IntPtr config, IntPtr settings, IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_create_inside(IntPtr host, IntPtr config, IntPtr settings,
            IntPtr outer, IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_load(IntPtr host, IntPtr bytes, ulong size, IntPtr settings,
            IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_load_inside(IntPtr host, IntPtr bytes, ulong size,
            IntPtr settings, IntPtr outer, IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_saved(IntPtr wind, IntPtr bytes);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_record(IntPtr wind, IntPtr commands, IntPtr frame,
            IntPtr advance, IntPtr last);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_record_step(IntPtr wind, IntPtr commands, IntPtr frame,
            IntPtr diagnostics);
        [DllImport(Native.Library)]
        public static extern int windrow_vulkan_wind_collect(IntPtr wind, int slot);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_forget(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_replay(IntPtr log, IntPtr wind, IntPtr run, IntPtr user);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_textures(IntPtr wind, Frame frame, IntPtr textures);
        [DllImport(Native.Library)]
        public static extern ulong windrow_vulkan_wind_gust_buffer(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_exported_images(IntPtr wind, IntPtr images, IntPtr count);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_sampler_info(IntPtr boundaries, IntPtr sampler_info);
        [DllImport(Native.Library)]
        public static extern uint windrow_vulkan_set_bindings(VulkanTextureSet textures, uint stages, uint first,
            IntPtr bindings);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_set_writes_create(ulong set, IntPtr content,
            VulkanTextureSet textures, uint first, IntPtr writes);
        [DllImport(Native.Library)]
        public static extern void windrow_vulkan_set_writes_destroy(IntPtr writes);
        [DllImport(Native.Library)]
        public static extern IntPtr windrow_vulkan_set_writes_data(IntPtr writes);
        [DllImport(Native.Library)]
        public static extern uint windrow_vulkan_set_writes_count(IntPtr writes);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_halves(IntPtr wind, IntPtr cells, IntPtr count, IntPtr origin);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_points(IntPtr wind, IntPtr positions, IntPtr velocities,
            IntPtr count);
        [DllImport(Native.Library)]
        public static extern double windrow_vulkan_wind_query_age(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_reported(IntPtr wind, IntPtr diagnostics);
        [DllImport(Native.Library)]
        public static extern int windrow_vulkan_wind_dispatches(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern int windrow_vulkan_wind_barriers(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern ulong windrow_vulkan_wind_reserved_bytes(IntPtr wind);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_wind_pass_times(IntPtr wind, IntPtr whole_us, IntPtr read_back_us,
            IntPtr untimed, IntPtr passes, IntPtr count);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_ground_create(IntPtr host, IntPtr config, Texel texel, IntPtr ground);
        [DllImport(Native.Library)]
        public static extern void windrow_vulkan_ground_destroy(IntPtr ground);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_ground_follow(IntPtr ground, DVec3 point);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_ground_shift_origin(IntPtr ground, DVec3 offset);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_ground_record(IntPtr ground, IntPtr commands, IntPtr step,
            WindLeans leans);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_ground_record_save(IntPtr ground, IntPtr commands);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_ground_saved(IntPtr ground, IntPtr bytes);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_ground_load(IntPtr host, IntPtr bytes, ulong size, Texel texel,
            IntPtr ground);
        [DllImport(Native.Library)]
        public static extern ulong windrow_vulkan_ground_lean_buffer(IntPtr ground);
        [DllImport(Native.Library)]
        public static extern int windrow_vulkan_ground_walkers_left_out(IntPtr ground);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_ground_next_place(IntPtr ground, DVec3 anchor, IntPtr place);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_ground_texture(IntPtr ground, Frame frame, IntPtr texture);
        [DllImport(Native.Library)]
        public static extern Result windrow_vulkan_ground_block(IntPtr ground, DVec3 anchor, IntPtr block);
        [DllImport(Native.Library)]
        public static extern ulong windrow_vulkan_ground_memory_bytes(IntPtr ground);
        [DllImport(Native.Library)]
        public static extern ulong windrow_vulkan_ground_reserved_bytes(IntPtr ground);
    }
}
