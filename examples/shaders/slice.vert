// One triangle over the whole picture, which shows 16 m x 16 m of air from above.
#version 460

layout(location = 0) out vec3 place; // [m] from the anchor

void main() {
    vec2 corner = vec2((gl_VertexIndex << 1) & 2, gl_VertexIndex & 2) * 2.0 - 1.0;
    place = 8.0 * vec3(corner.x, 0.0, corner.y);
    gl_Position = vec4(corner, 0.0, 1.0);
}
