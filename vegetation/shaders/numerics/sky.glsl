// A clear sky: what one scattering of sunlight in an even, plane layer of air sends down, and an estimate of the rest.
//
//   m(mu)   = 1 / (mu + 0.50572 (96.07995 - z)^-1.6364)    air mass toward a direction, z its angle from the zenith in degrees
//   tau_R   = 0.008569 l^-4 (1 + 0.0113 l^-2 + 0.00013 l^-4)   Rayleigh's optical depth of the whole air, l the wavelength [um]
//   tau_M   = beta l^-1.3                                  haze, beta Angstrom's turbidity
//   E(m_s)  = E_0 exp(-tau m_s)                            the beam at the ground
//   L(v)    = E_0 (tau_R P_R + tau_M P_M) m_v (exp(-tau m_s) - exp(-tau m_v)) / (tau (m_v - m_s)) ... of light scattered once
//
// L is the integral over the depth t of exp(-t m_s) tau P m_v exp(-(tau - t) m_v) dt / tau, with P_R = 3 (1 + cos^2) / (16 pi)
// and P_M Henyey and Greenstein's, both with integral 1; haze is taken to lie as the air does. Light scattered more than once is
// estimated: a quarter of what the beam lost, spread evenly, L_2 = E_0 mu_s (1 - exp(-tau m_s)) (1 - exp(-tau m_v)) / (4 pi),
// which is ours; both together never exceed what the beam lost (vegetation/tests/render/light_test.cpp). There is no ozone, no
// ground that shines back, no horizon that curves (the air mass is 38 there), no twilight: below the horizon the sun gives
// nothing.
// The sun's edge is 0.4 as bright as its middle (limb darkening 1 - 0.6 (1 - mu)).
// Based on: Chandrasekhar 1960, Radiative transfer (diffuse transmission, first order); Kasten & Young 1989, Revised optical air
// mass tables and approximation formula; Hansen & Travis 1974, Light scattering in planetary atmospheres, eq. 2.30; Angstrom
// 1929; Henyey & Greenstein 1941, Diffuse radiation in the galaxy.
#ifndef WINDROW_SKY_GLSL
#define WINDROW_SKY_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

struct WindrowSky {
    vec4 sun;      // xyz unit vector to the sun; w its angular radius [rad]
    vec4 rayleigh; // rgb optical depth of the air; w irradiance E_0 above it, in units of the picture
    vec4 haze;     // rgb optical depth of the haze; w asymmetry g of Henyey and Greenstein, 0 to 0.95
};

// Air mass toward a direction whose cosine from the zenith is mu; held at the horizon's below it.
WINDROW_FN float windrow_air_mass(float mu) {
    float above = clamp(mu, 0.0f, 1.0f);
    float zenith_deg = 57.29577951f * acos(above);
    return 1.0f / (above + 0.50572f * pow(96.07995f - zenith_deg, -1.6364f));
}

// Optical depth of the air at a wavelength [um].
WINDROW_FN float windrow_rayleigh_depth(float wavelength) {
    float s = 1.0f / (wavelength * wavelength);
    return 0.008569f * s * s * (1.0f + 0.0113f * s + 0.00013f * s * s);
}

// Optical depth of haze of Angstrom's turbidity beta: 0.02 very clear, 0.1 clear, 0.2 hazy.
WINDROW_FN float windrow_haze_depth(float wavelength, float beta) { return beta * pow(wavelength, -1.3f); }

WINDROW_FN float windrow_rayleigh_phase(float cosine) { return 0.0596831037f * (1.0f + cosine * cosine); }

WINDROW_FN float windrow_haze_phase(float cosine, float g) {
    float base = 1.0f + g * g - 2.0f * g * cosine;
    return 0.0795774715f * (1.0f - g * g) / (base * sqrt(base));
}

// Irradiance across the beam at the ground; 0 once the sun has set.
WINDROW_FN vec3 windrow_sun_irradiance(WindrowSky sky) {
    if (!(sky.sun.y > 0.0f))
        return vec3(0.0f);
    return sky.rayleigh.w * exp(-(vec3(sky.rayleigh) + vec3(sky.haze)) * windrow_air_mass(sky.sun.y));
}

// m_v (exp(-tau m_s) - exp(-tau m_v)) / (tau (m_v - m_s)); near m_v = m_s the quotient is its limit, exp(-tau m_s) m_v.
WINDROW_FN float windrow_scattered_fraction(float tau, float m_s, float m_v) {
    float x = tau * (m_v - m_s);
    float falling = abs(x) < 1e-3f ? 1.0f - 0.5f * x : (1.0f - exp(-x)) / x;
    return m_v * exp(-tau * m_s) * falling;
}

// Radiance of the sky in a direction, without the sun's disk; below the horizon that of the horizon.
WINDROW_FN vec3 windrow_sky_radiance(WindrowSky sky, vec3 direction) {
    if (!(sky.sun.y > 0.0f))
        return vec3(0.0f);
    float cosine = clamp(dot(direction, vec3(sky.sun)), -1.0f, 1.0f);
    float m_s = windrow_air_mass(sky.sun.y);
    float m_v = windrow_air_mass(direction.y);
    vec3 air = vec3(sky.rayleigh);
    vec3 haze = vec3(sky.haze);
    vec3 depth = air + haze;
    vec3 share = vec3(windrow_scattered_fraction(depth.x, m_s, m_v), windrow_scattered_fraction(depth.y, m_s, m_v),
                      windrow_scattered_fraction(depth.z, m_s, m_v));
    vec3 once = (air * windrow_rayleigh_phase(cosine) + haze * windrow_haze_phase(cosine, sky.haze.w)) * share;
    vec3 again = 0.0795774715f * sky.sun.y * (1.0f - exp(-depth * m_s)) * (1.0f - exp(-depth * m_v));
    return sky.rayleigh.w * (once + again);
}

// Radiance of the sun's disk in a direction, beside the sky's; its irradiance is that of the beam.
WINDROW_FN vec3 windrow_sun_radiance(WindrowSky sky, vec3 direction) {
    vec3 away = direction - vec3(sky.sun);
    float offset = sqrt(dot(away, away)) / sky.sun.w; // from the disk's middle over its radius
    if (!(offset < 1.0f))
        return vec3(0.0f);
    float limb = 1.0f - 0.6f * (1.0f - sqrt(1.0f - offset * offset));
    return windrow_sun_irradiance(sky) * (limb / (0.8f * 3.14159265f * sky.sun.w * sky.sun.w)); // 0.8 the disk's mean of limb
}

#endif
