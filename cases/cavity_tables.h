// Published velocities on the centre lines of the square cavity whose lid slides: lid y = 1, its speed 1 along x, width 1.
//
// Ghia, Ghia & Shin 1982, Journal of Computational Physics 48, tables I and II: 129 x 129 points, order 2, the tables that
// everyone compares with. Their own error is seen beside the later ones: they are 0.003 off in the middle at Re 100, and up to
// 0.018 at Re 1000. Copies of them differ by misprints; these values were compared with several copies.
// Marchi, Suero & Araki 2009, Journal of the Brazilian Society of Mechanical Sciences and Engineering 31 (Re 100): 1024 x 1024
// cells, extrapolated; rounded here to six digits, of which they claim more.
// Botella & Peyret 1998, Computers & Fluids 27 (Re 1000): a Chebyshev method with 160 modes, seven digits. Their lid slides along
// -x, so signs and x are turned.
#pragma once

#include <span>

namespace windrow::cases {

struct LinePoint {
    double place; ///< along the line, 0 to 1
    double speed; ///< over the lid's
};

struct CavityTable {
    const char* author;
    std::span<const LinePoint> vertical;   ///< u along x = 1/2, over y
    std::span<const LinePoint> horizontal; ///< v along y = 1/2, over x
};

inline constexpr LinePoint k_ghia_100_vertical[] = {
    {0.0, 0.0},         {0.0547, -0.03717}, {0.0625, -0.04192}, {0.0703, -0.04775}, {0.1016, -0.06434}, {0.1719, -0.10150},
    {0.2813, -0.15662}, {0.4531, -0.21090}, {0.5, -0.20581},    {0.6172, -0.13641}, {0.7344, 0.00332},  {0.8516, 0.23151},
    {0.9531, 0.68717},  {0.9609, 0.73722},  {0.9688, 0.78871},  {0.9766, 0.84123},  {1.0, 1.0}};
inline constexpr LinePoint k_ghia_100_horizontal[] = {
    {0.0, 0.0},         {0.0625, 0.09233},  {0.0703, 0.10091},  {0.0781, 0.10890},  {0.0938, 0.12317},  {0.1563, 0.16077},
    {0.2266, 0.17507},  {0.2344, 0.17527},  {0.5, 0.05454},     {0.8047, -0.24533}, {0.8594, -0.22445}, {0.9063, -0.16914},
    {0.9453, -0.10313}, {0.9531, -0.08864}, {0.9609, -0.07391}, {0.9688, -0.05906}, {1.0, 0.0}};
inline constexpr LinePoint k_ghia_1000_vertical[] = {
    {0.0, 0.0},         {0.0547, -0.18109}, {0.0625, -0.20196}, {0.0703, -0.22220}, {0.1016, -0.29730}, {0.1719, -0.38289},
    {0.2813, -0.27805}, {0.4531, -0.10648}, {0.5, -0.06080},    {0.6172, 0.05702},  {0.7344, 0.18719},  {0.8516, 0.33304},
    {0.9531, 0.46604},  {0.9609, 0.51117},  {0.9688, 0.57492},  {0.9766, 0.65928},  {1.0, 1.0}};
inline constexpr LinePoint k_ghia_1000_horizontal[] = {
    {0.0, 0.0},         {0.0625, 0.27485},  {0.0703, 0.29012},  {0.0781, 0.30353},  {0.0938, 0.32627},  {0.1563, 0.37095},
    {0.2266, 0.33075},  {0.2344, 0.32235},  {0.5, 0.02526},     {0.8047, -0.31966}, {0.8594, -0.42665}, {0.9063, -0.51550},
    {0.9453, -0.39188}, {0.9531, -0.33714}, {0.9609, -0.27669}, {0.9688, -0.21388}, {1.0, 0.0}};

inline constexpr LinePoint k_marchi_100_vertical[] = {
    {0.0625, -0.041975}, {0.125, -0.077125},  {0.1875, -0.109816}, {0.25, -0.141930},   {0.3125, -0.172712},
    {0.375, -0.198471},  {0.4375, -0.212962}, {0.5, -0.209149},    {0.5625, -0.182081}, {0.625, -0.131256},
    {0.6875, -0.060246}, {0.75, 0.027874},    {0.8125, 0.140425},  {0.875, 0.310557},   {0.9375, 0.597467}};
inline constexpr LinePoint k_marchi_100_horizontal[] = {
    {0.0625, 0.094808},  {0.125, 0.149243},  {0.1875, 0.174343},  {0.25, 0.179243},    {0.3125, 0.169132},
    {0.375, 0.145730},   {0.4375, 0.108776}, {0.5, 0.057537},     {0.5625, -0.007749}, {0.625, -0.084067},
    {0.6875, -0.163010}, {0.75, -0.227827},  {0.8125, -0.253769}, {0.875, -0.218691},  {0.9375, -0.123318}};
inline constexpr LinePoint k_botella_1000_vertical[] = {
    {0.0547, -0.1812881}, {0.0625, -0.2023300}, {0.0703, -0.2228955}, {0.1016, -0.3004561}, {0.1719, -0.3885691},
    {0.2813, -0.2803696}, {0.4531, -0.1081999}, {0.5, -0.0620561},    {0.6172, 0.0570178},  {0.7344, 0.1886747},
    {0.8516, 0.3372212},  {0.9531, 0.4723329},  {0.9609, 0.5169277},  {0.9688, 0.5808359},  {0.9766, 0.6644227}};
inline constexpr LinePoint k_botella_1000_horizontal[] = {
    {0.0625, 0.2807056},  {0.0703, 0.2962703},  {0.0781, 0.3099097},  {0.0938, 0.3330442},  {0.1563, 0.3769189},
    {0.2266, 0.3339924},  {0.2344, 0.3253592},  {0.5, 0.0257995},     {0.8047, -0.3202137}, {0.8594, -0.4264545},
    {0.9063, -0.5264392}, {0.9453, -0.4103754}, {0.9531, -0.3553213}, {0.9609, -0.2936869}, {0.9688, -0.2279225}};

inline constexpr CavityTable k_ghia_100{"Ghia et al.", k_ghia_100_vertical, k_ghia_100_horizontal};
inline constexpr CavityTable k_ghia_1000{"Ghia et al.", k_ghia_1000_vertical, k_ghia_1000_horizontal};
inline constexpr CavityTable k_marchi_100{"Marchi et al.", k_marchi_100_vertical, k_marchi_100_horizontal};
inline constexpr CavityTable k_botella_1000{"Botella & Peyret", k_botella_1000_vertical, k_botella_1000_horizontal};

} // namespace windrow::cases
