// Writes x + 10 y + 100 z - 1/4 into an image whose format is FORMAT.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(set = 0, binding = 0, FORMAT) writeonly uniform image3D image;

void main() {
    ivec3 at = ivec3(gl_GlobalInvocationID);
    if (all(lessThan(at, imageSize(image))))
        imageStore(image, at, vec4(float(at.x + 10 * at.y + 100 * at.z) - 0.25));
}
