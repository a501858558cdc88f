// Prints each struct of the mirror in C#: name, size, the offset of each field.
using System;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;

internal static class Layout
{
    private static void Main()
    {
        foreach (var kind in typeof(Windrow.Config).Assembly.GetTypes())
        {
            if (!kind.IsValueType || kind.IsEnum || kind.Namespace != "Windrow")
                continue;
            var fields = kind.GetFields(BindingFlags.Public | BindingFlags.Instance).OrderBy(field => field.MetadataToken);
            Console.WriteLine(kind.Name + " " + Marshal.SizeOf(kind) + " " +
                              string.Join(" ", fields.Select(field => Marshal.OffsetOf(kind, field.Name).ToString())));
        }
    }
}
