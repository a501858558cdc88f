// One triangle over the whole picture.
#version 460
layout(location = 0) out vec2 place; // 0 to 1, from the top left

void main() {
    place = vec2((gl_VertexIndex << 1) & 2, gl_VertexIndex & 2);
    gl_Position = vec4(2.0 * place - 1.0, 0.0, 1.0);
}
