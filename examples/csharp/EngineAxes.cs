// Axes and unit of an engine: places, velocities and axes of rotation on their way into Windrow, which is right-handed with y up in
// metres, and back.
//
//     var axes = EngineAxes.Unreal;
//     wind.Follow(axes.PointIn(place.X, place.Y, place.Z));                     // centimetres, z up, left-handed
//     var felt = axes.VelocityOut(wind.Velocity(axes.PointIn(x, y, z)));        // cm/s along Unreal's axes
using System;

namespace Windrow
{
    public sealed class EngineAxes
    {
        /// Godot: the library's own.
        public static readonly EngineAxes Godot = new EngineAxes(false, false, 1.0);
        /// Unity: y up, left-handed, metres; z is mirrored.
        public static readonly EngineAxes Unity = new EngineAxes(false, true, 1.0);
        /// Unreal Engine: z up, left-handed, centimetres; y and z change places.
        public static readonly EngineAxes Unreal = new EngineAxes(true, true, 0.01);
        /// Blender: z up, right-handed, metres.
        public static readonly EngineAxes Blender = new EngineAxes(true, false, 1.0);

        private readonly bool zUp, leftHanded;
        private readonly double metres; // of the host's unit

        public EngineAxes(bool zUp, bool leftHanded, double metres)
        {
            if (!(metres > 0.0) || double.IsInfinity(metres))
                throw new ArgumentException("metres is " + metres + ": give the length of the host's unit in metres, above 0.");
            this.zUp = zUp;
            this.leftHanded = leftHanded;
            this.metres = metres;
        }

        /// [m] A place of the host, in its unit.
        public DVec3 PointIn(double x, double y, double z) { return Turned(metres * x, metres * y, metres * z); }
        /// In the host's unit and along its axes.
        public DVec3 PointOut(DVec3 p)
        {
            var q = TurnedBack(p);
            return new DVec3(q.X / metres, q.Y / metres, q.Z / metres);
        }
        /// [m/s]
        public Vec3 VelocityIn(float x, float y, float z)
        {
            var p = PointIn(x, y, z);
            return Single(p.X, p.Y, p.Z);
        }
        public Vec3 VelocityOut(Vec3 v)
        {
            var p = PointOut(new DVec3(v.X, v.Y, v.Z));
            return Single(p.X, p.Y, p.Z);
        }
        /// An axis of rotation, of a vortex or a spin: the same screw turns the other way in a left-handed host.
        public Vec3 AxisIn(float x, float y, float z)
        {
            var p = Turned(x, y, z);
            var sign = leftHanded ? -1.0 : 1.0;
            return Single(sign * p.X, sign * p.Y, sign * p.Z);
        }

        private DVec3 Turned(double x, double y, double z)
        {
            if (!zUp)
                return new DVec3(x, y, leftHanded ? -z : z);
            return new DVec3(x, z, leftHanded ? y : -y);
        }
        private DVec3 TurnedBack(DVec3 p)
        {
            if (!zUp)
                return new DVec3(p.X, p.Y, leftHanded ? -p.Z : p.Z);
            return new DVec3(p.X, leftHanded ? p.Z : -p.Z, p.Y);
        }
        private static Vec3 Single(double x, double y, double z)
        {
            var v = new Vec3();
            v.X = (float)x;
            v.Y = (float)y;
            v.Z = (float)z;
            return v;
        }
    }
}
