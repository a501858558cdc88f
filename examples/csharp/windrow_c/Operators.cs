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
}
