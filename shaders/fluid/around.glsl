// The pressure around obstacles: what conjugate gradients, preconditioned by the direct solve, keep between its passes (surface.comp).
// Before this text: Potential, Correction and Direction as `potential`, `correction`, `direction`, WINDROW_AROUND, the binding.

layout(std430, set = 0, binding = WINDROW_AROUND) WINDROW_AROUND_ACCESS buffer Around {
    WindrowAround around;
    float around_words[];
};

// phi so far: the corrections before the last one are behind the last, which is added here, where it is read.
float phi_at(int at) {
    float phi = potential[at];
    if (!has_obstacles() || around.corrections == 0)
        return phi;
    if (around.corrections > 1)
        phi += correction[at + tick.cells.x * tick.cells.y * tick.cells.z];
    if (around.alpha == 0.0f)
        return phi;
    const float along = correction[at];
    return phi + around.alpha * (around.beta == 0.0f ? along : along + around.beta * direction[at]);
}
