// Coverage as a mask of samples, for what is cut out of cards and layers.
#ifndef WINDROW_RENDER_SAMPLE_BITS_GLSL
#define WINDROW_RENDER_SAMPLE_BITS_GLSL

// Bits of `samples` for a share of a pixel; `turn`, 0 or more, so that things behind one another do not cover the same samples.
int sample_bits(float coverage, int samples, int turn) {
    int count = int(coverage * float(samples) + 0.5);
    int bits = (1 << count) - 1;
    int shift = turn % samples;
    return ((bits << shift) | (bits >> (samples - shift))) & ((1 << samples) - 1);
}

#endif
