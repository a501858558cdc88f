// The weights of a blur along motion vectors: what a shutter sees that is open while things move.
//
// The shutter is open for the fraction f of a frame, half of it before the frame's time and half after. A point at y that moves by
// v [px] a frame is then seen on the streak from y - r to y + r with r = f v / 2, each place for an equal part of the time. At a
// pixel x:
//
//   covered = sum over y before x's own surface of [|x - y| <= |r_y|] dy / (2 |r_y|)          (at most 1)
//   seen    = covered colour + (1 - covered) (mean over |x - y| <= |r_x| of what is not before it)
//
// Weights of one pixel add up to 1: an even picture stays as bright, an edge that moves becomes a ramp 2 |r| wide. Each of the two
// sums has samples of its own, the first along the longest streak of the neighbourhood, the second along the pixel's own.
// Based on: McGuire, Hennessy, Bukowski, Osman 2012, A reconstruction filter for plausible motion blur (longest streak of tiles,
// weights by depth); Jimenez 2014, Next generation post processing in Call of Duty (coverage of streaks instead of cones, which
// keeps the ramp straight); Guertin, McGuire, Nowrouzezahrai 2014, A fast and stable feature-aware motion blur filter (samples
// along the pixel's own streak).
#ifndef WINDROW_MOTION_BLUR_GLSL
#define WINDROW_MOTION_BLUR_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// Nearer by this fraction of the distance is wholly before: twice a blade's distance from its neighbour, seen from some metres.
#define WINDROW_BLUR_BEFORE 0.02f
// [px] A shorter half streak is no blur: a pixel's width in all.
#define WINDROW_BLUR_LEAST 0.5f

// Half of the streak, [px]. `motion` is a motion vector (motion_vector.glsl), `size` the picture's [px], `open` the fraction f;
// `most` [px] is as far as tiles reach.
WINDROW_FN vec2 windrow_blur_streak(vec2 motion, vec2 size, float open, float most) {
    vec2 half_streak = 0.5f * open * motion * size;
    float length_px = length(half_streak);
    return length_px > most ? half_streak * (most / length_px) : half_streak;
}

// Whether a streak of this half length reaches as far, with a pixel's width from yes to no.
WINDROW_FN float windrow_blur_reaches(float half_length, float away) { return clamp(half_length - away + 0.5f, 0.0f, 1.0f); }

// Whether what is `there` [m] from the eye is before what is `here`: 0 for one surface, 1 for another one.
WINDROW_FN float windrow_blur_before(float here, float there) {
    return clamp((here - there) / (WINDROW_BLUR_BEFORE * here), 0.0f, 1.0f);
}

// Fraction of the time for which one sample's streak covers a place `away` [px] from it along a line of samples `apart` [px].
// `along` [px] is the part of its half streak along that line: an edge across the line moves as far.
WINDROW_FN float windrow_blur_covers(float along, float away, float apart) {
    if (!(along > WINDROW_BLUR_LEAST))
        return 0.0f;
    return windrow_blur_reaches(along, away) * apart / (2.0f * along);
}

#endif
